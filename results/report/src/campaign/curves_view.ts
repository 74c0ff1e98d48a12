// Limits and breakdowns: an overview of the thresholds, and one block in detail.
import type { Campaign, CampaignCurve, Report } from "../data";
import { h, replaceContent, select } from "../dom";
import { plural } from "../format";
import { drawComErrors, drawFallShares } from "../plots/fall_curves";
import { Figure } from "../plots/figure";
import { type Block, blocksOf } from "./blocks";
import { ProfileChoice } from "./profile_choice";
import { thresholdMatrix, thresholdTable } from "./thresholds";

export class CurvesView {
  readonly element = h("div", {});
  private readonly blocks: Block[];
  private readonly profiles: ProfileChoice;
  private readonly overview = h("div", {});
  private readonly bar = h("div", { class: "bar" });
  private readonly name = h("p", { class: "note", "data-test": "campaign-block-name" });
  private readonly table = h("div", {});
  private readonly figures: Figure[];
  private chosen = 0;

  constructor(
    private readonly report: Report,
    private readonly campaign: Campaign,
  ) {
    this.blocks = blocksOf(campaign);
    this.profiles = new ProfileChoice(campaign, () => this.refresh());
    const figure = (id: string, title: string, note: string, draw: typeof drawFallShares): Figure =>
      new Figure({ id, title, note, fileName: () => this.fileName(id), draw: async (theme, width) => draw({ report, campaign, block: this.shown() }, theme, width) });
    this.figures = [
      figure("fall_share", "Falls", "share of the trials that fell, with Wilson intervals (95 %, from 8 trials on); bars: where 50 % (broad) and 5 % (thin, hollow mark) fall, with 95 %; observers side by side within a level", drawFallShares),
      figure("com_level", "CoM error", "largest one of a trial, median over those that survived; interval from 8 on", drawComErrors),
    ];
    this.element.append(this.overview, this.bar, this.name, ...this.figures.map((f) => f.element), this.table);
    this.drawBar();
    this.refresh();
  }

  private fileName(id: string): string {
    return `${this.report.title}-${id}-${this.chosen + 1}`;
  }

  // The chosen block with the curves of the chosen profile.
  private shown(): Block {
    const block = this.blocks[this.chosen]!;
    return { ...block, curves: this.profiles.of(block.curves) };
  }

  private choose(block: number): void {
    this.chosen = block;
    this.refresh();
  }

  private drawBar(): void {
    const choices = this.blocks.map((block, i) => ({ value: String(i), text: block.name }));
    const blocks = choices.length > 1 && select("Shown", choices, String(this.chosen), (i) => this.choose(Number(i)), "campaign-block");
    replaceContent(this.bar, blocks, this.profiles.element);
  }

  private refresh(): void {
    const { campaign } = this;
    const block = this.shown();
    const choice = this.bar.querySelector("select");
    if (choice) choice.value = String(this.chosen);
    this.name.textContent = `${block.whole}: ${plural(sum(block.curves, "trials"), "trial")}, ${plural(sum(block.curves, "falls"), "fall")}.`;
    const pressed = (document.activeElement as HTMLElement | null)?.dataset["block"];
    if (this.blocks.length > 1) {
      const shown = this.blocks.map((b) => ({ ...b, curves: this.profiles.of(b.curves) }));
      replaceContent(this.overview, thresholdMatrix(campaign, shown, this.chosen, (i) => this.open(i)));
      if (pressed) this.overview.querySelector<HTMLElement>(`[data-block="${pressed}"]`)?.focus();
    }
    replaceContent(this.table, thresholdTable(campaign, block));
    for (const figure of this.figures) figure.invalidate();
  }

  // A press in the overview: what it is about comes into view.
  private open(block: number): void {
    this.choose(block);
    this.bar.scrollIntoView({ block: "start" });
  }
}

function sum(curves: readonly CampaignCurve[], field: "trials" | "falls"): number {
  return curves.reduce((total, curve) => total + curve[field], 0);
}
