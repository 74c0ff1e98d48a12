// Numbers as they are shown: SI in the data, mm and the like for readers.

// Three significant digits: 0.0304 -> "0.0304", 158.2 -> "158", 6.378 -> "6.38".
export function significant(value: number, digits = 3): string {
  if (!Number.isFinite(value)) return "\u2013";
  if (value === 0) return "0";
  const exponent = Math.floor(Math.log10(Math.abs(value)));
  if (exponent < -4) return value.toExponential(digits - 1);
  return value.toFixed(Math.min(20, Math.max(0, digits - 1 - exponent)));
}

export function millimetres(value: number | null | undefined): string {
  return value === null || value === undefined ? "\u2013" : significant(1e3 * value);
}

export function seconds(value: number | null | undefined): string {
  return value === null || value === undefined ? "\u2013" : `${value.toFixed(value < 10 ? 2 : 1)} s`;
}

export function plural(count: number, noun: string, many = `${noun}s`): string {
  return `${count} ${count === 1 ? noun : many}`;
}

// "paper, spline, duration_s=4"
export function settingName(setting: { gains: string; planner: string; overrides: string }): string {
  return `${setting.gains}, ${setting.planner}${setting.overrides ? `, ${setting.overrides}` : ""}`;
}

// What `dobbench` measures of a run, as the page shows it: data * factor in `unit`.
export interface Metric {
  field: CellMetric;
  label: string;
  unit: string;
  factor: number;
  paired: boolean; // the rows have its paired difference
}

export type CellMetric =
  | "com_error_max_m"
  | "com_error_rms_m"
  | "path_error_max_m"
  | "foot_error_max_m"
  | "grf_error_mean_N"
  | "estimate_rmse_N"
  | "orientation_error_max_rad";

export const kMetrics: readonly Metric[] = [
  { field: "com_error_max_m", label: "CoM error, largest", unit: "mm", factor: 1e3, paired: true },
  { field: "com_error_rms_m", label: "CoM error, RMS", unit: "mm", factor: 1e3, paired: true },
  { field: "path_error_max_m", label: "Path error, largest", unit: "mm", factor: 1e3, paired: true },
  { field: "foot_error_max_m", label: "Foot error in swing, without onset swings", unit: "mm", factor: 1e3, paired: true },
  { field: "grf_error_mean_N", label: "GRF error, mean", unit: "N", factor: 1, paired: true },
  { field: "estimate_rmse_N", label: "Force estimate, RMSE", unit: "N", factor: 1, paired: false },
  { field: "orientation_error_max_rad", label: "Orientation error, largest", unit: "rad", factor: 1, paired: false },
];

export function metricOf(field: string): Metric {
  return kMetrics.find((m) => m.field === field) ?? kMetrics[0]!;
}

// Observers can have long names (options in them); what does not fit ends in an ellipsis.
export function shortName(name: string, longest = 46): string {
  if (name.length <= longest) return name;
  const at = name.lastIndexOf("@");
  const profile = at > 0 ? name.slice(at) : "";
  return `${name.slice(0, Math.max(8, longest - profile.length - 1))}\u2026${profile}`;
}
