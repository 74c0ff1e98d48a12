// What the plots of a scenario draw from.
import { observerStyles, type ObserverStyle } from "../colors";
import { type Cell, loadTrace, type Report, type Trace } from "../data";
import { seconds, shortName } from "../format";
import { type Selection, shownTraces, tracesOf } from "../selection";
import type { Theme } from "../state";

export interface Context {
  report: Report;
  selection: Selection;
}

export interface Shown {
  trace: Trace;
  cell: Cell | undefined;
  id: string;
  label: string; // with the fall, if it fell
  short: string;
  style: ObserverStyle;
  rank: number; // in legends: the order of the report, whatever is drawn on top
  fall: number | null; // [s]
}

// In the order in which they are drawn: the observer in detail last, on top of the others.
export async function loadShown({ report, selection }: Context, theme: Theme): Promise<Shown[]> {
  const traces = shownTraces(report, selection);
  const styles = observerStyles(report.observers, theme);
  const onTop = (id: string): number => Number(id === selection.focus.get());
  traces.sort((a, b) => onTop(a.info.observer_id) - onTop(b.info.observer_id));
  return Promise.all(
    traces.map(async ({ index, info }) => {
      const cell = report.cells[info.cell];
      const fall = cell?.outcome === "fell" ? (cell.fall_time_s ?? info.end_s) : null;
      const short = shortName(info.observer_id);
      const style = styles.get(info.observer_id)!;
      const rank = 100 + report.observers.findIndex((o) => o.id === info.observer_id);
      const label = fall === null ? short : `${short} \u2715 fell at ${seconds(fall)}`;
      return { trace: await loadTrace(index), cell, id: info.observer_id, label, short, style, rank, fall };
    }),
  );
}

// How many of the points of a plot lie more than a second before the fall; all of them without one.
export function pointsBefore(s: Shown, points: number): number {
  if (s.fall === null) return points;
  return Math.min(points, Math.max(2, 2 * Math.floor((s.fall - 1) / s.trace.info.plots.bucket_s)));
}

// The end of the longest run [s].
export function endOf(shown: readonly Shown[]): number {
  return Math.max(0, ...shown.map((s) => s.trace.info.end_s));
}

// The trace of the observer in detail; without one the first that is shown.
export function focused(shown: readonly Shown[], selection: Selection): Shown | undefined {
  return shown.find((s) => s.id === selection.focus.get()) ?? shown[0];
}

export function noTrace({ report, selection }: Context): { missing: string } {
  const scenario = selection.scenario.get();
  if (report.traces.length === 0) {
    return { missing: "This page holds no time series. `dobbench run` keeps those of the first seed unless it is told --keep none." };
  }
  if (tracesOf(report, selection).length === 0) {
    return { missing: `This page holds no time series of ${scenario} with these settings; \u201CThis run\u201D below says what was left out. --max-size MB lets more in.` };
  }
  return { missing: "No observer is switched on: choose one above." };
}

export function fileName({ report, selection }: Context, plot: string): string {
  return [report.title, selection.scenario.get(), plot].join("-").replace(/[^\w.-]+/g, "_");
}
