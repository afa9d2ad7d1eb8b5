/** `bough-plant.js`: the same for `<script type="module">`. It loads what draws and computes only when it is wanted. */
import { define } from "./element.ts";

define(new URL(import.meta.url).searchParams.get("tag") ?? undefined);
