// What the reader looks at: shared by the verdict, the scenario view and the statistics.
import type { Report, ScenarioInfo, TraceInfo } from "./data";
import { type Signal, signal } from "./state";
import { inProfile, profilesOf } from "./summary";

export interface Selection {
  setting: Signal<number>; // gains, planner, overrides
  profile: Signal<string | null>; // null: all of them
  scenario: Signal<string>; // scenario/variant
  seed: Signal<number>;
  shown: Signal<ReadonlySet<string>>; // observer ids
  focus: Signal<string>; // the observer whose details are shown
  leg: Signal<string>;
}

export function makeSelection(report: Report): Selection {
  const profile = profilesOf(report)[0] ?? null;
  const first = report.traces[0]?.scenario_id ?? report.scenarios[0]?.id ?? "";
  const selection: Selection = {
    setting: signal(report.traces[0]?.setting ?? report.settings[0]?.id ?? 0),
    profile: signal<string | null>(profile),
    scenario: signal(first),
    seed: signal(report.traces[0]?.seed ?? report.run.seeds[0] ?? 1),
    shown: signal<ReadonlySet<string>>(new Set()),
    focus: signal(""),
    leg: signal("LF"),
  };
  showProfile(report, selection);
  selection.profile.subscribe(() => showProfile(report, selection));
  selection.setting.subscribe(() => keepToSetting(report, selection));
  return selection;
}

function showProfile(report: Report, selection: Selection): void {
  const ids = report.observers.filter((o) => inProfile(o, selection.profile.get())).map((o) => o.id);
  selection.shown.set(new Set(ids));
  const competing = report.observers.find((o) => ids.includes(o.id) && !o.oracle && o.observer !== "none");
  if (!ids.includes(selection.focus.get())) selection.focus.set(competing?.id ?? ids[0] ?? "");
}

export function scenarioOf(report: Report, selection: Selection): ScenarioInfo | undefined {
  return report.scenarios.find((s) => s.id === selection.scenario.get());
}

export interface ShownTrace {
  index: number;
  info: TraceInfo;
}

// The traces that the page has of the selected scenario, one per observer, in the order of the observers.
export function tracesOf(report: Report, selection: Selection): ShownTrace[] {
  const own = report.traces.flatMap((info, index) => {
    const fits =
      info.scenario_id === selection.scenario.get() &&
      info.setting === selection.setting.get() &&
      info.seed === selection.seed.get();
    return fits ? [{ index, info }] : [];
  });
  return report.observers.flatMap((o) => own.filter((t) => t.info.observer_id === o.id).slice(0, 1));
}

export function shownTraces(report: Report, selection: Selection): ShownTrace[] {
  return tracesOf(report, selection).filter((t) => selection.shown.get().has(t.info.observer_id));
}

// Of a scenario file: the wanted variant if it has a trace of the observer, else the first that has one; without any the
// wanted one, or the first.
export function variantToShow(report: Report, setting: number, scenario: string, wanted: string | null, observer: string): string {
  const has = (id: string): boolean => report.traces.some((t) => t.scenario_id === id && t.setting === setting && t.observer_id === observer);
  if (wanted !== null && has(wanted)) return wanted;
  const variants = report.scenarios.filter((s) => s.scenario === scenario).map((s) => s.id);
  return variants.find(has) ?? wanted ?? variants[0] ?? "";
}

// A scenario that has time series with other settings only, as that of another robot may, is shown with those.
export function selectScenario(report: Report, selection: Selection, id: string): void {
  const settings = report.traces.filter((t) => t.scenario_id === id).map((t) => t.setting);
  if (settings.length === 0 || settings.includes(selection.setting.get())) return show(report, selection, id);
  selection.scenario.set(id);
  selection.setting.set(settings[0]!);
}

// Of another setting the same scenario, another seed it may be; the setting's first one where it does not have that.
function keepToSetting(report: Report, selection: Selection): void {
  const own = report.traces.filter((t) => t.setting === selection.setting.get()).map((t) => t.scenario_id);
  const scenario = selection.scenario.get();
  show(report, selection, own.length === 0 || own.includes(scenario) ? scenario : own[0]!);
}

function show(report: Report, selection: Selection, id: string): void {
  const seeds = report.traces.filter((t) => t.scenario_id === id && t.setting === selection.setting.get()).map((t) => t.seed);
  if (seeds.length > 0 && !seeds.includes(selection.seed.get())) selection.seed.set(seeds[0]!);
  selection.scenario.set(id);
  showItsOwn(report, selection);
}

// A scenario with observers of its own, in another profile than the one that is shown, has them all shown.
function showItsOwn(report: Report, selection: Selection): void {
  const competes = (id: string): boolean => report.observers.some((o) => o.id === id && !o.oracle && o.observer !== "none");
  const own = tracesOf(report, selection).map((t) => t.info.observer_id);
  const shown = selection.shown.get();
  const first = own.find(competes);
  if (first === undefined || own.some((id) => competes(id) && shown.has(id))) return;
  selection.shown.set(new Set([...shown, ...own]));
  selection.focus.set(first);
}
