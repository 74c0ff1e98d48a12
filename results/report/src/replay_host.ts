// Where the 3D replay stands: made when it first comes into view, told what to show from then on.
import { observerStyles } from "./colors";
import type { Report } from "./data";
import { h, replaceContent } from "./dom";
import { shortName } from "./format";
import { kNoRobot, robotOf } from "./kinematics";
import type { Replay } from "./replay/replay";
import { type Selection, shownTraces } from "./selection";
import { theme } from "./state";

export class ReplayHost {
  readonly element = h("div", { class: "replay-column" });
  private readonly host = h("div", { id: "replay", class: "replay", "data-test": "replay" });
  private readonly choice = h("div", { class: "bar" });
  private replay: Replay | null = null;
  private visible = false;
  private second = ""; // id of the observer beside the one in detail; "": none
  private mode: "side" | "ghost" = "side";
  private turn = 0; // only what was asked for last appears

  constructor(
    private readonly report: Report,
    private readonly selection: Selection,
  ) {
    this.element.append(this.choice, this.host);
    const watch = new IntersectionObserver(([entry]) => {
      this.visible = entry?.isIntersecting ?? false;
      this.show();
    });
    watch.observe(this.element);
    for (const signal of [selection.scenario, selection.shown, selection.focus, selection.seed, selection.setting, theme]) {
      signal.subscribe(() => this.show());
    }
  }

  private show(): void {
    if (!this.visible) return;
    const { report, selection } = this;
    const traces = shownTraces(report, selection);
    const first = traces.find((t) => t.info.observer_id === selection.focus.get()) ?? traces[0];
    this.choice.hidden = !first;
    if (!first) {
      this.sayWhyNot("empty", "This page holds no replay of this scenario with these observers.");
      return;
    }
    if (!robotOf(report, first.info.scenario_id)) {
      this.sayWhyNot("replay-none", `No replay: ${kNoRobot}`);
      return;
    }
    this.drawChoice(traces.map((t) => t.info.observer_id), first.info.observer_id);
    const second = traces.find((t) => t.info.observer_id === this.second && t !== first);
    const styles = observerStyles(report.observers, theme.get());
    const shown = [first, ...(second ? [second] : [])].map(({ index, info }) => ({
      index,
      label: shortName(info.observer_id),
      color: styles.get(info.observer_id)!.color,
    }));
    void this.play(shown);
  }

  private sayWhyNot(kind: string, sentence: string): void {
    ++this.turn;
    this.replay?.dispose();
    this.replay = null;
    replaceContent(this.host, h("p", { class: kind }, sentence));
  }

  private async play(shown: { index: number; label: string; color: string }[]): Promise<void> {
    const turn = ++this.turn;
    const { Replay } = await import("./replay/replay"); // as plotly: evaluated when it is needed
    if (turn !== this.turn) return;
    if (!this.replay) {
      replaceContent(this.host);
      this.replay = new Replay(this.host, this.report);
    }
    await this.replay.show(shown, this.mode);
  }

  private drawChoice(ids: string[], first: string): void {
    const others = ids.filter((id) => id !== first);
    const options = (list: string[], chosen: string): HTMLOptionElement[] =>
      list.map((id) => h("option", { value: id, selected: id === chosen }, id === "" ? "nobody" : shortName(id, 40)));
    const focus = h("select", { "data-test": "replay-first", onchange: () => this.selection.focus.set(focus.value) }, ...options(ids, first));
    const second = h("select", { "data-test": "replay-second", onchange: () => ((this.second = second.value), this.show()) }, ...options(["", ...others], this.second));
    const mode = h(
      "select",
      { "data-test": "replay-mode", disabled: this.second === "", onchange: () => ((this.mode = mode.value as "side" | "ghost"), this.show()) },
      h("option", { value: "side", selected: this.mode === "side" }, "side by side"),
      h("option", { value: "ghost", selected: this.mode === "ghost" }, "as a ghost"),
    );
    const focused = document.activeElement?.getAttribute("data-test");
    const field = (label: string, input: HTMLElement): HTMLElement => h("label", { class: "field" }, h("span", {}, label), input);
    replaceContent(this.choice, field("In detail", focus), field("beside", second), field("", mode));
    if (focused) this.choice.querySelector<HTMLElement>(`[data-test="${focused}"]`)?.focus();
  }
}
