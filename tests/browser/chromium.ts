export { complaint, launchChromium } from "../../tools/chromium.mjs";
