// Plotly takes a moment to start: it does so when the first plot is drawn, after the page is there.
import type { Plotly } from "plotly.js-cartesian-dist-min";

export type { Axis, PlotElement, PlotLayout, Plotly, PlotTrace } from "plotly.js-cartesian-dist-min";

let loading: Promise<Plotly> | null = null;

export function loadPlotly(): Promise<Plotly> {
  loading ??= import("plotly.js-cartesian-dist-min").then((module) => module.default);
  return loading;
}
