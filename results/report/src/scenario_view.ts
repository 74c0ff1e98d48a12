// One scenario: who is shown, the replay, and the plots, by what they are about.
import { kLegs, type Report } from "./data";
import { choiceButtons, h, replaceContent, select } from "./dom";
import { settingName } from "./format";
import { observerChips } from "./observer_chips";
import { balanceFigures } from "./plots/balance";
import type { Context } from "./plots/context";
import { estimateFigures } from "./plots/estimates";
import { footFigures } from "./plots/feet";
import type { Figure } from "./plots/figure";
import { groundFigure } from "./plots/ground";
import { timingFigures, timingTable } from "./plots/timing";
import { trackingFigures } from "./plots/tracking";
import { ReplayHost } from "./replay_host";
import { scenarioOf, selectScenario, type Selection, tracesOf } from "./selection";
import { timeRange } from "./state";
import { tabList } from "./tabs";
import { scenarioFacts } from "./terrain";
import { timeBar } from "./time_bar";

export class ScenarioView {
  readonly element = h("section", { id: "scenario", "aria-labelledby": "scenario-heading" });
  private readonly title = h("h2", { id: "scenario-heading", tabindex: -1 }, "Scenario");
  private readonly bar = h("div", { class: "bar" });
  private readonly summary = h("p", { class: "sentence", "data-test": "scenario-summary" });
  private readonly times = h("div", {});
  private readonly context: Context;
  private readonly figures: Figure[] = [];

  constructor(
    private readonly report: Report,
    private readonly selection: Selection,
  ) {
    this.context = { report, selection };
    const clock = timeBar(() => this.duration());
    const plots = h("div", { class: "plots" }, h("div", { class: "sticky" }, clock.element), this.tabs());
    const columns = h("div", { class: "columns" }, new ReplayHost(report, selection).element, plots);
    this.element.append(this.title, this.bar, this.summary, observerChips(report, selection), columns);
    const changed = (): void => {
      this.describe();
      clock.update();
      this.redraw();
    };
    selection.scenario.subscribe(() => timeRange.set(null));
    for (const signal of [selection.scenario, selection.setting, selection.seed]) signal.subscribe(changed);
    for (const signal of [selection.shown, selection.focus, selection.leg]) signal.subscribe(() => this.redraw());
    this.describe();
    this.redraw();
  }

  focus(): void {
    this.element.scrollIntoView({ block: "start" });
    this.title.focus({ preventScroll: true });
  }

  private redraw(): void {
    replaceContent(this.times, timingTable(this.context));
    for (const figure of this.figures) figure.invalidate();
  }

  private duration(): number {
    const ends = tracesOf(this.report, this.selection).map((t) => t.info.end_s);
    return ends.length > 0 ? Math.max(...ends) : (scenarioOf(this.report, this.selection)?.duration_s ?? 0);
  }

  private describe(): void {
    const { report, selection } = this;
    const focused = document.activeElement?.getAttribute("data-test");
    const choices = report.scenarios.map((s) => {
      const held = report.traces.some((t) => t.scenario_id === s.id);
      return { value: s.id, text: `${s.id}${held ? "" : " (no time series)"}`, group: s.scenario };
    });
    const fits = (t: { scenario_id: string }): boolean => t.scenario_id === selection.scenario.get();
    const levels = report.campaign ? report.settings.filter((s) => report.traces.some((t) => fits(t) && t.setting === s.id)) : [];
    const seeds = [...new Set(report.traces.filter((t) => fits(t) && t.setting === selection.setting.get()).map((t) => t.seed))];
    replaceContent(
      this.bar,
      select("Scenario", choices, selection.scenario.get(), (id) => selectScenario(report, selection, id), "scenario-select"),
      levels.length > 1 &&
        select("Level", levels.map((s) => ({ value: String(s.id), text: settingName(s) })), String(selection.setting.get()), (s) => selection.setting.set(Number(s)), "level-select"),
      seeds.length > 1 &&
        select("Seed", seeds.map((s) => ({ value: String(s), text: String(s) })), String(selection.seed.get()), (s) => selection.seed.set(Number(s)), "seed-select"),
    );
    if (focused) this.bar.querySelector<HTMLElement>(`[data-test="${focused}"]`)?.focus();
    const s = scenarioOf(report, selection);
    const facts = s && scenarioFacts(report, s, { setting: selection.setting.get(), seed: selection.seed.get() });
    replaceContent(this.summary, s?.summary, h("small", {}, facts?.join(" \u00B7 ")));
  }

  private tabs(): HTMLElement {
    const panel = (figures: Figure[], ...before: (HTMLElement | null)[]): HTMLElement => {
      this.figures.push(...figures);
      return h("div", {}, ...before, ...figures.map((f) => f.element));
    };
    const legs = choiceButtons("Leg", kLegs.map((leg) => ({ value: leg, text: leg })), this.selection.leg.get(), (leg) => this.selection.leg.set(leg), "leg");
    const [force, joints, wrench] = estimateFigures(this.context) as [Figure, Figure, Figure];
    const estimates = panel([force, joints, wrench]);
    joints.element.querySelector("figcaption")?.after(legs);
    const timing = panel(timingFigures(this.context));
    timing.append(this.times);
    const tabs = [
      { id: "tracking", text: "Tracking", panel: panel(trackingFigures(this.context)) },
      { id: "estimates", text: "Estimates", panel: estimates },
      { id: "feet", text: "Feet", panel: panel(footFigures(this.context)) },
      { id: "balance", text: "Balance", panel: panel([groundFigure(this.context), ...balanceFigures(this.context)]) },
      { id: "timing", text: "Timing", panel: timing },
    ];
    const hint = "Click: cursor. Drag: zoom, in all plots over time. Double click: all again. Names in a legend switch lines on and off.";
    return h("div", {}, tabList("Plots", tabs, "plot-tabs"), h("p", { class: "note hint" }, hint), ...tabs.map((tab) => tab.panel));
  }
}
