// SPDX-License-Identifier: Apache-2.0
import { el, icon, rows } from "../ui/dom";
import { icons } from "../ui/icons";
import type { Cell } from "./data";

const nouns = { face: "face", edge: "edge", point: "vertex" };

/** What is known about a cell; with `close`, the card of a picked one. */
export class CellCard {
  readonly element = el("div", { class: "card glass", hidden: true });

  constructor(private readonly close?: () => void) {
    if (close) this.element.setAttribute("aria-live", "polite");
    else this.element.classList.add("passing");
  }

  show(cell: Cell | undefined): void {
    this.element.hidden = !cell;
    if (!cell) return;
    // The label or the kind, unless the name says it.
    const aside = cell.label && !cell.name.includes(cell.label) ? cell.label : nouns[cell.kind];
    const header = el("header", {}, el("h2", {}, cell.name), el("span", { class: "of" }, cell.name.toLowerCase().includes(aside) ? "" : aside));
    if (this.close) {
      header.append(el("button", { type: "button", "aria-label": "Close", onclick: () => this.close?.() }, icon(icons.close)));
    }
    this.element.replaceChildren(header, rows(cell.facts));
  }
}
