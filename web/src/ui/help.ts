// SPDX-License-Identifier: Apache-2.0
import { el, icon } from "./dom";
import { icons } from "./icons";

const keysOfSolids: [string, string][] = [
  ["Drag", "turn"],
  ["Right drag, two fingers", "move"],
  ["Wheel, pinch", "zoom to the pointer"],
  ["Click", "pick a face"],
  ["F, double click", "fit everything"],
  ["1 2 3 4", "front, right, top, oblique"],
  ["E  W  N", "edges, triangles, normals"],
  ["S", "section; then X Y Z, C for the other side"],
  ["A", "pull the pieces apart"],
  ["M", "measure between two points"],
  ["O", "parallel or perspective"],
  ["I  L", "facts, light or dark"],
  ["Esc", "let go"],
];

export function helpSheet(keys = keysOfSolids): HTMLDialogElement {
  const list = el("dl", { class: "keys" });
  for (const [key, what] of keys) {
    const names = /^[A-Z1-9]( |$)/.test(key) ? key.split(/ +/).map((k) => el("kbd", {}, k)) : [el("span", {}, key)];
    list.append(el("dt", {}, ...names), el("dd", {}, what));
  }
  const dialog = el("dialog", { class: "help glass", "aria-label": "Keys", tabindex: -1, autofocus: true });
  const close = el("button", { type: "button", class: "round", "aria-label": "Close", onclick: () => dialog.close() }, icon(icons.close));
  dialog.append(el("header", {}, el("h2", {}, "Mouse and keys"), close), list);
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  return dialog;
}
