// SPDX-License-Identifier: Apache-2.0
// The persistence diagram: a point for each class of homology, at its birth and its death. The value that is shown is a
// line across and one up; the classes that are there then are above and to the left of where the two meet.
import { el, rows } from "../ui/dom";
import { never, type LayeredData } from "./layered_data";
import type { ValueAxis } from "./value_axis";

const margin = { left: 46, right: 10, top: 30, bottom: 36 };
const endlessAt = 16; // pixels from the top: what stays
const mostDiscs = 3000; // the longest ones; all others are pixels
const reach = 9;
const shades: Record<"light" | "dark", string[]> = {
  light: ["#2f6fb5", "#c8455c", "#2b9160", "#8a5bb5"],
  dark: ["#7fb2ee", "#f0798c", "#67cf9a", "#bf97e6"],
};

export class Diagram {
  readonly element = el("section", { class: "diagram" });
  private readonly canvas = el("canvas", { "aria-label": "Persistence diagram" });
  private readonly told = el("div", { class: "told", "aria-live": "polite" });
  private readonly key = el("div", { class: "key" });
  private readonly still = document.createElement("canvas");
  /** Pairs, the longest first. */
  private readonly order: Uint32Array;
  private theme: "light" | "dark" = "light";
  private value = 0;
  private hovered: number | undefined;
  private picked: number | undefined;

  constructor(
    private readonly data: LayeredData,
    private readonly axis: ValueAxis,
    private readonly choose: (value: number) => void,
    private readonly rescaled: () => void,
    private readonly mark: (points: number[]) => void,
  ) {
    const { pairs, pairsLeftOut } = data;
    const read = (index: number) => this.axis.read(this.data.values[index]);
    const length = (i: number) => (pairs.death[i] === never ? Infinity : read(pairs.death[i]) - read(pairs.birth[i]));
    const lengths = Float64Array.from({ length: pairs.count }, (_, i) => length(i));
    this.order = Uint32Array.from({ length: pairs.count }, (_, i) => i).sort((a, b) => (lengths[b] > lengths[a] ? 1 : lengths[b] < lengths[a] ? -1 : a - b));
    const left = pairsLeftOut > 0 ? `, without ${pairsLeftOut.toLocaleString("en").replaceAll(",", " ")} short ones` : "";
    this.element.append(el("h2", {}, `Persistence: ${pairs.count.toLocaleString("en").replaceAll(",", " ")} classes${left}`), this.scale(), this.key, this.canvas, this.told);
    this.canvas.addEventListener("pointermove", (event) => this.hover(event));
    this.canvas.addEventListener("pointerleave", () => this.setHovered(undefined));
    this.canvas.addEventListener("click", (event) => this.click(event));
    new ResizeObserver(() => this.drawStill()).observe(this.canvas);
  }

  setValue(value: number): void {
    this.value = value;
    this.draw();
  }

  themeChanged(isDark: boolean): void {
    this.theme = isDark ? "dark" : "light";
    this.writeKey();
    this.drawStill();
  }

  letGo(): void {
    this.picked = undefined;
    this.hovered = undefined;
    this.tell();
    this.draw();
  }

  /** The class that is born or dies at a point, if there is one, is picked. */
  pickAt(point: number): void {
    const points = this.data.pairs.points;
    const at = points ? points.indexOf(point) : -1;
    this.picked = at < 0 ? undefined : at >> 1;
    this.hovered = undefined;
    this.tell();
    this.draw();
  }

  /** Where a pair is, in pixels of the window. */
  placeOf(pair: number): { x: number; y: number } {
    const box = this.canvas.getBoundingClientRect();
    const [x, y] = this.place(pair);
    return { x: box.left + x, y: box.top + y };
  }

  /** Evenly or by logarithms. */
  private scale(): HTMLElement {
    const segments = el("div", { class: "scale segments" });
    const buttons = ["Even", "Log"].map((text, isLog) => {
      const button = el("button", { type: "button", "aria-pressed": `${this.axis.isLog === (isLog === 1)}` }, text);
      button.addEventListener("click", () => {
        this.axis.isLog = isLog === 1;
        buttons.forEach((other, i) => other.setAttribute("aria-pressed", `${this.axis.isLog === (i === 1)}`));
        this.drawStill();
        this.rescaled();
      });
      return button;
    });
    segments.append(...buttons);
    segments.hidden = !this.axis.canBeLog;
    return segments;
  }

  private get side(): { width: number; height: number } {
    const { clientWidth, clientHeight } = this.canvas;
    return { width: clientWidth - margin.left - margin.right, height: clientHeight - margin.top - margin.bottom };
  }

  private part(index: number): number {
    return this.axis.part(this.data.values[index]);
  }

  private x(part: number): number {
    return margin.left + this.side.width * Math.min(1, Math.max(0, part));
  }

  private y(part: number): number {
    return part > 1 ? endlessAt : margin.top + this.side.height * (1 - part);
  }

  private place(pair: number): [number, number] {
    const { birth, death } = this.data.pairs;
    return [this.x(this.part(birth[pair])), death[pair] === never ? endlessAt : this.y(this.part(death[pair]))];
  }

  private degreeName(degree: number): string {
    const betti = this.data.counts.find(({ name }) => name === "Betti numbers");
    return betti?.rows[degree]?.name ?? `Degree ${degree}`;
  }

  private writeKey(): void {
    const degrees = [...new Set(this.data.pairs.degree)].sort();
    this.key.replaceChildren(
      ...degrees.map((degree) => el("span", {}, el("i", { style: `background:${this.shade(degree)}` }), this.degreeName(degree))),
    );
  }

  private shade(degree: number): string {
    return shades[this.theme][degree % shades[this.theme].length];
  }

  /** All that does not change with the value. */
  private drawStill(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0) return;
    const ratio = devicePixelRatio;
    for (const canvas of [this.canvas, this.still]) {
      canvas.width = Math.round(clientWidth * ratio);
      canvas.height = Math.round(clientHeight * ratio);
    }
    const pen = this.still.getContext("2d") as CanvasRenderingContext2D;
    pen.scale(ratio, ratio);
    this.drawAxes(pen);
    const { degree } = this.data.pairs;
    for (let k = this.order.length - 1; k >= 0; --k) {
      const pair = this.order[k];
      const [x, y] = this.place(pair);
      pen.fillStyle = this.shade(degree[pair]);
      if (k >= mostDiscs) {
        pen.globalAlpha = 0.5;
        pen.fillRect(x - 0.5, y - 0.5, 1, 1);
        continue;
      }
      pen.globalAlpha = 0.85;
      pen.beginPath();
      pen.arc(x, y, this.order.length > 500 ? 2 : 3.2, 0, 2 * Math.PI);
      pen.fill();
    }
    this.draw();
  }

  private drawAxes(pen: CanvasRenderingContext2D): void {
    const style = getComputedStyle(document.documentElement);
    const [ink, hair] = [style.getPropertyValue("--faint"), style.getPropertyValue("--hair")];
    const [left, bottom, right] = [this.x(0), this.y(0), this.x(1)];
    pen.font = "11px system-ui, sans-serif";
    pen.fillStyle = ink;
    pen.strokeStyle = hair;
    const line = (x1: number, y1: number, x2: number, y2: number) => {
      pen.beginPath();
      pen.moveTo(x1, y1);
      pen.lineTo(x2, y2);
      pen.stroke();
    };
    for (const tick of this.axis.ticks()) {
      const part = this.axis.partOf(tick);
      const text = String(Number(tick.toPrecision(3))).replace("-", "−");
      line(this.x(part), bottom, this.x(part), this.y(part));
      line(left, this.y(part), this.x(part), this.y(part));
      pen.textAlign = "center";
      pen.fillText(text, this.x(part), bottom + 14);
      pen.textAlign = "right";
      pen.fillText(text, left - 5, this.y(part) + 4);
    }
    line(left, endlessAt, right, endlessAt);
    pen.textAlign = "right";
    pen.fillText("∞", left - 5, endlessAt + 4);
    pen.strokeStyle = ink;
    line(left, bottom, right, this.y(1));
    pen.textAlign = "center";
    pen.fillText(`${this.axis.name} at birth`, (left + right) / 2, bottom + 30);
    pen.save();
    pen.translate(9, (bottom + this.y(1)) / 2);
    pen.rotate(-Math.PI / 2);
    pen.fillText("at death", 0, 0);
    pen.restore();
  }

  private draw(): void {
    const pen = this.canvas.getContext("2d") as CanvasRenderingContext2D;
    const style = getComputedStyle(document.documentElement);
    const accent = style.getPropertyValue("--accent");
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    pen.scale(devicePixelRatio, devicePixelRatio);
    const part = this.part(this.value);
    const [x, y, left, bottom] = [this.x(part), part > 1 ? margin.top : this.y(part), this.x(0), this.y(0)];
    pen.fillStyle = accent;
    pen.globalAlpha = 0.12;
    pen.fillRect(left, 2, x - left, y - 2);
    pen.globalAlpha = 1;
    pen.strokeStyle = accent;
    pen.beginPath();
    pen.moveTo(x, bottom);
    pen.lineTo(x, 2);
    pen.moveTo(left, y);
    pen.lineTo(x, y);
    pen.stroke();
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.drawImage(this.still, 0, 0);
    pen.scale(devicePixelRatio, devicePixelRatio);
    for (const pair of [this.picked, this.hovered]) {
      if (pair === undefined) continue;
      const [px, py] = this.place(pair);
      pen.lineWidth = 2;
      pen.beginPath();
      pen.arc(px, py, 6, 0, 2 * Math.PI);
      pen.stroke();
      pen.lineWidth = 1;
    }
  }

  private pairAt(event: PointerEvent | MouseEvent): number | undefined {
    const box = this.canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    let best: number | undefined;
    let least = reach * reach;
    for (const pair of this.order) {
      const [px, py] = this.place(pair);
      const square = (px - x) ** 2 + (py - y) ** 2;
      if (square < least) [best, least] = [pair, square];
    }
    return best;
  }

  private hover(event: PointerEvent): void {
    this.setHovered(this.pairAt(event));
  }

  private setHovered(pair: number | undefined): void {
    if (pair === this.hovered) return;
    this.hovered = pair;
    this.tell();
    this.draw();
  }

  /** A class is looked at from its birth on; once more, at its death. Beside all of them, the value of the birth axis. */
  private click(event: MouseEvent): void {
    const pair = this.pairAt(event);
    if (pair === undefined) {
      this.letGo();
      this.mark([]);
      const box = this.canvas.getBoundingClientRect();
      const part = (event.clientX - box.left - margin.left) / this.side.width;
      return this.choose(Math.max(0, this.axis.indexOf(this.axis.at(Math.min(1, Math.max(0, part))))));
    }
    const { birth, death } = this.data.pairs;
    const isAgain = pair === this.picked && this.value === birth[pair] && death[pair] !== never;
    this.picked = pair;
    this.tell();
    this.mark(this.pointsOf(pair));
    this.choose(isAgain ? death[pair] : birth[pair]);
  }

  /** Where a class is born and dies. */
  private pointsOf(pair: number): number[] {
    const points = this.data.pairs.points;
    return points ? [...points.subarray(2 * pair, 2 * pair + 2)].filter((point) => point !== never) : [];
  }

  private tell(): void {
    const pair = this.hovered ?? this.picked;
    if (pair === undefined) return this.told.replaceChildren(el("p", {}, "A click on a point goes to its birth, a second one to its death."));
    const { birth, death, degree } = this.data.pairs;
    const { values } = this.data;
    const at = (index: number) => {
      return this.axis.text(this.axis.read(values[index]));
    };
    const dies = death[pair] !== never;
    const middle = () => {
      const half = (this.axis.read(values[birth[pair]]) + this.axis.read(values[death[pair]])) / 2;
      this.choose(Math.max(birth[pair], this.axis.indexOf(this.axis.value(half))));
    };
    const button = (text: string, run: () => void) => el("button", { type: "button", onclick: run }, text);
    const act = el("div", { class: "act" }, button("Birth", () => this.choose(birth[pair])));
    if (dies) act.append(button("Middle", middle), button("Death", () => this.choose(death[pair])));
    this.told.replaceChildren(
      rows([
        ["Class of", this.degreeName(degree[pair]).toLowerCase()],
        [`${this.axis.name} at birth`, at(birth[pair])],
        [`${this.axis.name} at death`, dies ? at(death[pair]) : "never"],
      ]),
      pair === this.picked ? act : "",
    );
  }
}
