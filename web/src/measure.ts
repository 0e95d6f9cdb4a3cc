// SPDX-License-Identifier: Apache-2.0
import { number, point } from "./format";
import type { Place } from "./picking";
import type { SceneData } from "./scene_data";
import type { Stage } from "./stage";
import { el, rows, svg } from "./ui/dom";

export interface Measurement {
  distance: number;
  delta: [number, number, number];
}

/** Two picked places, the line between them, and its lengths; drawn over the canvas. */
export class Measure {
  readonly overlay = svg("svg", { class: "overlay" });
  readonly card = el("div", { class: "card glass measure", "aria-live": "polite", hidden: true });
  isOn = false;
  places: Place[] = [];
  private candidate: Place | undefined;

  constructor(
    private readonly data: SceneData,
    private readonly stage: Stage,
  ) {}

  setOn(isOn: boolean): void {
    this.isOn = isOn;
    this.places = [];
    this.candidate = undefined;
    this.refresh();
  }

  add(place: Place): void {
    this.places = this.places.length >= 2 ? [place] : [...this.places, place];
    this.refresh();
  }

  hover(place: Place | undefined): void {
    this.candidate = place;
    this.draw();
  }

  get result(): Measurement | undefined {
    if (this.places.length < 2) return undefined;
    const [a, b] = this.places;
    const delta = [0, 1, 2].map((k) => b.point[k] - a.point[k]) as [number, number, number];
    return { delta, distance: Math.hypot(...delta) };
  }

  refresh(): void {
    this.card.hidden = !this.isOn;
    this.card.replaceChildren(...this.report());
    this.draw();
  }

  draw(): void {
    this.overlay.replaceChildren();
    if (!this.isOn) return;
    const at = this.places.map((place) => this.stage.project(place.drawn));
    if (at.length === 2 && at[0] && at[1]) this.drawLine(at[0], at[1]);
    this.places.forEach((place, i) => this.drawMark(at[i], place.isVertex, "mark"));
    const next = this.candidate && this.stage.project(this.candidate.drawn);
    if (this.candidate) this.drawMark(next, this.candidate.isVertex, "mark candidate");
  }

  private drawLine(a: { x: number; y: number }, b: { x: number; y: number }): void {
    const ends = { x1: a.x, y1: a.y, x2: b.x, y2: b.y };
    this.overlay.append(svg("line", { ...ends, class: "halo" }), svg("line", { ...ends, class: "rule" }));
    const label = svg("text", { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 - 9, class: "length", "text-anchor": "middle" });
    label.textContent = this.length(this.result?.distance ?? 0);
    this.overlay.append(label);
  }

  private drawMark(at: { x: number; y: number } | undefined, isVertex: boolean, name: string): void {
    if (!at) return;
    if (isVertex) this.overlay.append(svg("rect", { x: at.x - 4.5, y: at.y - 4.5, width: 9, height: 9, rx: 2, class: name }));
    else this.overlay.append(svg("circle", { cx: at.x, cy: at.y, r: 4.5, class: name }));
  }

  private get isExact(): boolean {
    return this.places.every((place) => place.isVertex);
  }

  /** Places between corners are known to about a pixel: fewer digits, and a sign that says so. */
  private length(x: number): string {
    return this.isExact ? number(x, 10) : `≈ ${number(x, 5)}`;
  }

  private report(): Node[] {
    const title = el("header", {}, el("h2", {}, "Measure"));
    const hints = ["Pick the first point; corners snap.", "Pick the second point."];
    if (this.places.length < 2) {
      const first = this.places.map((place): [string, string] => ["From", point(place.point, place.isVertex)]);
      return [title, el("p", { class: "hint" }, hints[this.places.length]), ...(first.length ? [rows(first)] : [])];
    }
    const { distance, delta } = this.result as Measurement;
    const deltas = delta.map((d, k): [string, string] => [`d${"xyz"[k]}`, this.length(d)]);
    return [
      title,
      el("p", { class: "big" }, this.length(distance), this.data.unit ? ` ${this.data.unit}` : ""),
      rows([
        ...deltas,
        ["From", point(this.places[0].point, this.places[0].isVertex)],
        ["To", point(this.places[1].point, this.places[1].isVertex)],
      ]),
    ];
  }
}

/** Keeps drawn places where they belong after the explosion changed: measuring starts anew. */
export function clearMeasure(measure: Measure): void {
  if (measure.places.length > 0) measure.setOn(measure.isOn);
}

