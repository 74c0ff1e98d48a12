// What `dobbench report` says of a run, as the page reads it (docs/report.md). SI units; times in s; null where a value
// does not apply.

export interface Machine {
  cpu?: string;
  cores?: number;
  os?: string;
  [key: string]: unknown;
}

export interface Run {
  command_line: string;
  version: string;
  commit: string;
  build: string;
  compiler: string;
  flags: string;
  date: string;
  machine: Machine;
  planned: number; // cells
  finished: number;
  errors: number;
  seeds: number[];
  notes: string[];
}

export interface ObserverInfo {
  id: string; // observer@profile, or the observer alone when its profile is "-"
  observer: string;
  profile: string;
  oracle: boolean;
}

export interface Setting {
  id: number;
  gains: string;
  planner: string;
  overrides: string;
}

export interface Box {
  center: [number, number, number];
  size: [number, number, number];
  yaw: number;
  friction: number;
}

export interface ScenarioInfo {
  id: string; // scenario/variant
  scenario: string;
  variant: string;
  summary: string;
  duration_s: number | null; // null: the scenario could not be read
  metric_leg: string; // LF, RF, LH, RH or all
  set: "paper" | "extra";
  seed: number; // duration, boxes and friction are those of this seed and setting
  setting?: number;
  boxes: Box[];
  friction: number | null;
  robot: number | null; // index into robots; null: it could not be read
}

export type Interval = [number, number];

// A row of `dobbench table --format json --timing`, over seeds.
export interface Row {
  scenario: string;
  variant: string;
  observer: string;
  profile: string;
  observer_id: string;
  scenario_id: string;
  setting: number;
  seeds: number;
  runs: number;
  falls: number;
  falls_ci95: Interval | null;
  errors: number;
  oracle: boolean;
  rank: number | null;
  reference: string | null;
  paired_runs: number | null;
  fall_time_median_s: number | null;
  fall_reason: string | null;
  error_reason: string | null;
  [field: string]: unknown; // METRIC, METRIC_worst, METRIC_ci95, paired_METRIC, ...
}

export type Outcome = "survived" | "fell" | "error" | "pending";

export interface Cell {
  scenario_id: string;
  observer_id: string;
  setting: number;
  seed: number;
  outcome: Outcome;
  fall_time_s: number | null;
  reason: string | null;
  com_error_max_m: number | null;
  com_error_rms_m: number | null;
  path_error_max_m: number | null;
  foot_error_max_m: number | null;
  grf_error_mean_N: number | null;
  estimate_rmse_N: number | null;
  orientation_error_max_rad: number | null;
  trace: number | null; // index into traces
}

export interface Contrast {
  name: string;
  recorded: boolean;
  holds: boolean | null;
  measured: string;
}

// A row of `dobbench table --claims --format json`.
export interface Claim {
  id: string;
  case: string;
  cells: string;
  claim: string;
  kind: string;
  source: string;
  paper: string;
  observer: string;
  profile: string | null;
  gains: string | null;
  planner: string | null;
  overrides: string;
  measured: string;
  holds: boolean | null;
  ours_measured: string | null;
  ours_holds: boolean | null;
  note: string;
  contrasts?: Contrast[];
}

export interface Histogram {
  edges_us: number[]; // one more than counts
  counts: number[];
}

export interface Timing {
  scenario_id: string;
  observer_id: string;
  setting: number;
  tick_p50_us: number | null;
  tick_p99_us: number | null;
  tick_max_us: number | null;
  qp_p50_us: number | null;
  qp_p99_us: number | null;
  qp_max_us: number | null;
  real_time_factor: number | null;
  tick_histogram: Histogram | null;
  qp_histogram: Histogram | null;
}

export interface Shape {
  kind: "box" | "cylinder" | "sphere";
  size: [number, number, number];
  position: [number, number, number];
  rotation: number[]; // 9, row major
}

export interface Link {
  name: string;
  parent: number; // -1: none
  joint: number; // -1: none; 3 * leg + (0, 1, 2)
  origin: [number, number, number];
  axis: [number, number, number];
  shapes: Shape[];
}

export interface Foot {
  leg: string;
  link: number;
  center: [number, number, number];
  radius: number;
}

export interface Robot {
  name: string;
  mass_kg: number;
  links: Link[];
  feet: Foot[];
}

export interface SignalCode {
  name: string;
  offset: number;
  scale: number;
}

export interface TraceInfo {
  cell: number;
  scenario_id: string;
  observer_id: string;
  setting: number;
  seed: number;
  bytes: number;
  replay: { rate_Hz: number; frames: number; signals: SignalCode[] };
  plots: { buckets: number; bucket_s: number; points: number; signals: SignalCode[] };
  swings: Record<string, Interval[]>;
  disturbed: Interval[];
  end_s: number;
}

export interface CampaignAxis {
  name: string;
  unit: string; // "": a plain number
  levels: number[]; // from the mildest to the hardest; the numbers may descend
  logarithmic: boolean;
}

export interface LevelResult {
  level: [number, number]; // indices into the levels of the curve's axes
  planned: number;
  trials: number; // that survived or fell
  falls: number;
  errors: number;
  falls_ci95: Interval | null;
  com_error_m: number | null; // median over the survivors
  com_error_ci95: Interval | null;
  foot_error_m: number | null;
  foot_error_ci95: Interval | null;
}

// The level at which a share of the trials falls.
export interface FallThreshold {
  estimate: number;
  ci95: Interval;
  below: boolean; // the interval reaches the mildest level and says no more than "milder"
  above: boolean; // the hardest one
}

export interface CampaignCurve {
  scenario_id: string;
  observer_id: string; // of Campaign::observers, setting of Campaign::settings
  setting: number;
  axes: number[];
  factors: string[];
  levels: LevelResult[];
  fall_50: FallThreshold | null;
  fall_5: FallThreshold | null;
  non_monotone: { seed: number; fell_at: number; survived_at: number }[];
  seeds: number;
  trials: number;
  falls: number;
  errors: number;
}

export interface VarianceShare {
  factor: string;
  levels: number; // 0: the residual
  share: number;
  ci95: Interval | null;
}

export interface Factorial {
  response: string;
  trials: number;
  left_out: number;
  shares: VarianceShare[];
}

export interface Campaign {
  kind: "limit" | "map" | "breakdown" | "factorial";
  name: string;
  summary: string;
  document: string;
  axes: CampaignAxis[];
  factors: string[];
  planned: number;
  finished: number;
  observers: ObserverInfo[];
  settings: Setting[];
  curves: CampaignCurve[];
  factorial: Factorial[];
  reasons: { reason: string; cells: number }[]; // why cells could not be run
}

// Of a campaign there are no rows and claims, and of its cells those with time series only.
export interface Report {
  schema: number;
  title: string;
  run: Run;
  campaign: Campaign | null;
  written_by: { version: string; commit: string };
  observers: ObserverInfo[];
  settings: Setting[];
  scenarios: ScenarioInfo[];
  rows: Row[];
  cells: Cell[];
  claims: Claim[];
  timing: Timing[];
  robots: Robot[];
  traces: TraceInfo[];
  left_out: { what: string; why: string }[];
  missing: string[];
}
