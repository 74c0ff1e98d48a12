// Tabs with roles: arrow keys move between them, only the chosen panel is shown.
import { h } from "./dom";

export interface Tab {
  id: string;
  text: string;
  panel: HTMLElement;
}

export function tabList(label: string, tabs: readonly Tab[], test: string): HTMLElement {
  const buttons = tabs.map(({ id, text, panel }) => {
    panel.id = `panel-${id}`;
    panel.setAttribute("role", "tabpanel");
    panel.setAttribute("aria-labelledby", `tab-${id}`);
    return h(
      "button",
      { type: "button", role: "tab", id: `tab-${id}`, "aria-controls": panel.id, "data-test": `tab-${id}`, onclick: () => choose(id) },
      text,
    );
  });
  const choose = (id: string): void => {
    tabs.forEach((tab, i) => {
      const chosen = tab.id === id;
      buttons[i]!.setAttribute("aria-selected", String(chosen));
      buttons[i]!.tabIndex = chosen ? 0 : -1;
      tab.panel.hidden = !chosen;
    });
  };
  const step = (event: KeyboardEvent): void => {
    const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
    const next = { ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: buttons.length - 1 }[event.key];
    if (at < 0 || next === undefined) return;
    event.preventDefault();
    const button = buttons[(next + buttons.length) % buttons.length]!;
    button.focus();
    button.click();
  };
  choose(tabs[0]!.id);
  const list = h("div", { role: "tablist", class: "tabs", "aria-label": label, "data-test": test }, ...buttons);
  list.addEventListener("keydown", step);
  return list;
}
