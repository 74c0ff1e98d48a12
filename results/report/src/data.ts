// The data that `dobbench report` puts into the page, and the decoding of its traces. SI units; times in s; null where
// a value does not apply.

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

export interface Report {
  schema: number;
  title: string;
  run: Run;
  written_by: { version: string; commit: string };
  observers: ObserverInfo[];
  settings: Setting[];
  scenarios: ScenarioInfo[];
  rows: Row[];
  cells: Cell[];
  claims: Claim[];
  timing: Timing[];
  robot: Robot | null; // null: it could not be read
  traces: TraceInfo[];
  left_out: { what: string; why: string }[];
  missing: string[];
}

export const kLegs = ["LF", "RF", "LH", "RH"] as const;

const kSchema = 1;
const kNotApplicable = -32768; // code of a value that does not apply

// The report of this page. Throws an Error that says what is wrong with it.
export function readReport(page: Document): Report {
  const element = page.getElementById("report-data");
  if (!element) throw new Error("This page holds no data: it is the empty template. Write one with: dobbench report DIR");
  const report = JSON.parse(element.textContent ?? "") as Report;
  if (report.schema !== kSchema) {
    throw new Error(`This page's data has schema ${report.schema}; the page reads schema ${kSchema}.`);
  }
  return report;
}

export interface Trace {
  readonly info: TraceInfo;
  // Samples at k / rate_Hz; NaN where a value does not apply; null if this trace has no such signal.
  replay(name: string): Float32Array | null;
  // Two points per bucket of bucket_s, its smallest and largest value in their order of time.
  plot(name: string): Float32Array | null;
  // Where the points of plot() stand [s].
  readonly plotTimes: Float32Array;
}

// Decodes trace `index` of the page, once; later calls get the same one.
export function loadTrace(index: number): Promise<Trace> {
  if (!report) report = readReport(document);
  let trace = loaded.get(index);
  if (!trace) {
    trace = decodeTrace(report, index);
    loaded.set(index, trace);
  }
  return trace;
}

let report: Report | null = null;
const loaded = new Map<number, Promise<Trace>>();

async function decodeTrace(data: Report, index: number): Promise<Trace> {
  const info = data.traces[index];
  const text = document.getElementById(`trace-${index}`)?.textContent;
  if (!info || !text) throw new Error(`This page holds no trace ${index}.`);
  return new DecodedTrace(info, await inflate(bytesOfBase64(text)));
}

function bytesOfBase64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text.trim());
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflate(bytes: Uint8Array<ArrayBuffer>): Promise<DataView> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new DataView(await new Response(stream).arrayBuffer());
}

class DecodedTrace implements Trace {
  readonly plotTimes: Float32Array;
  private readonly columns = new Map<string, { code: SignalCode; begin: number; length: number }>();
  private readonly decoded = new Map<string, Float32Array>();

  constructor(
    readonly info: TraceInfo,
    private readonly bytes: DataView,
  ) {
    let begin = this.place("replay", info.replay.signals, info.replay.frames, 0);
    begin = this.place("plot", info.plots.signals, info.plots.points, begin);
    if (2 * begin !== bytes.byteLength) {
      throw new Error(`A trace of ${info.scenario_id} has ${bytes.byteLength} bytes instead of ${2 * begin}.`);
    }
    const width = info.plots.bucket_s;
    this.plotTimes = Float32Array.from({ length: info.plots.points }, (_, i) => (i >> 1) * width + (i % 2 ? 0.75 : 0.25) * width);
  }

  replay(name: string): Float32Array | null {
    return this.decode(`replay ${name}`);
  }

  plot(name: string): Float32Array | null {
    return this.decode(`plot ${name}`);
  }

  private place(kind: string, signals: SignalCode[], length: number, begin: number): number {
    for (const code of signals) {
      this.columns.set(`${kind} ${code.name}`, { code, begin, length });
      begin += length;
    }
    return begin;
  }

  private decode(key: string): Float32Array | null {
    const known = this.decoded.get(key);
    if (known) return known;
    const column = this.columns.get(key);
    if (!column) return null;
    const { code, begin, length } = column;
    const values = new Float32Array(length);
    let q = 0;
    for (let i = 0; i < length; ++i) {
      q = ((q + this.bytes.getInt16(2 * (begin + i), true)) << 16) >> 16; // modulo 2^16
      values[i] = q === kNotApplicable ? NaN : code.offset + code.scale * q;
    }
    this.decoded.set(key, values);
    return values;
  }
}
