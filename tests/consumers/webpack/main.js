import * as bough from "bough";
import * as inline from "bough/inline";
import * as worker from "bough/worker";
import { consume } from "./program.js";

globalThis.report = await consume({ bough, inline, worker });
