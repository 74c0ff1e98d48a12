// Tables whose headings sort: a button in each heading, the order in aria-sort, the numbers or texts as given.
import { type Child, h } from "./dom";

export type Key = number | string | null; // null is always last

export interface Column<T> {
  id: string;
  heading: Child;
  key?: (item: T) => Key; // without it the column does not sort
  class?: string;
}

export interface Order {
  column: string;
  descending: boolean;
}

export function sorted<T>(items: readonly T[], columns: readonly Column<T>[], order: Order | null): T[] {
  const key = columns.find((c) => c.id === order?.column)?.key;
  if (!key || !order) return [...items];
  const sign = order.descending ? -1 : 1;
  return [...items].sort((a, b) => compare(key(a), key(b), sign));
}

function compare(a: Key, b: Key, sign: number): number {
  if (a === null || b === null) return Number(a === null) - Number(b === null);
  if (typeof a === "number" && typeof b === "number") return sign * (a - b);
  return sign * String(a).localeCompare(String(b), "en", { numeric: true });
}

// The row of headings. `change` gets the order that a press asks for: ascending, descending, as it was.
export function headings<T>(columns: readonly Column<T>[], order: Order | null, change: (order: Order | null) => void): HTMLElement {
  return h("tr", {}, ...columns.map((column) => heading(column, order, change)));
}

function heading<T>(column: Column<T>, order: Order | null, change: (order: Order | null) => void): HTMLElement {
  if (!column.key) return h("th", { scope: "col", class: column.class }, column.heading);
  const own = order?.column === column.id ? order : null;
  const next = !own ? { column: column.id, descending: false } : own.descending ? null : { ...own, descending: true };
  const button = h(
    "button",
    { type: "button", class: "sort", "data-test": "sort", "data-column": column.id, onclick: () => change(next) },
    column.heading,
    h("span", { class: "arrow", "aria-hidden": true }, own ? (own.descending ? "\u25BC" : "\u25B2") : ""),
  );
  const state = own ? (own.descending ? "descending" : "ascending") : "none";
  return h("th", { scope: "col", class: column.class, "aria-sort": state }, button);
}

// After a table was drawn anew, the keyboard's focus goes back to the heading that was pressed.
export function focusHeading(table: Element, column: string): void {
  table.querySelector<HTMLElement>(`button.sort[data-column="${CSS.escape(column)}"]`)?.focus();
}
