/** Where the gallery's pictures are: files beside the page. The build of the single file puts the pictures themselves here. */

/** Address of the thumbnail of a preset, or of the plant that belongs to none. */
export function thumbnailOf(id: string | null): string {
  return `presets/${id ?? "default"}.webp`;
}
