// What stands in a run's corner of the picture: its name, and its fall from that moment on.
import type { Actor } from "./actor";

export function caption(actor: Actor, t: number): HTMLElement {
  const line = document.createElement("div");
  const name = document.createElement("span");
  name.className = "replay-name";
  name.style.setProperty("--run", actor.color);
  name.textContent = actor.label;
  line.append(name);
  const fall = actor.fall(t);
  if (fall) {
    const note = document.createElement("span");
    note.className = "replay-fell";
    note.textContent = fall;
    line.append(note);
  }
  return line;
}
