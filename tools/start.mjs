// npm start: set-up, then the development server, here in this process. Its options pass through: npm start -- --port 8080

import { orExplain } from "./obstacle.mjs";
import { setUp } from "./setup.mjs";

await orExplain(setUp);
await import(new URL("../node_modules/vite/bin/vite.js", import.meta.url).href);
