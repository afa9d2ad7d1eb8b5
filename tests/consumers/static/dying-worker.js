// In this order: it dies before the engine's own listener hears of the request.
import "./thirteen.js";
import "./node_modules/bough/dist/package/src/engine/worker.js";
