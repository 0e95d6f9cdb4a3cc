// SPDX-License-Identifier: Apache-2.0
import type { Cell, CellKind, CellsData, CellsHeader } from "../cells/data";
import { kinds } from "../cells/data";
import type { CellsView, Insets, Layer } from "../cells/view";
import { el, svg } from "../ui/dom";
import type { Tool } from "../ui/toolbar";
import { Labels, type ScreenAnchor } from "./labels";
import { PanAndZoom } from "./pan_and_zoom";

export interface PictureHeader extends CellsHeader {
  sheet: [number, number]; ///< size in pixels of the drawing
  strokes: [line: number, point: number];
  anchors: [kind: number, cell: number, x: number, y: number, room: number][];
}

const groupOf: Record<CellKind, string> = { face: "faces", edge: "edges", point: "points" };
const reachOfPointer = [0, 3, 6]; // pixels
const clamp = (x: number, low: number, high: number) => Math.min(high, Math.max(low, x));

/** The drawing that the page came with, made movable. Its elements are its cells, in order. */
export class PlanarView implements CellsView {
  readonly element = el("div", { class: "stage" });
  private readonly drawing: SVGElement;
  private readonly moved = svg("g", {});
  private readonly litFaces = svg("g", { class: "lit" });
  private readonly litRest = svg("g", { class: "lit" });
  private readonly groups: Record<CellKind, SVGElement>;
  private readonly elements: Record<CellKind, SVGElement[]>;
  private readonly cellOf = new Map<Element, Cell>();
  private readonly labels = new Labels();
  private readonly view: PanAndZoom;
  private areLabelsShown = true;
  private isScheduled = false;
  private lastScale = 0;

  constructor(
    private readonly header: PictureHeader,
    private readonly data: CellsData,
  ) {
    const drawing = document.getElementById("quoin-drawing") as SVGElement | null;
    const group = (kind: CellKind) => drawing?.querySelector<SVGElement>(`:scope > .${groupOf[kind]}`);
    if (!drawing || !kinds.every((kind) => group(kind)?.childElementCount === data.cells[kind].length)) {
      throw new Error("The picture in this page is incomplete; the file may have been cut short.");
    }
    this.drawing = drawing;
    this.groups = { face: group("face")!, edge: group("edge")!, point: group("point")! };
    const children = (kind: CellKind) => [...this.groups[kind].children] as SVGElement[];
    this.elements = { face: children("face"), edge: children("edge"), point: children("point") };
    for (const kind of kinds) this.elements[kind].forEach((element, i) => this.cellOf.set(element, data.cells[kind][i]));
    for (const circle of this.elements.point) circle.style.setProperty("--r", `${circle.getAttribute("r")}px`);
    this.moved.append(this.groups.face, this.litFaces, this.groups.edge, this.groups.point, this.litRest);
    drawing.append(this.moved);
    drawing.setAttribute("role", "img");
    drawing.setAttribute("aria-label", data.title || "Picture");
    this.element.append(drawing, this.labels.element);
    this.view = new PanAndZoom(this.element, header.sheet, () => this.moveSoon());
  }

  cellAt(x: number, y: number): Cell | undefined {
    // Points before edges before faces: what is thin is meant when the pointer comes near.
    if (!this.element.contains(document.elementFromPoint(x, y))) return undefined; // a card or a tool is over it
    const found: Partial<Record<CellKind, Cell>> = {};
    for (const reach of reachOfPointer) {
      for (let i = 0; i < (reach === 0 ? 1 : 8); ++i) {
        const angle = (i * Math.PI) / 4;
        const under = document.elementFromPoint(x + reach * Math.cos(angle), y + reach * Math.sin(angle));
        const cell = under ? this.cellOf.get(under) : undefined;
        if (cell && (cell.kind !== "face" || reach === 0)) found[cell.kind] ??= cell;
        if (found.point) return found.point;
      }
    }
    return found.point ?? found.edge ?? found.face;
  }

  light(hovered: Cell | undefined, picked: Cell | undefined): void {
    this.litFaces.replaceChildren();
    this.litRest.replaceChildren();
    for (const [cell, look] of [[picked, "picked"], [hovered, "hovered"]] as const) {
      if (!cell) continue;
      const copy = this.elements[cell.kind][cell.index].cloneNode() as SVGElement;
      copy.setAttribute("class", `${cell.kind} ${look}${cell.color < 0 ? " blank" : ""}`);
      for (const property of ["fill", "stroke", "fill-opacity", "stroke-opacity"]) copy.style.removeProperty(property);
      (cell.kind === "face" ? this.litFaces : this.litRest).append(copy);
    }
  }

  bring(cell: Cell): void {
    const box = (this.elements[cell.kind][cell.index] as SVGGraphicsElement).getBBox();
    const anchor = this.header.anchors.find(([kind, index]) => kinds[kind] === cell.kind && index === cell.index);
    const [x, y] = anchor ? [anchor[2], anchor[3]] : [box.x + box.width / 2, box.y + box.height / 2];
    this.view.bring(x, y, cell.kind === "point" ? 0 : Math.max(box.width, box.height));
  }

  show(layer: Layer, isShown: boolean): void {
    if (layer === "labels") {
      this.areLabelsShown = isShown;
      this.moveSoon();
    } else {
      const kind = kinds.find((k) => groupOf[k] === layer)!;
      this.groups[kind].style.display = isShown ? "" : "none";
    }
  }

  fit(): void {
    this.view.fit();
  }

  step(right: number, down: number): void {
    this.view.pan(-60 * right, -60 * down);
  }

  zoom(factor: number): void {
    this.view.zoomInMiddle(factor);
  }

  setInsets(insets: Insets): void {
    this.view.setInsets(insets);
  }

  themeChanged(): void {} // the drawing's own rules follow the document

  tools(): Tool[] {
    return [];
  }

  private moveSoon(): void {
    if (this.isScheduled) return;
    this.isScheduled = true;
    requestAnimationFrame(() => {
      this.isScheduled = false;
      this.move();
    });
  }

  private move(): void {
    const { x, y, scale } = this.view;
    this.moved.setAttribute("transform", `translate(${x} ${y}) scale(${scale})`);
    // Lines and points keep their width on the screen, but for pictures that are very small or large.
    const weight = clamp(scale, 0.6, 2.2);
    if (scale !== this.lastScale) {
      this.drawing.style.setProperty("--line", `${this.header.strokes[0] * weight}px`);
      this.drawing.style.setProperty("--dot", `${weight / scale}`);
      this.lastScale = scale;
    }
    this.labels.draw(this.areLabelsShown ? this.anchors() : []);
  }

  /** Of the labels that are in the window. */
  private anchors(): ScreenAnchor[] {
    const { x: left, y: top, scale } = this.view;
    const seen: ScreenAnchor[] = [];
    for (const [kind, index, px, py, room] of this.header.anchors) {
      const [x, y] = [left + scale * px, top + scale * py];
      if (x < 0 || y < 0 || x > innerWidth || y > innerHeight) continue;
      const text = this.data.cells[kinds[kind]][index].label;
      seen.push({ text, x, y, room: kind === 0 ? room * scale : undefined });
    }
    return seen;
  }
}
