// SPDX-License-Identifier: Apache-2.0
import { Theme } from "../theme";
import { el, rows } from "../ui/dom";
import { helpSheet } from "../ui/help";
import { Toolbar, type Tool } from "../ui/toolbar";
import { CellCard } from "./cell_card";
import { kinds, type Cell, type CellKind, type CellsData } from "./data";
import type { CellsView, Layer } from "./view";

const isNarrow = () => innerWidth <= 760;
const clickReach = 5; // pixels that the pointer may move during a click

/** What tests, and people at the console, may ask of the page. */
export interface CellsHook {
  ready: boolean;
  error?: string;
  counts?: Record<CellKind, number>;
  pick?(x: number, y: number): Cell | undefined;
  picked?(): Cell | undefined;
  hovered?(): Cell | undefined;
}

/** A picture and all around it: heading, facts, cards, tools and keys. */
export class CellsPage {
  private readonly theme = new Theme(() => this.applyTheme());
  private readonly toolbar: Toolbar;
  private readonly panel: HTMLElement;
  private readonly hoverCard = new CellCard();
  private readonly pickedCard = new CellCard(() => this.pick(undefined));
  private readonly help: HTMLDialogElement;
  private readonly shown: Record<Layer, boolean> = { points: true, edges: true, faces: true, labels: true };
  private picked: Cell | undefined;
  private hovered: Cell | undefined;
  private pressed: { x: number; y: number } | undefined;
  private pointer: { x: number; y: number } | undefined;

  constructor(
    host: HTMLElement,
    private readonly data: CellsData,
    private readonly view: CellsView,
    keys: [string, string][],
  ) {
    this.panel = this.makePanel();
    this.panel.hidden = isNarrow();
    this.help = helpSheet([...keys, ...commonKeys]);
    const tools = this.tools();
    this.toolbar = new Toolbar(tools);
    const cards = el("div", { class: "cards" }, this.hoverCard.element, this.pickedCard.element);
    host.append(view.element, this.heading(), this.panel, el("div", { class: "bottom" }, cards, this.toolbar.element), this.help);
    this.listenToPointer();
    this.listenToKeys(tools.flat());
    addEventListener("resize", () => this.makeRoom());
    this.makeRoom();
    this.applyTheme();
    view.fit();
  }

  hook(): CellsHook {
    const { face, edge, point } = this.data.cells;
    return {
      ready: true,
      counts: { face: face.length, edge: edge.length, point: point.length },
      pick: (x, y) => this.view.cellAt(x, y),
      picked: () => this.picked,
      hovered: () => this.hovered,
    };
  }

  private pick(cell: Cell | undefined): void {
    this.picked = cell;
    this.pickedCard.show(cell);
    this.light();
  }

  private hover(cell: Cell | undefined): void {
    if (cell === this.hovered) return;
    this.hovered = cell;
    this.light();
  }

  private light(): void {
    const passing = this.hovered === this.picked ? undefined : this.hovered;
    this.hoverCard.show(passing);
    this.view.light(passing, this.picked);
  }

  /** The next cell of the kind of the picked one, or the first face. */
  private stepThrough(by: number): void {
    const kind = this.picked?.kind ?? kinds.find((k) => this.data.cells[k].length > 0);
    if (!kind) return;
    const cells = this.data.cells[kind];
    const from = this.picked ? this.picked.index : by > 0 ? -1 : 0;
    this.pickAndBring(cells[(from + by + cells.length) % cells.length]);
  }

  private pickAndBring(cell: Cell | undefined): void {
    if (!cell) return;
    this.hovered = undefined;
    this.pick(cell);
    this.view.bring(cell);
  }

  private tools(): Tool[][] {
    const layer = (name: Layer, shownAs: string, key: string, glyph: Tool["icon"]): Tool => ({
      icon: glyph,
      name: shownAs,
      key,
      isOn: () => this.shown[name],
      run: () => {
        this.shown[name] = !this.shown[name];
        this.view.show(name, this.shown[name]);
        this.toolbar.refresh();
      },
      isHidden: name === "labels" && !kinds.some((kind) => this.data.cells[kind].some((cell) => cell.label)),
    });
    const run = (action: () => void) => () => {
      action();
      this.toolbar.refresh();
    };
    return [
      [{ icon: "fit", name: "Fit", key: "F", run: () => this.view.fit() }, ...this.view.tools(() => this.toolbar.refresh())],
      [
        layer("points", "Vertices", "V", "points"),
        layer("edges", "Edges", "E", "curves"),
        layer("faces", "Faces", "C", "faces"),
        layer("labels", "Labels", "T", "labels"),
      ],
      [
        { icon: "theme", name: "Light or dark", key: "L", run: run(() => this.theme.toggle()) },
        {
          icon: "info",
          name: "Facts",
          key: "I",
          isOn: () => !this.panel.hidden,
          run: run(() => {
            this.panel.hidden = !this.panel.hidden;
            this.makeRoom();
          }),
        },
        { icon: "help", name: "Keys", key: "?", run: () => this.help.showModal() },
      ],
    ];
  }

  private listenToPointer(): void {
    const { element } = this.view;
    let isScheduled = false;
    const look = () => {
      isScheduled = false;
      this.hover(this.pointer && this.view.cellAt(this.pointer.x, this.pointer.y));
    };
    element.addEventListener("pointermove", (event) => {
      if (event.pointerType === "touch" || event.buttons !== 0) return;
      this.pointer = { x: event.clientX, y: event.clientY };
      if (isScheduled) return;
      isScheduled = true;
      requestAnimationFrame(look);
    });
    element.addEventListener("pointerleave", () => {
      this.pointer = undefined;
      this.hover(undefined);
    });
    element.addEventListener("pointerdown", (event) => {
      this.pressed = event.isPrimary && event.button === 0 ? { x: event.clientX, y: event.clientY } : undefined;
    });
    element.addEventListener("pointerup", (event) => {
      const from = this.pressed;
      this.pressed = undefined;
      if (!from || Math.hypot(event.clientX - from.x, event.clientY - from.y) > clickReach) return;
      this.pick(this.view.cellAt(event.clientX, event.clientY));
    });
    element.addEventListener("dblclick", () => this.view.fit());
  }

  private listenToKeys(tools: Tool[]): void {
    const byKey = new Map<string, () => void>(tools.filter((tool) => !tool.isHidden).map((tool) => [tool.key.toLowerCase(), tool.run]));
    byKey.set("arrowleft", () => this.view.step(-1, 0));
    byKey.set("arrowright", () => this.view.step(1, 0));
    byKey.set("arrowup", () => this.view.step(0, -1));
    byKey.set("arrowdown", () => this.view.step(0, 1));
    for (const key of ["+", "="]) byKey.set(key, () => this.view.zoom(1.25));
    byKey.set("-", () => this.view.zoom(0.8));
    byKey.set("n", () => this.stepThrough(1));
    byKey.set("p", () => this.stepThrough(-1));
    kinds.forEach((kind, i) => byKey.set(`${i + 1}`, () => this.pickAndBring(this.data.cells[kind][0])));
    byKey.set("escape", () => this.pick(undefined));
    addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || this.help.open) return;
      const action = byKey.get(event.key.toLowerCase());
      if (!action) return;
      event.preventDefault();
      action();
    });
  }

  private heading(): HTMLElement {
    const count = (kind: CellKind, one: string, many: string) => {
      const n = this.data.cells[kind].length;
      return `${n.toLocaleString("en")} ${n === 1 ? one : many}`;
    };
    const counts = [count("face", "face", "faces"), count("edge", "edge", "edges"), count("point", "vertex", "vertices")];
    return el("div", { class: "heading" }, el("h1", {}, this.data.title || "Quoin"), el("p", {}, counts.join(", ")));
  }

  private makePanel(): HTMLElement {
    const panel = el("aside", { class: "panel glass", "aria-label": "Facts" });
    if (this.data.facts.length > 0) panel.append(el("section", {}, rows(this.data.facts)));
    if (this.data.legend.length > 0) {
      const list = el("ul", { class: "list" });
      for (const [name, color] of this.data.legend) {
        list.append(el("li", {}, el("span", { class: "swatch", "data-color": color }), el("span", { class: "name" }, name)));
      }
      panel.append(el("section", {}, el("h2", {}, "Colours"), list));
    }
    panel.classList.toggle("empty", panel.childElementCount === 0);
    return panel;
  }

  private makeRoom(): void {
    const isBeside = !this.panel.hidden && !isNarrow() && this.panel.childElementCount > 0;
    this.view.setInsets({ top: 62, bottom: 68, left: 0, right: isBeside ? 292 : 0 });
  }

  private applyTheme(): void {
    const isDark = this.theme.name === "dark";
    for (const swatch of this.panel.querySelectorAll<HTMLElement>(".swatch")) {
      swatch.style.background = this.data.colors[Number(swatch.dataset.color)][isDark ? 1 : 0];
    }
    this.view.themeChanged(isDark);
  }
}

const commonKeys: [string, string][] = [
  ["Click", "pick a face, an edge or a vertex"],
  ["+  -", "zoom"],
  ["F", "fit everything"],
  ["V  E  C  T", "vertices, edges, faces, labels"],
  ["1  2  3", "the first face, edge, vertex"],
  ["N  P", "next and previous of its kind"],
  ["I  L", "facts, light or dark"],
  ["Esc", "let go"],
];
