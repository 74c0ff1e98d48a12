// Light or dark: the system's choice until the reader makes one.
import { h } from "./dom";
import { type Theme, theme } from "./state";

export function startTheme(): void {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  let chosen = false;
  const apply = (next: Theme): void => {
    document.documentElement.dataset["theme"] = next;
    theme.set(next);
  };
  apply(dark.matches ? "dark" : "light");
  dark.addEventListener("change", () => {
    if (!chosen) apply(dark.matches ? "dark" : "light");
  });
  chooseTheme = (next) => {
    chosen = true;
    apply(next);
  };
}

let chooseTheme: (next: Theme) => void = () => {};

export function themeToggle(): HTMLElement {
  const text = (): string => (theme.get() === "dark" ? "Light" : "Dark");
  const button = h(
    "button",
    { type: "button", class: "quiet", "data-test": "theme-toggle", onclick: () => chooseTheme(theme.get() === "dark" ? "light" : "dark") },
    text(),
  );
  const name = (): void => {
    button.textContent = text();
    button.setAttribute("aria-label", `Use the ${text().toLowerCase()} theme`);
  };
  name();
  theme.subscribe(name);
  return button;
}
