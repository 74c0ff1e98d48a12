// One colour and one dash per observer, the same in every plot, in the replay and in the printed figures: after
// Okabe and Ito, to be told apart by the colour-blind. The symbol tells observers apart without any colour.
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
  dash: "solid" | "dash" | "dot" | "dashdot";
  symbol: string;
}

interface Named {
  id: string;
  observer: string;
  profile: string;
  oracle: boolean;
}

// Styles by observer id. Profiles of one observer share its colour and differ by dash.
export function observerStyles(observers: readonly Named[], theme: Theme): Map<string, ObserverStyle> {
  const others = theme === "dark" ? kOthersDark : kOthers;
  const names = [...new Set(observers.map((o) => o.observer))];
  const unnamed = names.filter((name) => !(name in kNamed) && name !== "oracle_full");
  const profiles = [...new Set(observers.map((o) => o.profile))].filter((p) => p !== "-").sort(tunedFirst);
  const styles = new Map<string, ObserverStyle>();
  for (const o of observers) {
    const color =
      o.observer === "oracle_full"
        ? kOracle[theme]
        : (kNamed[o.observer] ?? others[unnamed.indexOf(o.observer) % others.length] ?? "#777777");
    const dash = o.oracle ? "dash" : ((["solid", "dot", "dashdot"] as const)[Math.max(0, profiles.indexOf(o.profile)) % 3] ?? "solid");
    const symbol = kSymbols[o.observer] ?? kOtherSymbols[unnamed.indexOf(o.observer) % kOtherSymbols.length] ?? "circle";
    styles.set(o.id, { color, dash, symbol });
  }
  return styles;
}

function tunedFirst(a: string, b: string): number {
  return Number(b === "tuned") - Number(a === "tuned");
}
