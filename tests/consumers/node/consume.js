import * as bough from "bough";
import * as inline from "bough/inline";
import * as worker from "bough/worker";
import { consume } from "./program.js";

console.log(await consume({ bough, inline, worker }));
