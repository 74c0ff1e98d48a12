// From rows (over seeds) to the verdict: the same rules as the summary of `dobbench table`, see docs/metrics.md.
import type { ObserverInfo, Report, Row } from "./data";
import { plural } from "./format";
import type { CellState } from "./icons";

// All variants of a scenario, or one of them, for one observer.
export interface CellSummary {
  state: CellState;
  seeds: number; // planned
  runs: number; // ran
  falls: number;
  errors: number;
  com: Row | null; // the row with the largest median among those in which a run survived
  foot: Row | null;
}

export function summarise(rows: readonly Row[]): CellSummary {
  const sum = (field: "seeds" | "runs" | "falls" | "errors"): number => rows.reduce((s, row) => s + row[field], 0);
  const cell = { seeds: sum("seeds"), runs: sum("runs"), falls: sum("falls"), errors: sum("errors") };
  return { ...cell, state: stateOf(cell), com: worst(rows, "com_error_max_m"), foot: worst(rows, "foot_error_max_m") };
}

function stateOf(cell: { seeds: number; runs: number; falls: number; errors: number }): CellState {
  if (cell.seeds === 0) return "empty";
  if (cell.errors > 0) return "error";
  if (cell.runs === 0) return "pending";
  if (cell.falls === 0) return "survived";
  return cell.falls === cell.runs ? "fell" : "some";
}

export function value(row: Row | null, field: string): number | null {
  const x = row?.[field];
  return typeof x === "number" ? x : null;
}

function worst(rows: readonly Row[], field: string): Row | null {
  let found: Row | null = null;
  for (const row of rows) {
    if (row.runs === row.falls || value(row, field) === null) continue;
    if (!found || value(row, field)! > value(found, field)!) found = row;
  }
  return found;
}

// One observer over all scenarios of a set of rows.
export interface Line {
  observer: ObserverInfo;
  rows: Row[];
  seeds: number; // runs planned
  runs: number;
  falls: number;
  errors: number;
  meanRank: number | null; // over its rows, each among the rows that the lines are of
}

export function linesOf(report: Report, rows: readonly Row[]): Line[] {
  const lines: Line[] = [];
  for (const observer of report.observers) {
    const own = rows.filter((row) => row.observer_id === observer.id);
    if (own.length === 0) continue;
    const { seeds, runs, falls, errors } = summarise(own);
    const ranks = own.flatMap((row) => rankAmong(row, rows) ?? []);
    const meanRank = ranks.length > 0 ? ranks.reduce((a, b) => a + b) / ranks.length : null;
    lines.push({ observer, rows: own, seeds, runs, falls, errors, meanRank });
  }
  return lines.sort(standsBefore);
}

// As results/table_rows.h ranks a table, but among these rows only: a rank in the table is one among all profiles.
export function rankAmong(row: Row, rows: readonly Row[]): number | null {
  if (row.oracle || row.runs === 0) return null;
  const block = rows.filter((o) => o.scenario_id === row.scenario_id && o.setting === row.setting && !o.oracle && o.runs > 0);
  return 1 + block.filter((other) => isBetter(other, row)).length;
}

function isBetter(a: Row, b: Row): boolean {
  const shares = lostShare(a) - lostShare(b);
  return shares !== 0 ? shares < 0 : merit(a) < merit(b);
}

// Smaller is better: the CoM error, or, where every run was lost, minus the time until the fall.
function merit(row: Row): number {
  if (row.runs === row.falls) return -(value(row, "fall_time_median_s") ?? 0);
  return value(row, "com_error_max_m") ?? Infinity;
}

export function lostShare(x: { runs: number; falls: number; errors: number }): number {
  return (x.falls + x.errors) / Math.max(1, x.runs + x.errors);
}

// Oracles last; those that lost nothing first; then by mean rank.
function standsBefore(a: Line, b: Line): number {
  return (
    Number(a.observer.oracle) - Number(b.observer.oracle) ||
    lostShare(a) - lostShare(b) ||
    (a.meanRank ?? Infinity) - (b.meanRank ?? Infinity)
  );
}

// A scenario that is about observers of its own says nothing about the others: what counts is what ran in two scenarios
// at least, in those scenarios in which two of these did. When nothing is left of a run so, all of it counts.
export function comparable(rows: readonly Row[]): Row[] {
  const scenarios = new Map<string, Set<string>>();
  for (const row of rows) {
    const own = scenarios.get(row.observer_id) ?? new Set();
    scenarios.set(row.observer_id, own.add(row.scenario));
  }
  const often = rows.filter((row) => (scenarios.get(row.observer_id)?.size ?? 0) > 1);
  const shared = often.filter((row) => often.some((o) => o.scenario === row.scenario && o.observer_id !== row.observer_id));
  return shared.length > 0 ? shared : [...rows];
}

// Profiles that observers of the run have, the tuned one first.
export function profilesOf(run: { observers: readonly ObserverInfo[] }): string[] {
  const profiles = [...new Set(run.observers.map((o) => o.profile))].filter((p) => p !== "-");
  return profiles.sort((a, b) => Number(b === "tuned") - Number(a === "tuned"));
}

export function inProfile(observer: { profile: string }, profile: string | null): boolean {
  return profile === null || observer.profile === "-" || observer.profile === profile;
}

// The best line among those that compete, in a sentence.
export function verdictSentence(lines: readonly Line[], scenarios: number): string {
  const ran = lines.filter((line) => !line.observer.oracle && line.runs + line.errors > 0);
  const best = ran[0];
  if (!best) return "No run of these observers has finished yet.";
  const id = best.observer.id;
  const rank = best.meanRank === null ? "" : `, mean rank ${best.meanRank.toFixed(1)}`;
  const figures = `${best.runs - best.falls} of ${best.runs + best.errors} runs survived${rank}`;
  const rest = unfinished(lines);
  const of = `Of ${plural(ran.length, "observer")} in ${plural(scenarios, "scenario")}`;
  const never = ran.filter((line) => line.falls + line.errors === 0).length;
  if (never === 0) return `${of} none survived everything; ${id} lost least: ${figures}.${rest}`;
  if (never === 1) return `${of} only ${id} never fell: ${figures}.${rest}`;
  return `${of} ${never} never fell; ${id} is the best ranked of them: ${figures}.${rest}`;
}

function unfinished(lines: readonly Line[]): string {
  const errors = lines.reduce((sum, line) => sum + line.errors, 0);
  const open = lines.reduce((sum, line) => sum + line.seeds - line.runs - line.errors, 0);
  const parts = [errors > 0 && `${errors} could not be run`, open > 0 && `${open} not run yet`].filter(Boolean);
  return parts.length > 0 ? ` Of the runs shown: ${parts.join(", ")}.` : "";
}
