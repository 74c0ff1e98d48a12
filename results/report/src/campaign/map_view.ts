// Maps: one per observer, of the share of falls or of the CoM error.
import type { Campaign, Report } from "../data";
import { choiceButtons, h, replaceContent, select } from "../dom";
import { type Block, blocksOf, observerOf } from "./blocks";
import { heatKey, heatMap, kHeats } from "./heat_map";
import { ProfileChoice } from "./profile_choice";

export class MapView {
  readonly element = h("div", {});
  private readonly blocks: Block[];
  private readonly profiles: ProfileChoice;
  private readonly maps = h("div", { class: "heats" });
  private readonly note = h("p", { class: "note legend" });
  private chosen = 0;
  private heat = kHeats[0]!;

  constructor(
    _report: Report,
    private readonly campaign: Campaign,
  ) {
    this.blocks = blocksOf(campaign);
    this.profiles = new ProfileChoice(campaign, () => this.draw());
    this.element.append(this.bar(), this.note, this.maps);
    this.draw();
  }

  private bar(): HTMLElement {
    const blocks = this.blocks.map((block, i) => ({ value: String(i), text: block.name }));
    const choose = (i: string): void => {
      this.chosen = Number(i);
      this.draw();
    };
    const colour = (id: string): void => {
      this.heat = kHeats.find((heat) => heat.id === id) ?? kHeats[0]!;
      this.draw();
    };
    return h(
      "div",
      { class: "bar" },
      blocks.length > 1 && select("Shown", blocks, "0", choose, "campaign-block"),
      choiceButtons("Colour", kHeats.map(({ id, title }) => ({ value: id, text: title })), this.heat.id, colour, "heat-metric"),
      this.profiles.element,
    );
  }

  private draw(): void {
    const block = this.blocks[this.chosen]!;
    const curves = this.profiles.of(block.curves);
    const [across, up] = [block.axes[0]!, block.axes[1]!];
    const most = Math.max(...curves.flatMap((curve) => curve.levels.map((level) => this.heat.value(level) ?? 0)));
    const where = `${block.whole}. Harder to the right and upwards.`;
    replaceContent(this.note, h("span", {}, where), ...heatKey(this.heat, most));
    replaceContent(this.maps, ...curves.map((curve) => heatMap(observerOf(this.campaign, curve).id, curve, across, up, this.heat, most)));
  }
}
