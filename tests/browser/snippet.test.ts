/** The dialog that makes the snippet for another page. */
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, inject, it } from "vitest";
import { launchChromium } from "./chromium.ts";
import { visit } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

const snippetOf = (page: Page) => page.getByRole("textbox", { name: /^(Paste|Put) this/ }).inputValue();

async function open(query = "") {
  const visited = await visit(browser, query);
  await visited.page.getByRole("button", { name: "Embed" }).click();
  const dialog = visited.page.getByRole("dialog", { name: "Embed" });
  await dialog.waitFor();
  return { ...visited, dialog };
}

describe("the Embed dialog", () => {
  it("makes a frame of what is shown, follows every wish, and copies it", async () => {
    const { page, dialog, problems } = await open("?preset=figure-13c&g=3&color=moment");
    const site = inject("site");
    expect(await snippetOf(page)).toBe(
      `<iframe src="${site}embed.html?v=1&amp;preset=figure-13c&amp;g=3&amp;color=moment&amp;ui=compact" width="640" height="420" title="A tropism against gravity, full grown" allowfullscreen loading="lazy"></iframe>\n` +
        `<p><a href="${site}?v=1&amp;preset=figure-13c&amp;g=3&amp;color=moment">A tropism against gravity, full grown</a></p>`,
    );
    await dialog.getByRole("radio", { name: "Large" }).check();
    await dialog.getByRole("radio", { name: "Dark" }).check();
    await dialog.getByRole("radio", { name: "None" }).check();
    await dialog.getByRole("textbox", { name: /^Title/ }).fill(`Lunar "branch" <b>`);
    const wished = await snippetOf(page);
    expect(wished).toContain('theme=dark&amp;ui=none" width="960" height="600"');
    expect(wished).toContain("Lunar");
    expect(wished).not.toContain("<b>");
    await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
    await dialog.getByRole("button", { name: "Copy" }).click();
    await dialog.getByText("Copied.").waitFor();
    expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(wished);
    expect(await dialog.getByRole("link", { name: "Open it by itself" }).getAttribute("href")).toContain(
      "ui=none",
    );
    // It concerns another page: this one stays as it was.
    await page.keyboard.press("Escape");
    expect(new URL(page.url()).searchParams.has("theme")).toBe(false);
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("takes any size that can be one, and says what is wrong with others", async () => {
    const { page, dialog } = await open();
    const width = dialog.getByRole("textbox", { name: "Width" });
    await width.fill("800");
    expect(await snippetOf(page)).toContain('width="800" height="420"');
    expect(await dialog.getByRole("radio", { name: "Medium" }).isChecked()).toBe(false);
    for (const text of ["", "80", "1e3", "-5", "12.5", "wide", "99999"]) {
      await width.fill(text);
      expect(await dialog.getByRole("alert").innerText()).toBe(
        "Width must be a whole number from 120 to 4000.",
      );
      expect(await width.getAttribute("aria-invalid")).toBe("true");
      expect(await snippetOf(page)).toContain('width="800" height="420"');
    }
    await dialog.getByRole("radio", { name: "Small" }).check();
    expect(await dialog.getByRole("alert").count()).toBe(0);
    expect(await snippetOf(page)).toContain('width="480" height="320"');
    await page.context().close();
  });

  it("makes the element for one's own page, with a picture to go with it", async () => {
    const { page, dialog, problems } = await open("?preset=figure-8b&g=3");
    await dialog.getByRole("radio", { name: "For your own page" }).check();
    const plain = await snippetOf(page);
    expect(plain).toContain(`<bough-plant preset="figure-8b" params='{"loads":{"gravity":3}}'`);
    expect(plain).not.toContain("poster=");
    await dialog.getByRole("checkbox", { name: "A picture until it is touched" }).check();
    expect(await snippetOf(page)).toContain('poster="plant.webp"');
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      dialog.getByRole("button", { name: "Save plant.webp" }).click(),
    ]);
    expect(download.suggestedFilename()).toBe("plant.webp");
    const stream = await download.createReadStream();
    const chunks: Buffer[] = [];
    for await (const chunk of stream) chunks.push(chunk as Buffer);
    // It is a picture, and not an empty one.
    const file = Buffer.concat(chunks);
    expect(file.subarray(8, 12).toString("latin1")).toBe("WEBP");
    expect(file.length).toBeGreaterThan(3000);
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("selects the text where copying is not allowed", async () => {
    const { page, dialog } = await open();
    await page.evaluate(() => {
      Object.defineProperty(navigator, "clipboard", { value: undefined });
    });
    await dialog.getByRole("button", { name: "Copy" }).click();
    await dialog.getByText("the text is selected").waitFor();
    const selected = await page.evaluate(() => {
      const box = document.activeElement as HTMLTextAreaElement;
      return box.value.slice(box.selectionStart, box.selectionEnd);
    });
    expect(selected).toBe(await snippetOf(page));
    await page.context().close();
  });

  it("its frame shows the very plant in a host page", async () => {
    const { page, dialog, problems } = await open("?preset=figure-13c&theme=light");
    const frame = await snippetOf(page);
    expect(await dialog.count()).toBe(1);
    const host = await page.context().newPage();
    await host.setContent(`<h1>A course</h1>${frame}`);
    const inside = host.frameLocator("iframe");
    await inside.locator("bough-plant").waitFor();
    await host.locator("iframe").scrollIntoViewIfNeeded();
    await inside.locator("canvas").first().waitFor();
    expect(problems).toEqual([]);
    await page.context().close();
  });
});
