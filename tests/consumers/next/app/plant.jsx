"use client";
import * as bough from "bough";
import * as inline from "bough/inline";
import * as worker from "bough/worker";
import { useEffect } from "react";
import { consume } from "../program.js";

/** Is imported on the server too, where it must touch no DOM. */
export function Plant() {
  useEffect(() => {
    void consume({ bough, inline, worker }).then((report) => {
      globalThis.report = report;
    });
  }, []);
  return <p>{bough.version}</p>;
}
