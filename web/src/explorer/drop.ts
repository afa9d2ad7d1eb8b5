/** Files that are dropped on the page. */

/** `open` is told of a file that was dropped, wherever on the page: the browser would go there instead. */
export function listenForFiles(open: (file: File) => void): void {
  addEventListener("dragover", (event) => {
    if (event.dataTransfer?.types.includes("Files")) event.preventDefault();
  });
  addEventListener("drop", (event) => {
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    event.preventDefault();
    open(file);
  });
}
