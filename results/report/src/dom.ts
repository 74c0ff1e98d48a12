// Elements without a framework. Text goes in as text only, never as markup.

export type Child = Node | string | null | undefined | false;
type Value = string | number | boolean | null | undefined | ((event: Event) => void);

const kSvg = "http://www.w3.org/2000/svg";

// h("button", {class: "chip", "aria-pressed": true, onclick: () => ...}, "text"). An attribute that is null, undefined
// or false is left out, except that aria-* and data-* write "false".
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, Value> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  setAttributes(element, attributes);
  append(element, children);
  return element;
}

export function svg(tag: string, attributes: Record<string, Value> = {}, ...children: Child[]): SVGElement {
  const element = document.createElementNS(kSvg, tag);
  setAttributes(element, attributes);
  append(element, children);
  return element;
}

export function replaceContent(element: Element, ...children: Child[]): void {
  element.replaceChildren();
  append(element, children);
}

// A name that may break after its separators.
export function breakable(name: string): HTMLSpanElement {
  const parts = name.split(/(?<=[_,:;=/])/);
  return h("span", {}, ...parts.flatMap((part, i) => (i === 0 ? [part] : [h("wbr"), part])));
}

function append(element: Element, children: Child[]): void {
  for (const child of children) {
    if (child !== null && child !== undefined && child !== false) element.append(child);
  }
}

function setAttributes(element: Element, attributes: Record<string, Value>): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") {
      element.addEventListener(name.slice(2), value);
    } else if (value === false && !name.startsWith("aria-") && !name.startsWith("data-")) {
      continue;
    } else if (value !== null && value !== undefined) {
      element.setAttribute(name, value === true && !name.startsWith("aria-") ? "" : String(value));
    }
  }
}

// A labelled <select>. `choices`: value and text, or groups of these.
export interface Choice {
  value: string;
  text: string;
  group?: string;
}

export function select(
  label: string,
  choices: readonly Choice[],
  chosen: string,
  change: (value: string) => void,
  test?: string,
): HTMLLabelElement {
  const element = h("select", { "data-test": test, onchange: () => change(element.value) });
  const groups = new Map<string, HTMLOptGroupElement>();
  for (const choice of choices) {
    const option = h("option", { value: choice.value, selected: choice.value === chosen }, choice.text);
    let parent: HTMLElement = element;
    if (choice.group !== undefined) {
      const known = groups.get(choice.group) ?? h("optgroup", { label: choice.group });
      if (!groups.has(choice.group)) element.append(known);
      groups.set(choice.group, known);
      parent = known;
    }
    parent.append(option);
  }
  return h("label", { class: "field" }, h("span", {}, label), element);
}

// Buttons of which one is pressed.
export function choiceButtons(
  label: string,
  choices: readonly Choice[],
  chosen: string,
  change: (value: string) => void,
  test?: string,
): HTMLElement {
  const buttons = choices.map(({ value, text }) =>
    h("button", { type: "button", "data-value": value, "aria-pressed": value === chosen, onclick: () => press(value) }, text),
  );
  const press = (value: string): void => {
    for (const button of buttons) button.setAttribute("aria-pressed", String(button.dataset.value === value));
    change(value);
  };
  return h(
    "div",
    { class: "field", role: "group", "aria-label": label, "data-test": test },
    h("span", { "aria-hidden": true }, label),
    h("span", { class: "segments" }, ...buttons),
  );
}
