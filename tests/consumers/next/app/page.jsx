import * as bough from "bough";
import * as inline from "bough/inline";
import * as worker from "bough/worker";
import { consume } from "../program.js";
import { Plant } from "./plant.jsx";

export const dynamic = "force-dynamic";

/** The server grows the same plants as the browser does. */
export default async function Page() {
  return (
    <>
      <pre id="server">{await consume({ bough, inline, worker })}</pre>
      <Plant />
    </>
  );
}
