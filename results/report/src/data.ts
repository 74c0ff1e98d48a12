// The data that `dobbench report` puts into the page, and the decoding of its traces.
import type { Report, SignalCode, TraceInfo } from "./types";

export type * from "./types";

export const kLegs = ["LF", "RF", "LH", "RH"] as const;

const kSchema = 3;
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
