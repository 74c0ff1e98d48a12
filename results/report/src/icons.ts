// Small shapes that say without colour how the runs of a cell ended.
import { svg } from "./dom";

export type CellState = "survived" | "some" | "fell" | "error" | "pending" | "empty";

export const kStateText: Record<CellState, string> = {
  survived: "every run survived",
  some: "some runs fell",
  fell: "every run fell",
  error: "some runs could not be run",
  pending: "not run yet",
  empty: "not part of this run",
};

export function stateIcon(state: CellState): SVGElement {
  return svg("svg", { class: `icon icon-${state}`, viewBox: "0 0 12 12", "aria-hidden": true }, ...shapes(state));
}

function shapes(state: CellState): SVGElement[] {
  const stroke = { fill: "none", stroke: "currentColor", "stroke-width": 2 };
  switch (state) {
    case "survived":
      return [svg("circle", { cx: 6, cy: 6, r: 5, fill: "currentColor" })];
    case "some":
      return [svg("path", { d: "M6 1 L11.5 11 L0.5 11 Z", ...stroke, "stroke-width": 1.6, "stroke-linejoin": "round" }), svg("path", { d: "M6 5 L9.2 11 L2.8 11 Z", fill: "currentColor" })];
    case "fell":
      return [svg("path", { d: "M2 2 L10 10 M10 2 L2 10", ...stroke, "stroke-width": 2.6, "stroke-linecap": "round" })];
    case "error":
      return [svg("path", { d: "M6 0.5 L11.5 6 L6 11.5 L0.5 6 Z", ...stroke, "stroke-width": 1.4 }), svg("path", { d: "M6 3.2 V6.8 M6 8 V9", ...stroke, "stroke-width": 1.4 })];
    case "pending":
      return [svg("circle", { cx: 6, cy: 6, r: 4.5, ...stroke, "stroke-width": 1.4, "stroke-dasharray": "2 1.5" })];
    case "empty":
      return [svg("path", { d: "M3 6 H9", ...stroke, "stroke-width": 1.4 })];
  }
}
