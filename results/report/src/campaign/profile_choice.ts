// Which profile's curves are shown: of many curves the tuned ones at first, of few all.
import type { Campaign, CampaignCurve } from "../data";
import { choiceButtons } from "../dom";
import { inProfile, profilesOf } from "../summary";
import { blocksOf, observerOf } from "./blocks";

const kMany = 8; // curves in one plot

export class ProfileChoice {
  readonly element: HTMLElement | null = null; // null: there is nothing to choose
  private profile: string | null = null;

  constructor(
    private readonly campaign: Campaign,
    changed: () => void,
  ) {
    const profiles = profilesOf(campaign);
    if (profiles.length < 2) return;
    if (blocksOf(campaign).some((block) => block.curves.length > kMany)) this.profile = profiles[0]!;
    const choices = [...profiles.map((p) => ({ value: p, text: p })), { value: "", text: "all" }];
    const change = (profile: string): void => {
      this.profile = profile || null;
      changed();
    };
    this.element = choiceButtons("Profile", choices, this.profile ?? "", change, "campaign-profile");
  }

  of(curves: readonly CampaignCurve[]): CampaignCurve[] {
    return curves.filter((curve) => inProfile(observerOf(this.campaign, curve), this.profile));
  }
}
