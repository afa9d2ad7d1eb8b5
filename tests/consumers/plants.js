/** What every app with the element does: it hears of two plants, changes one, and reports. */
export class Plants {
  #lines = [];

  /** Takes the event `bough-ready` of either plant. */
  ready = ({ target, detail }) => {
    this.#lines.push(`${target.preset ?? "own"} ready: ${detail.plant.report.status}, step ${detail.step}`);
    if (this.#lines.length === 2) void this.#finish(target.ownerDocument);
  };

  /** Takes the event `bough-error`. */
  failed = ({ detail }) => {
    this.#lines.push(detail.message);
  };

  async #finish(page) {
    const [first, second] = page.querySelectorAll("bough-plant");
    this.#lines.sort();
    this.#lines.push(`params ${JSON.stringify(second.params.loads.gravity)}`);
    const changed = new Promise((resolve) => first.addEventListener("bough-change", resolve, { once: true }));
    first.step = 5;
    await changed;
    this.#lines.push(`step ${first.plant.report.steps}`);
    for (const plant of [first, second]) {
      const { type, size } = await plant.toBlob();
      this.#lines.push(`${type} ${size > 1000 ? "with something in it" : "that is empty"}`);
    }
    globalThis.report = this.#lines.join("\n");
  }
}
