// One colour per observer, the same in every plot, in the replay and in the printed figures: after Okabe and Ito, to be
// told apart by the colour-blind. The dash is the page's own: it tells profiles apart, and observers without a colour of
// their own when these colours come round again. The symbol tells observers apart without any colour.
import type { Theme } from "./state";

const kNamed: Record<string, string> = {
  none: "#777777",
  momentum: "#0072B2",
  com_wrench: "#E69F00",
  nonlinear_dob: "#009E73",
  momentum_com: "#D55E00",
};

const kOracle = { light: "#000000", dark: "#C8C8C8" };

const kOthers = ["#CC79A7", "#56B4E9", "#B8A900", "#8C564B", "#4C4C9D", "#66A61E"];
// Two of them are too dark for a dark page.
const kOthersDark = ["#CC79A7", "#56B4E9", "#B8A900", "#B98579", "#8C8CDB", "#66A61E"];

// A round of kOthers each: of the first three profiles, and of an oracle. As plotly names or writes them.
const kDashes = [
  ["solid", "dot", "dashdot", "dash"],
  ["10px,3px", "2px,5px", "10px,3px,2px,3px", "6px,6px"],
  ["14px,2px,2px,2px", "1px,8px", "5px,2px,2px,2px,2px,2px", "4px,2px"],
  ["18px,4px", "4px,8px", "12px,4px,4px,4px", "9px,9px"],
] as const;

// Shapes of markers (plotly's names).
const kSymbols: Record<string, string> = {
  none: "circle",
  momentum: "square",
  com_wrench: "diamond",
  nonlinear_dob: "triangle-up",
  momentum_com: "triangle-down",
  oracle_full: "pentagon",
};
const kOtherSymbols = ["hexagon", "star", "triangle-left", "triangle-right", "cross", "hourglass", "bowtie"];

export interface ObserverStyle {
  color: string;
  dash: string; // of plotly: solid, dash, dot, dashdot, or lengths in px
  symbol: string;
}

interface Named {
  id: string;
  observer: string;
  profile: string;
  oracle: boolean;
}

// Styles by observer id. Profiles of one observer share its colour and differ by dash, tuned or the only one solid; no two of up to
// 24 observers without a name above share both.
export function observerStyles(observers: readonly Named[], theme: Theme): Map<string, ObserverStyle> {
  const others = theme === "dark" ? kOthersDark : kOthers;
  const names = [...new Set(observers.map((o) => o.observer))];
  const unnamed = names.filter((name) => !(name in kNamed) && name !== "oracle_full");
  const profilesOf = (name: string) => observers.filter((o) => o.observer === name).map((o) => o.profile).sort(tunedFirst);
  const styles = new Map<string, ObserverStyle>();
  for (const o of observers) {
    const i = unnamed.indexOf(o.observer); // -1: it has a colour of its own
    const color =
      o.observer === "oracle_full"
        ? kOracle[theme]
        : (kNamed[o.observer] ?? others[i % others.length] ?? "#777777");
    const round = Math.max(0, Math.floor(i / others.length)) % kDashes.length;
    const dash = kDashes[round]![o.oracle ? 3 : profilesOf(o.observer).indexOf(o.profile) % 3]!;
    const symbol = kSymbols[o.observer] ?? kOtherSymbols[i % kOtherSymbols.length] ?? "circle";
    styles.set(o.id, { color, dash, symbol });
  }
  return styles;
}

function tunedFirst(a: string, b: string): number {
  return Number(b === "tuned") - Number(a === "tuned");
}
