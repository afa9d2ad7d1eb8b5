import { StrictMode, useMemo, useState } from "react";
import { createRoot } from "react-dom/client";
import { Branch } from "./branch.jsx";

function App() {
  const [gravity, setGravity] = useState(9.81);
  const params = useMemo(() => ({ loads: { gravity } }), [gravity]);
  return (
    <>
      <Branch name="birch" params={params} />
      <button type="button" onClick={() => setGravity(1.62)}>
        To the Moon
      </button>
    </>
  );
}

createRoot(document.querySelector("#app")).render(
  <StrictMode>
    <App />
  </StrictMode>,
);
