// The contact sheets: every figure with its number and title, grouped as in the paper; and the plants that one knows.

/**
 * @param {import("playwright").Browser} browser
 * @param {readonly import("../figures.mjs").Figure[]} figures
 * @param {string} heading HTML
 * @returns {Promise<Buffer>} PNG
 */
export async function makeSheet(browser, figures, heading) {
  const page = await browser.newPage({ viewport: { width: 1600, height: 100 } });
  await page.setContent(sheet(figures, heading));
  const images = page.locator("img");
  await images.evaluateAll((all) => Promise.all(all.map((image) => /** @type {any} */ (image).decode())));
  const image = await page.screenshot({ fullPage: true });
  await page.close();
  return image;
}

/**
 * @param {readonly import("../figures.mjs").Figure[]} figures
 * @param {string} heading
 */
function sheet(figures, heading) {
  const numbers = [...new Set(figures.map(({ id }) => numberOf(id)))];
  const groups = numbers.map((number) => group(figures.filter(({ id }) => numberOf(id) === number)));
  return `<!doctype html><meta charset="utf-8"><style>${style}</style>
    <h1>${heading}</h1>
    <main>${groups.join("")}</main>`;
}

/** @param {readonly import("../figures.mjs").Figure[]} figures */
function group(figures) {
  const plates = figures.map(
    ({ id, title, plate }) => `<figure>
      <img src="data:image/png;base64,${plate.toString("base64")}" alt="">
      <figcaption><b>${nameOf(id)}</b> ${title}</figcaption>
    </figure>`,
  );
  return `<section>${plates.join("")}</section>`;
}

const style = `
  body { margin: 28px 26px 18px; background: #fbfaf6; color: #2c2a26; font: 15px/1.3 "DejaVu Sans", sans-serif; }
  h1 { margin: 0 8px 22px; font: 24px "DejaVu Serif", serif; }
  main { display: flex; flex-wrap: wrap; gap: 22px 0; }
  section { display: flex; border-top: 1px solid #d5d0c2; }
  figure { width: 309px; margin: 0; }
  img { display: block; width: 300px; height: 225px; margin: 6px auto 0; }
  figcaption { padding: 0 14px 0 8px; min-height: 2.6em; }
`;

/** @param {string} id "figure-8a" */
function numberOf(id) {
  return id.replace(/^figure-(\d+).*$/, "$1");
}

/** @param {string} id "figure-8a" is figure 8 a; a plant has its title alone */
function nameOf(id) {
  if (!id.startsWith("figure-")) return "";
  return id.replace(/^figure-(\d+)(.*)$/, "$1 $2").trim();
}
