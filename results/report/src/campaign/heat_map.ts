// A map of two axes as a table whose cells are coloured: read by eye, by keyboard and screen reader, and on paper.
import type { CampaignAxis, CampaignCurve, LevelResult } from "../data";
import { breakable, h } from "../dom";
import { plural, significant } from "../format";
import { axisTitle, comText, fallsText, levelText, withUnit } from "./blocks";

// What the colour stands for.
export interface Heat {
  id: "falls" | "com";
  title: string;
  value: (level: LevelResult) => number | null; // null: nothing to colour
  text: (level: LevelResult) => string;
  most: (most: number) => number; // the value of the deepest colour
  ends: (most: number) => [string, string]; // of the scale
}

export const kHeats: readonly Heat[] = [
  {
    id: "falls",
    title: "share of falls",
    value: (level) => (level.trials > 0 ? level.falls / level.trials : null),
    text: (level) => `${level.falls}/${level.trials}`,
    most: () => 1,
    ends: () => ["none fell", "all fell"],
  },
  {
    id: "com",
    title: "CoM error",
    value: (level) => level.com_error_m,
    text: (level) => significant(1e3 * (level.com_error_m ?? NaN), 2),
    most: (most) => most,
    ends: (most) => ["0 mm", `${significant(1e3 * most)} mm`],
  },
];

// Parts of the scale from which on the text needs the other colour: in the dark, and in the light.
const kMiddle = 0.5;
const kDeep = 0.82;

export function heatMap(name: string, curve: CampaignCurve, across: CampaignAxis, up: CampaignAxis, heat: Heat, most: number): HTMLElement {
  const at = new Map(curve.levels.map((level) => [level.level.join(), level]));
  const rows = up.levels.map((level, j) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, levelText(level)),
      ...across.levels.map((other, i) => square(at.get(`${i},${j}`), `${across.name} ${withUnit(other, across)}, ${up.name} ${withUnit(level, up)}`, heat, heat.most(most))),
    ),
  );
  const foot = h("tr", {}, h("td", {}), ...across.levels.map((level) => h("th", { scope: "col" }, levelText(level))));
  const axes = h("tr", {}, h("td", { class: "note", colspan: across.levels.length + 1 }, `\u2192 ${axisTitle(across)} \u00A0 \u2191 ${axisTitle(up)}`));
  const attributes = { class: `heat heat-${heat.id}`, style: `--columns: ${across.levels.length}`, "aria-label": `${name}: ${heat.title}` };
  const table = h("table", attributes, h("tbody", {}, ...rows.reverse()), h("tfoot", {}, foot, axes));
  return h(
    "figure",
    { class: "figure", "data-test": "heat-map", "data-observer": name },
    h("figcaption", {}, h("h4", {}, breakable(name)), h("span", { class: "note" }, `${fallsText(curve)} in all${curve.errors > 0 ? `, ${curve.errors} could not be run` : ""}`)),
    h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": `${name}: ${heat.title}` }, table),
  );
}

function square(level: LevelResult | undefined, where: string, heat: Heat, most: number): HTMLElement {
  const title = `${where}: ${spoken(level)}`;
  const value = level && heat.value(level);
  if (!level || value === null || value === undefined) return h("td", { class: "bare", title, "data-state": "bare" }, bareText(level, heat));
  const share = most > 0 ? Math.min(1, value / most) : 0;
  return h("td", { class: share > kDeep ? "deep" : share > kMiddle ? "middle" : null, style: `--share: ${(100 * share).toFixed(1)}%`, title, "data-state": "run" }, heat.text(level));
}

function spoken(level: LevelResult | undefined): string {
  if (!level || level.trials + level.errors === 0) return "not run";
  const parts = [level.trials > 0 && fallsText(level), comText(level), level.errors > 0 && `${plural(level.errors, "trial")} could not be run`];
  return parts.filter(Boolean).join("; ");
}

// "err": nothing but errors; "fell": no survivor whose error there could be.
function bareText(level: LevelResult | undefined, heat: Heat): string {
  if (!level || level.trials + level.errors === 0) return "\u2013";
  if (level.trials === 0) return "err";
  return heat.id === "com" && level.falls === level.trials ? "fell" : "\u2013";
}

// The scale, and what is hatched.
export function heatKey(heat: Heat, most: number): HTMLElement[] {
  const [low, high] = heat.ends(most);
  const steps = [0, 0.25, 0.5, 0.75, 1].map((share) => h("span", { class: "step", style: `--share: ${100 * share}%` }));
  return [
    h("span", { class: "key" }, low, h("span", { class: `ramp heat-${heat.id}`, "aria-hidden": true }, ...steps), high),
    h("span", { class: "key" }, h("span", { class: "ramp", "aria-hidden": true }, h("span", { class: "step bare" })), heat.id === "com" ? "none survived, or not run" : "not run"),
  ];
}
