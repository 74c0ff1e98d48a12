// Stands in for replay/replay.ts.
import type { Report } from "./data";
import { h, replaceContent } from "./dom";

export class Replay {
  constructor(
    private readonly host: HTMLElement,
    readonly data: Report,
  ) {}

  show(traces: { index: number; label: string; color: string }[], mode: "side" | "ghost"): Promise<void> {
    replaceContent(this.host, h("p", { class: "empty" }, `Replay (${mode}): ${traces.map((t) => t.label).join(", ")}`));
    return Promise.resolve();
  }

  dispose(): void {
    replaceContent(this.host);
  }
}
