// The observers of the selected scenario: a button each that shows or hides it in all plots, with its line and symbol.
import { observerStyles, type ObserverStyle } from "./colors";
import type { ObserverInfo, Report } from "./data";
import { h, replaceContent, svg } from "./dom";
import { seconds, shortName } from "./format";
import { stateIcon } from "./icons";
import { type Selection, tracesOf } from "./selection";
import { theme } from "./state";
import { inProfile } from "./summary";

export function observerChips(report: Report, selection: Selection): HTMLElement {
  const element = h("div", { class: "chips", role: "group", "aria-label": "Observers shown", "data-test": "observers" });
  const draw = (): void => {
    const focused = (document.activeElement as HTMLElement | null)?.dataset["observer"];
    const inside = element.contains(document.activeElement);
    const styles = observerStyles(report.observers, theme.get());
    const ran = report.observers.filter((o) => isOffered(report, selection, o));
    replaceContent(element, ...ran.map((o) => chip(report, selection, o, styles.get(o.id)!)));
    if (inside && focused) element.querySelector<HTMLElement>(`[data-observer="${CSS.escape(focused)}"]`)?.focus();
  };
  for (const signal of [selection.scenario, selection.shown, selection.setting, selection.seed, theme]) signal.subscribe(draw);
  draw();
  return element;
}

// What has a time series here, and what the profile asks for but was left out.
function isOffered(report: Report, selection: Selection, observer: ObserverInfo): boolean {
  if (tracesOf(report, selection).some((t) => t.info.observer_id === observer.id)) return true;
  const ran = report.rows.some((row) => row.scenario_id === selection.scenario.get() && row.setting === selection.setting.get() && row.observer_id === observer.id);
  return ran && inProfile(observer, selection.profile.get());
}

function chip(report: Report, selection: Selection, observer: ObserverInfo, style: ObserverStyle): HTMLElement {
  const trace = tracesOf(report, selection).find((t) => t.info.observer_id === observer.id);
  const cell = trace && report.cells[trace.info.cell];
  const shown = selection.shown.get();
  const toggle = (): void => {
    const next = new Set(shown);
    if (!next.delete(observer.id)) next.add(observer.id);
    selection.shown.set(next);
  };
  const end = !trace ? "not on this page" : cell?.outcome === "fell" ? `fell ${seconds(cell.fall_time_s)}` : "";
  return h(
    "button",
    {
      type: "button",
      class: "chip",
      disabled: !trace,
      "aria-pressed": trace !== undefined && shown.has(observer.id),
      "data-observer": observer.id,
      title: trace ? observer.id : `${observer.id}: its time series was left out of this page`,
      onclick: toggle,
    },
    sample(style),
    h("span", {}, shortName(observer.id)),
    cell?.outcome === "fell" && stateIcon("fell"),
    end !== "" && h("small", {}, end),
  );
}

const kNamedDashes: Record<string, string> = { solid: "", dash: "5 3", dot: "1.5 2.5", dashdot: "5 2 1.5 2" };

function sample(style: ObserverStyle): SVGElement {
  return svg(
    "svg",
    { class: "sample", viewBox: "0 0 22 8", "aria-hidden": true },
    svg("path", { d: "M0 4 H22", stroke: style.color, "stroke-width": 2.4, "stroke-dasharray": kNamedDashes[style.dash] ?? style.dash.replace(/px,?/g, " ").trim() }),
  );
}
