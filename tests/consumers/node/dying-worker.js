// In this order: it dies before the engine's own listener hears of the request.
import "./thirteen.js";
import "bough/worker-script";
