// Where 50 % and 5 % fall, in figures: one block, and all of them.
import type { Campaign, CampaignAxis, CampaignCurve, FallThreshold } from "../data";
import { breakable, type Child, h, replaceContent } from "../dom";
import { plural, shortName } from "../format";
import { ascends, axisTitle, type Block, levelText, observerOf, thresholdText, withUnit } from "./blocks";
import { type Column, focusHeading, headings, type Order, sorted } from "../sortable";

export function thresholdTable(campaign: Campaign, block: Block): HTMLElement {
  const axis = block.axes[0]!;
  const columns = columnsOf(campaign, axis);
  const host = h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Thresholds" });
  const draw = (order: Order | null): void => {
    const change = (next: Order | null): void => {
      draw(next);
      focusHeading(host, next?.column ?? order?.column ?? "");
    };
    const rows = sorted(block.curves, columns, order).map((curve) => thresholdRow(campaign, curve, axis));
    replaceContent(host, h("table", { "data-test": "threshold-table" }, h("thead", {}, headings(columns, order, change)), h("tbody", {}, ...rows)));
  };
  draw(null);
  return host;
}

function columnsOf(campaign: Campaign, axis: CampaignAxis): Column<CampaignCurve>[] {
  const number = (field: "seeds" | "trials" | "falls" | "errors", heading: string): Column<CampaignCurve> => ({ id: field, heading, key: (c) => c[field], class: "number" });
  const threshold = (field: "fall_50" | "fall_5", share: string): Column<CampaignCurve> => ({
    id: field,
    heading: h("span", {}, `${share} fall at`, h("small", {}, axisTitle(axis))),
    key: (c) => hardness(c[field], axis),
    class: "number",
  });
  return [
    { id: "observer", heading: "Observer", key: (c) => observerOf(campaign, c).id },
    threshold("fall_50", "50 %"),
    threshold("fall_5", "5 %"),
    number("trials", "Trials"),
    number("falls", "Falls"),
    number("seeds", "Seeds"),
    number("errors", "Not run"),
    { id: "non_monotone", heading: "Fell, stood harder", key: (c) => c.non_monotone.length, class: "number" },
  ];
}

// Grows from the mildest level to the hardest; what is beyond the levels is as far beyond as the others.
function hardness(threshold: FallThreshold | null, axis: CampaignAxis): number | null {
  if (!threshold) return null;
  const within = Math.min(Math.max(threshold.estimate, Math.min(...axis.levels)), Math.max(...axis.levels));
  return ascends(axis) ? within : -within;
}

function thresholdRow(campaign: Campaign, curve: CampaignCurve, axis: CampaignAxis): HTMLElement {
  const number = (x: Child, title?: string): HTMLElement => h("td", { class: "number", title }, x);
  const list = curve.non_monotone.map((s) => `seed ${s.seed} fell at ${withUnit(s.fell_at, axis)} and stood ${levelText(s.survived_at)}`);
  return h(
    "tr",
    { "data-observer": curve.observer_id },
    h("th", { scope: "row" }, breakable(shortName(observerOf(campaign, curve).id, 60))),
    thresholdCell(curve.fall_50, axis),
    thresholdCell(curve.fall_5, axis),
    number(String(curve.trials)),
    number(String(curve.falls)),
    number(String(curve.seeds)),
    number(curve.errors > 0 ? String(curve.errors) : "0"),
    number(String(curve.non_monotone.length), list.join("; ") || undefined),
  );
}

function thresholdCell(threshold: FallThreshold | null, axis: CampaignAxis): HTMLElement {
  const [estimate, interval] = thresholdText(threshold, axis);
  return h("td", { class: "number" }, estimate, interval !== "" && h("small", {}, interval));
}

// Blocks down, observers across; a press shows the block.
export function thresholdMatrix(campaign: Campaign, blocks: readonly Block[], chosen: number, open: (block: number) => void): HTMLElement {
  const ids = new Set(blocks.flatMap((block) => block.curves.map((curve) => curve.observer_id)));
  const observers = campaign.observers.filter((o) => ids.has(o.id));
  const head = h("tr", {}, h("th", { scope: "col", class: "name" }, "50 % fall at"), ...observers.map((o) => h("th", { scope: "col" }, h("span", { class: "observer", title: o.id }, breakable(shortName(o.observer, 64)), h("small", {}, o.oracle ? "bound" : o.profile === "-" ? "\u00A0" : o.profile)))));
  const rows = blocks.map((block, i) =>
    h(
      "tr",
      { "aria-current": i === chosen ? "true" : null },
      h("th", { scope: "row", class: "name" }, h("button", { type: "button", class: "expand wrap", "data-block": i, onclick: () => open(i) }, h("span", {}, breakable(block.name), h("small", {}, axisTitle(block.axes[0]!))))),
      ...observers.map((o) => matrixCell(block.curves.find((curve) => curve.observer_id === o.id), block.axes[0]!)),
    ),
  );
  const label = "Thresholds of all blocks";
  const table = h("table", { class: "matrix", "data-test": "threshold-matrix", "aria-label": label }, h("thead", {}, head), h("tbody", {}, ...rows));
  return h("div", { class: "scroll tall", tabindex: 0, role: "region", "aria-label": label }, table);
}

function matrixCell(curve: CampaignCurve | undefined, axis: CampaignAxis): HTMLElement {
  if (!curve) return h("td", {}, h("span", { class: "nothing" }, "\u2013"));
  const [estimate, interval] = thresholdText(curve.fall_50, axis);
  const [milder] = thresholdText(curve.fall_5, axis);
  return h("td", { title: `5 % fall at ${milder}; ${curve.falls} of ${plural(curve.trials, "trial")} fell` }, estimate, interval !== "" && h("small", {}, interval));
}
