/** What a person does in the study, and reads there. */
import type { Page } from "playwright";
import { settled } from "./visit.ts";

/** Opens a part of the study, which comes after the plant. */
export async function open(page: Page, name: "why" | "compare" | "measure"): Promise<void> {
  await page.locator(`details.${name} > summary`).click();
  await settled(page);
}

/** A length as the page writes it, in m. */
export function meters(text: string): number {
  const [, number = "", unit = ""] = /([−+]?[\d.]+) (µm|mm|cm|m)\b/.exec(text) ?? [];
  return Number(number.replace("−", "-")) * ({ µm: 1e-6, mm: 1e-3, cm: 1e-2, m: 1 }[unit] ?? Number.NaN);
}
