import { startEngine } from "bough/worker";
import { useEffect, useState } from "react";

/** All branches of the page share one pool of their own requests: an engine each would let the newest win only there. */
const engines = new Map();

function engineOf(name) {
  if (!engines.has(name)) engines.set(name, startEngine());
  return engines.get(name);
}

/** A branch as SVG. `name` tells it from others on the page; changing `params` while it is computed starts anew. */
export function Branch({ name, params }) {
  const [plant, setPlant] = useState(null);
  useEffect(() => {
    const aborter = new AbortController();
    const { signal } = aborter;
    engineOf(name)
      .then((engine) => engine.plant(params, null, { signal }))
      .then(setPlant, (error) => {
        if (error.name !== "AbortError") throw error;
      });
    return () => aborter.abort();
  }, [name, params]);
  if (!plant) return <p>Growing…</p>;
  const { points } = plant.polylines;
  const places = Array.from(
    { length: points.length / 3 },
    (_, i) => `${points[3 * i]},${-points[3 * i + 1]}`,
  );
  return (
    <figure>
      <svg viewBox="-0.1 -1.6 1.8 2" width="360" role="img" aria-label={`The branch ${name}`}>
        <polyline points={places.join(" ")} fill="none" stroke="#80644b" strokeWidth="0.02" />
      </svg>
      <figcaption>
        {name}: {plant.report.status}, tip {points.at(-2).toFixed(2)} m high
      </figcaption>
    </figure>
  );
}
