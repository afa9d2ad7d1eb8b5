/** Texts that a person cannot read to their end. Runs in the page. */

/** Every visible text that something cuts off, or that sticks out of the page or of a box that should not scroll sideways. */
export function cutTexts(): string[] {
  const cut = new Set<string>();
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const text = node.textContent?.trim() ?? "";
    const parent = node.parentElement;
    if (
      text === "" ||
      !parent ||
      parent.closest(".visually-hidden, .skip, script, style, option, textarea, svg.annotation")
    )
      continue;
    const range = document.createRange();
    range.selectNodeContents(node);
    for (const box of range.getClientRects()) {
      if (box.width > 0 && isCut(parent, box)) cut.add(text.slice(0, 60));
    }
  }
  const pen = document.createElement("canvas").getContext("2d");
  for (const select of document.querySelectorAll("select")) {
    const [shown] = select.selectedOptions;
    const isSeen = select.getClientRects().length > 0 && getComputedStyle(select).opacity !== "0";
    if (!shown || !pen || !isSeen) continue;
    pen.font = getComputedStyle(select).font;
    const { paddingLeft, paddingRight } = getComputedStyle(select);
    const room = select.clientWidth - Number.parseFloat(paddingLeft) - Number.parseFloat(paddingRight);
    // The arrow of a menu takes about 16 px.
    if (pen.measureText(shown.text).width > room - 14) cut.add(`select: ${shown.text}`);
  }
  return [...cut];

  function isCut(element: Element, box: DOMRect): boolean {
    for (let around: Element | null = element; around; around = around.parentElement) {
      const { overflowX, overflowY } = getComputedStyle(around);
      const own = around.getBoundingClientRect();
      // Plates scroll sideways; so may a table, where keys reach it too.
      const mayScroll = around.matches("ul.plates, .scroll[tabindex='0']") && overflowX !== "visible";
      if (mayScroll) return false;
      const sideways = box.right > own.right + 1 || box.left < own.left - 1;
      if (overflowX !== "visible" && sideways) return true;
      const isClipped = overflowY === "hidden" || overflowY === "clip";
      if (isClipped && (box.bottom > own.bottom + 1 || box.top < own.top - 1)) return true;
      // What can be scrolled to is not cut by anything further out.
      if (overflowY === "auto" || overflowY === "scroll") return box.right > innerWidth + 1 || box.left < -1;
    }
    return box.right > innerWidth + 1 || box.left < -1;
  }
}
