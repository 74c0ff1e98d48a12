// A campaign's curves side by side, and its levels and thresholds in words.
import { observerStyles, type ObserverStyle } from "../colors";
import type { Campaign, CampaignAxis, CampaignCurve, FallThreshold, Interval, LevelResult, ObserverInfo, Report } from "../data";
import { settingName, significant } from "../format";
import type { Theme } from "../state";

// Curves over the same axes that differ in the observer only; of observers in the order of the campaign.
export interface Block {
  name: string; // what tells it from the other blocks
  whole: string; // all there is to say
  axes: CampaignAxis[];
  curves: CampaignCurve[];
}

export function blocksOf(campaign: Campaign): Block[] {
  const groups = new Map<string, CampaignCurve[]>();
  for (const curve of campaign.curves) {
    const key = JSON.stringify([curve.scenario_id, curve.setting, curve.axes]);
    groups.set(key, [...(groups.get(key) ?? []), curve]);
  }
  const all = [...groups.values()];
  const differ = (of: (curve: CampaignCurve) => unknown): boolean => new Set(all.map((curves) => JSON.stringify(of(curves[0]!)))).size > 1;
  const [scenarios, settings, axes] = [differ((c) => c.scenario_id), differ((c) => c.setting), differ((c) => c.axes)];
  return all.map((curves) => {
    const first = curves[0]!;
    const setting = campaign.settings[first.setting];
    const own = first.axes.map((i) => campaign.axes[i]!);
    const parts = [first.scenario_id, setting ? settingName(setting) : "", own.map((axis) => axis.name).join(" and ")];
    const telling = parts.filter((_, i) => [scenarios, settings, axes][i]);
    return { name: telling.join("; ") || first.scenario_id, whole: parts.filter(Boolean).join("; "), axes: own, curves };
  });
}

export function observerOf(campaign: Campaign, curve: CampaignCurve): ObserverInfo {
  return campaign.observers.find((o) => o.id === curve.observer_id) ?? { id: curve.observer_id, observer: curve.observer_id, profile: "-", oracle: false };
}

// As in the rest of the page, unless an axis changes the observers, so that the cells have others than the curves.
export function campaignStyles(report: Report, campaign: Campaign, theme: Theme): Map<string, ObserverStyle> {
  const known = new Set(report.observers.map((o) => o.id));
  return observerStyles(campaign.observers.every((o) => known.has(o.id)) ? report.observers : campaign.observers, theme);
}

// "amplitude [N]"
export function axisTitle(axis: CampaignAxis): string {
  return axis.unit ? `${axis.name} [${axis.unit}]` : axis.name;
}

// "40 N"
export function withUnit(value: number | string, axis: CampaignAxis): string {
  const text = typeof value === "number" ? levelText(value) : value;
  return axis.unit ? `${text} ${axis.unit}` : text;
}

// Whole numbers as they are, others to four digits.
export function levelText(value: number): string {
  return String(Number.isInteger(value) ? value : Number(value.toPrecision(4)));
}

export function ascends(axis: CampaignAxis): boolean {
  return axis.levels[axis.levels.length - 1]! >= axis.levels[0]!;
}

// An interval whose ends may say no more than "milder than the mildest level" or "harder than the hardest".
export interface OpenInterval {
  low: number;
  high: number;
  openLow: boolean;
  openHigh: boolean;
}

export function openInterval(threshold: FallThreshold, axis: CampaignAxis): OpenInterval {
  const [openLow, openHigh] = ascends(axis) ? [threshold.below, threshold.above] : [threshold.above, threshold.below];
  return { low: threshold.ci95[0], high: threshold.ci95[1], openLow, openHigh };
}

// ["41.3", "35.0 to 48.2"]; what is beyond the levels is "> 80", and an interval that ends there "60.1 to > 80".
export function thresholdText(threshold: FallThreshold | null, axis: CampaignAxis): [string, string] {
  if (!threshold) return ["\u2013", ""];
  const [least, most] = [Math.min(...axis.levels), Math.max(...axis.levels)];
  const text = (x: number): string => (x < least ? `< ${levelText(least)}` : x > most ? `> ${levelText(most)}` : significant(x));
  const { low, high, openLow, openHigh } = openInterval(threshold, axis);
  const ends = [text(openLow ? -Infinity : low), text(openHigh ? Infinity : high)];
  const middle = text(threshold.estimate);
  if (openLow && openHigh) return [middle, "these trials do not tell"];
  return [middle, ends[0] === ends[1] ? "" : ends.join(" to ")];
}

export function percent(share: number): string {
  const value = 100 * share;
  return `${value > 0 && value < 1 ? value.toFixed(1) : value.toFixed(0)} %`;
}

// "3 of 12 fell (9 % to 53 %)"
export function fallsText(x: { trials: number; falls: number; falls_ci95?: Interval | null }): string {
  const interval = x.falls_ci95 ? ` (${percent(x.falls_ci95[0])} to ${percent(x.falls_ci95[1])})` : "";
  return `${x.falls} of ${x.trials} fell${interval}`;
}

// "CoM error 30.4 mm (24.1 to 38.8 mm)"; "" without survivors.
export function comText(x: LevelResult): string {
  if (x.com_error_m === null) return "";
  const ci = x.com_error_ci95;
  return `CoM error ${significant(1e3 * x.com_error_m)} mm${ci ? ` (${significant(1e3 * ci[0])} to ${significant(1e3 * ci[1])} mm)` : ""}`;
}
