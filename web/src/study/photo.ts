/** A photo on this device, and where it lies in the plane of the picture. It is sent nowhere. */
import { words } from "./words.ts";

/** A point of the photo, px from its upper left corner. */
export interface Pixel {
  readonly u: number;
  readonly v: number;
}

/** Where a photo lies: its upper left corner (m), the size of a pixel (m), and its turn (radians, counter-clockwise). */
export interface Frame {
  readonly x: number;
  readonly y: number;
  readonly size: number;
  readonly turn: number;
}

/** A picture that can be shown. */
export interface Photo {
  readonly address: string;
  readonly width: number;
  readonly height: number;
}

/** What browsers show as pictures. Not SVG: that is a document. */
const types = ["image/png", "image/jpeg", "image/webp", "image/gif", "image/avif", "image/bmp"];
/** Bytes of a file. */
const most = 64e6;
/** A longer side is made smaller: finer than the screen is of no use. px */
const longest = 2400;

/** Reads a photo the right way up, as its EXIF data has it; throws a sentence if that cannot be done. */
export async function readPhoto(file: File): Promise<Photo> {
  if (!types.includes(file.type)) throw new Error(words.measure.notAnImage(file.name));
  if (file.size > most)
    throw new Error(words.measure.tooLarge(file.name, `${Math.round(file.size / 1e6)} MB`));
  try {
    const bitmap = await createImageBitmap(file, { imageOrientation: "from-image" });
    const scale = Math.min(1, longest / Math.max(bitmap.width, bitmap.height));
    const canvas = document.createElement("canvas");
    canvas.width = Math.max(1, Math.round(bitmap.width * scale));
    canvas.height = Math.max(1, Math.round(bitmap.height * scale));
    const pen = canvas.getContext("2d");
    if (!pen) throw new Error("This browser has no canvas to draw on.");
    // What a JPEG cannot have, transparent places, would turn black.
    pen.fillStyle = "#ffffff";
    pen.fillRect(0, 0, canvas.width, canvas.height);
    pen.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
    bitmap.close();
    const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, "image/jpeg", 0.92));
    if (!blob) throw new Error("There is no picture.");
    return { address: URL.createObjectURL(blob), width: canvas.width, height: canvas.height };
  } catch (error) {
    throw new Error(words.measure.unreadable(file.name), { cause: error });
  }
}

/** A point of the photo in the world, m. */
export function toWorld({ x, y, size, turn }: Frame, { u, v }: Pixel): { x: number; y: number } {
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  return { x: x + size * (u * cos + v * sin), y: y + size * (u * sin - v * cos) };
}

/** A point of the world on the photo. */
export function toPhoto({ x, y, size, turn }: Frame, at: { x: number; y: number }): Pixel {
  const [dx, dy] = [(at.x - x) / size, (at.y - y) / size];
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  return { u: dx * cos + dy * sin, v: dx * sin - dy * cos };
}

/** The frame moved so that a point of the photo comes to a place of the world. */
export function movedTo(frame: Frame, pixel: Pixel, place: { x: number; y: number }): Frame {
  const now = toWorld(frame, pixel);
  return { ...frame, x: frame.x + place.x - now.x, y: frame.y + place.y - now.y };
}

/** The frame with another size of pixels, or another turn; a place of the world stays on its point of the photo. */
export function changedAround(frame: Frame, place: { x: number; y: number }, change: Partial<Frame>): Frame {
  return movedTo({ ...frame, ...change }, toPhoto(frame, place), place);
}
