/** Nobody gets in: the policies of the built pages, and known payloads through everything that takes something from outside. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { CspEvaluator } from "csp_evaluator/dist/evaluator.js";
import { Severity } from "csp_evaluator/dist/finding.js";
import { CspParser } from "csp_evaluator/dist/parser.js";
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, inject, it } from "vitest";
import { site } from "../../tools/paths.mjs";
import { launchChromium } from "./chromium.ts";
import { settled, type, visitUnpainted } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

const pages = readdirSync(site).filter((name) => name.endsWith(".html"));

/** What a built page says of itself. */
function pageNamed(name: string) {
  const html = readFileSync(join(site, name), "utf8");
  const policy = /http-equiv="Content-Security-Policy"\s+content="([^"]+)"/.exec(html)?.[1] ?? "";
  return { html, policy };
}

describe.each(pages)("the built %s", (name) => {
  const { html, policy } = pageNamed(name);

  it("has a policy in which a checker of others finds nothing to complain of", () => {
    const findings = new CspEvaluator(new CspParser(policy).csp).evaluate();
    const bad = findings.filter(({ severity }) => severity < Severity.STRICT_CSP);
    console.log(
      `${name}: ${findings.map(({ severity, description }) => `${severity} ${description}`).join(" | ")}`,
    );
    expect(bad.map(({ directive, value, description }) => [directive, value, description])).toEqual([]);
  });

  it("forbids everything first, and allows no inline script or style, no eval and no other host", () => {
    expect(policy).toMatch(/^default-src 'none';/);
    expect(policy).not.toMatch(/'unsafe-inline'|'unsafe-eval'|https?:|\*/);
    expect(policy).toContain("require-trusted-types-for 'script'");
    expect(policy).toContain("base-uri 'none'");
    for (const [script] of html.matchAll(/<script\b[^>]*>/g)) expect(script).toContain("src=");
    expect(html).not.toMatch(/<style|\sstyle=|\son\w+=/);
  });
});

it("Trusted Types, eval and foreign workers: the page lets nothing of the kind happen", async () => {
  const { page } = await visitUnpainted(browser);
  const refused = await page.evaluate(async () => {
    const attempt = (work: () => unknown) => {
      try {
        work();
        return "done";
      } catch (error) {
        return (error as Error).name;
      }
    };
    // In a task of the page's own: what a debugger runs is exempt.
    await new Promise((resolve) => setTimeout(resolve));
    return {
      markup: attempt(() => {
        document.body.innerHTML += "<img src=x onerror=alert(1)>";
      }),
      // biome-ignore lint/security/noGlobalEval: that it is refused is what is tested
      evaluated: attempt(() => globalThis.eval("1")),
      worker: attempt(() => new Worker("https://example.org/worker.js")),
      policy: attempt(() =>
        (
          globalThis as unknown as { trustedTypes: { createPolicy(name: string, policy: object): void } }
        ).trustedTypes.createPolicy("another", {}),
      ),
    };
  });
  expect(refused).toMatchObject({ markup: "TypeError", worker: "TypeError", policy: "TypeError" });
  expect(refused.evaluated).toMatch(/^(Eval|Type)Error$/);
  await page.context().close();
});

const payloads = [
  "<script>window.pwned=1</script>",
  "<img src=x onerror=window.pwned=1>",
  "'\"><svg/onload=window.pwned=1>",
  "javascript:window.pwned=1",
  "data:text/html,<script>window.pwned=1</script>",
  // biome-ignore lint/suspicious/noTemplateCurlyInString: a payload for those who take texts for templates
  "${window.pwned=1}",
  "{{constructor.constructor('window.pwned=1')()}}",
  "__proto__",
  "constructor",
  "</textarea><script>window.pwned=1</script>",
  "%3Cscript%3Ewindow.pwned=1%3C/script%3E",
  "\u0000\u202e\ufeff",
];

/** What came of a payload: whether anything ran, and what stands on the page that nobody of us put there. */
function traces(page: Page) {
  return page.evaluate(() => ({
    ran: "pwned" in window || "pwned" in {},
    planted: document.querySelectorAll("img[src='x'], svg[onload], body script, [href^='javascript:']")
      .length,
  }));
}

describe("a link", () => {
  it("with a payload for every key opens the page, runs nothing and plants nothing", {
    timeout: 180_000,
  }, async () => {
    const { page, problems } = await visitUnpainted(browser);
    const keys = [
      "preset",
      "step",
      "view",
      "color",
      "theme",
      "n",
      "g",
      "tf",
      "b",
      "lang",
      "ui",
      "pin",
      "__proto__",
      "constructor",
    ];
    for (let turn = 0; turn < 4; turn++) {
      // Every key has another payload in every turn.
      const payload = (key: number) => encodeURIComponent(payloads[(key + 3 * turn) % payloads.length] ?? "");
      const query = keys.map((key, index) => `${key}=${payload(index)}`).join("&");
      await page.goto(`${inject("site")}?${query}&${payload(5)}=1#${payload(7)}`);
      await settled(page);
      expect(await traces(page), query).toEqual({ ran: false, planted: 0 });
    }
    expect(problems).toEqual([]);
    await page.context().close();
  });
});

describe("a box of the form", () => {
  it("takes payloads for what they are: no numbers", async () => {
    const { page, problems } = await visitUnpainted(browser);
    for (const payload of payloads) {
      await type(page, /^Gravity/, payload);
      expect(await traces(page), payload).toEqual({ ran: false, planted: 0 });
    }
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("and the title of the embed dialog goes into the snippet as text", async () => {
    const { page } = await visitUnpainted(browser);
    await page.getByRole("button", { name: "Embed" }).click();
    for (const payload of payloads) {
      await page.getByRole("textbox", { name: /^Title/ }).fill(payload);
      const snippet = await page.locator("textarea").inputValue();
      const parsed = await page.evaluate((html) => {
        const policy = (
          globalThis as unknown as {
            trustedTypes: { defaultPolicy: object | null };
          }
        ).trustedTypes;
        return policy.defaultPolicy !== null && html.split("<").length;
      }, snippet);
      // An iframe, a paragraph and a link, each opened and closed: no tag of the payload's.
      expect(parsed, snippet).toBe(7);
    }
    expect(await traces(page)).toEqual({ ran: false, planted: 0 });
    await page.context().close();
  });
});

describe("messages", () => {
  it("of any kind to the page for frames run nothing and plant nothing; it goes on answering", async () => {
    const page = await browser.newPage();
    await page.setContent(
      `<iframe src="${inject("site")}embed.html?preset=figure-13a" width="400" height="300"></iframe>`,
    );
    const frame = page.frames().at(-1);
    await frame?.locator("bough-plant canvas").first().waitFor();
    const answers = await page.evaluate(async (texts) => {
      const answers: string[] = [];
      const after: string[] = [];
      addEventListener("message", ({ data }) => (data?.id === "after" ? after : answers).push(data?.type));
      const frame = document.querySelector("iframe")?.contentWindow;
      const send = (message: unknown) => frame?.postMessage(message, "*");
      const values = [
        ...texts,
        null,
        5,
        [],
        new Date(),
        new Map([["bough", 1]]),
        new ArrayBuffer(8),
        "x".repeat(1e6),
      ];
      for (const value of values) {
        send(value);
        send({ bough: 1, type: value });
        send({ bough: 1, type: "set", params: value, preset: value, link: value, theme: value });
        send({ bough: 1, id: value, type: "get" });
        send(
          JSON.parse(
            '{"bough": 1, "type": "set", "__proto__": {"pwned": 1}, "params": {"__proto__": {"pwned": 1}}}',
          ),
        );
      }
      // A hundred tabs' worth of them in one go.
      for (let tab = 0; tab < 5000; tab++) send({ bough: 1, type: "get", id: tab });
      await new Promise((resolve) => setTimeout(resolve, 1500));
      // The frame listens again a second after it has taken the last of the flood, which a busy machine does late.
      for (let ask = 0; ask < 20 && after.length === 0; ask++) {
        send({ bough: 1, type: "get", id: "after" });
        await new Promise((resolve) => setTimeout(resolve, 1000));
      }
      return {
        errors: answers.filter((type) => type === "error").length,
        all: answers.length,
        after,
      };
    }, payloads);
    expect(answers.errors, "what is wrong is said").toBeGreaterThan(0);
    expect(answers.all, "a flood is not answered message by message").toBeLessThan(500);
    expect(answers.after, "and the next question is").toContain("state");
    const planted = await frame?.evaluate(() => ({
      ran: "pwned" in window || "pwned" in {},
      planted: document.querySelectorAll("img[src='x'], svg[onload], body script").length,
    }));
    expect(planted).toEqual({ ran: false, planted: 0 });
    await page.close();
  });
});

it("asks nobody for anything while it is used, but for its own files", async () => {
  const { page, problems } = await visitUnpainted(browser);
  const asked: string[] = [];
  page.on("request", (request) =>
    asked.push(`${request.method()} ${request.url()} ${request.postData() ?? ""}`),
  );
  await type(page, /^Gravity/, "4");
  for (const name of ["Embed", "Keys"]) {
    await page.getByRole("button", { name, exact: true }).click();
    await page.locator("dialog[open]").waitFor();
    await page.keyboard.press("Escape");
    await page.locator("dialog[open]").waitFor({ state: "detached" });
  }
  await page.keyboard.press("v");
  await settled(page);
  const own = new RegExp(`^GET ${inject("site")}((assets|presets)/[\\w.-]+|favicon.svg) $`);
  expect(asked.filter((request) => !own.test(request))).toEqual([]);
  expect(problems).toEqual([]);
  await page.context().close();
});
