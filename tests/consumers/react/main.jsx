import { define } from "bough/element";
import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { Plants } from "./plants.js";

define();
const plants = new Plants();

function App() {
  return (
    <>
      <bough-plant preset="figure-13a" onbough-ready={plants.ready} onbough-error={plants.failed} />
      <bough-plant params={{ loads: { gravity: 3 } }} controls="none" onbough-ready={plants.ready} />
    </>
  );
}

createRoot(document.querySelector("#app")).render(
  <StrictMode>
    <App />
  </StrictMode>,
);
