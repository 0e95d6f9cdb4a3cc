// SPDX-License-Identifier: Apache-2.0
import { cssColor, originColor } from "../palette";
import { el, svg } from "../ui/dom";
import type { PlanGraph, PlanPart } from "./plan_data";

const size = 320;
const mostNamed = 24;

/** Who stops whom: parts around a circle, an arrow from a part to each that it would meet. */
export class GraphView {
  readonly element = el("div", { class: "graph" });
  private readonly told = el("p", { class: "told" });
  private graph: PlanGraph = { arcs: [], movable: [] };
  private within: number[] = [];
  private lit: number[] = [];

  constructor(private readonly parts: PlanPart[]) {}

  show(graph: PlanGraph, within: number[], lit: number[]): void {
    this.graph = graph;
    this.within = within;
    this.lit = lit;
    this.draw();
    this.told.textContent = `${graph.arcs.length} of ${within.length * (within.length - 1)} pairs are blocked.`;
  }

  private draw(): void {
    const picture = svg("svg", { viewBox: `0 0 ${size} ${size}`, role: "img" });
    picture.setAttribute("aria-label", "Blocking graph");
    const radius = size / 2 - (this.within.length > mostNamed ? 14 : 46);
    const angle = (k: number) => (2 * Math.PI * k) / Math.max(1, this.within.length) - Math.PI / 2;
    const place = new Map(
      this.within.map((part, k) => [part, [size / 2 + radius * Math.cos(angle(k)), size / 2 + radius * Math.sin(angle(k))] as const]),
    );
    const opacity = Math.max(0.12, Math.min(0.8, 40 / Math.max(1, this.graph.arcs.length)));
    for (const [from, to] of this.graph.arcs) {
      const a = place.get(from);
      const b = place.get(to);
      if (a && b) picture.append(this.arrow(a, b, opacity, from, to));
    }
    this.within.forEach((part, k) => picture.append(this.node(part, angle(k), radius)));
    this.element.replaceChildren(picture, this.told);
  }

  private arrow(a: readonly number[], b: readonly number[], opacity: number, from: number, to: number): SVGElement {
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    const length = Math.hypot(dx, dy) || 1;
    const [ux, uy] = [dx / length, dy / length];
    const bend = 0.1 * length; // both ways between two parts are seen
    const middle = [(a[0] + b[0]) / 2 - bend * uy, (a[1] + b[1]) / 2 + bend * ux];
    const into = [b[0] - middle[0], b[1] - middle[1]];
    const reach = Math.hypot(into[0], into[1]) || 1;
    const [vx, vy] = [into[0] / reach, into[1] / reach];
    const tip = [b[0] - 9 * vx, b[1] - 9 * vy];
    const head = `M${tip[0] - 6 * vx + 3 * vy} ${tip[1] - 6 * vy - 3 * vx}L${tip[0]} ${tip[1]}L${tip[0] - 6 * vx - 3 * vy} ${tip[1] - 6 * vy + 3 * vx}`;
    const path = svg("path", { d: `M${a[0]} ${a[1]}Q${middle[0]} ${middle[1]} ${tip[0]} ${tip[1]}${head}`, class: "arc", "data-from": from, "data-to": to });
    path.style.opacity = `${opacity}`;
    return path;
  }

  private node(part: number, angle: number, radius: number): SVGElement {
    const [x, y] = [size / 2 + radius * Math.cos(angle), size / 2 + radius * Math.sin(angle)];
    const group = svg("g", { class: this.lit.includes(part) ? "node lit" : "node", tabindex: 0 });
    const dot = svg("circle", { cx: x, cy: y, r: this.within.length > mostNamed ? 4 : 7 });
    dot.style.fill = cssColor(originColor(part));
    group.append(dot);
    if (this.within.length <= mostNamed) {
      const text = svg("text", { x: size / 2 + (radius + 13) * Math.cos(angle), y: size / 2 + (radius + 13) * Math.sin(angle) + 4 });
      text.setAttribute("text-anchor", Math.cos(angle) > 0.3 ? "start" : Math.cos(angle) < -0.3 ? "end" : "middle");
      text.textContent = this.parts[part].name;
      group.append(text);
    }
    const title = svg("title", {});
    title.textContent = this.parts[part].name;
    group.append(title);
    for (const event of ["pointerenter", "focus"]) group.addEventListener(event, () => this.single(part));
    for (const event of ["pointerleave", "blur"]) group.addEventListener(event, () => this.single(undefined));
    return group;
  }

  /** What one part meets. */
  private single(part: number | undefined): void {
    for (const arc of this.element.querySelectorAll<SVGElement>(".arc")) {
      arc.classList.toggle("away", part !== undefined && Number(arc.dataset.from) !== part);
      arc.classList.toggle("its", part !== undefined && Number(arc.dataset.from) === part);
    }
    if (part === undefined) {
      this.told.textContent = `${this.graph.arcs.length} of ${this.within.length * (this.within.length - 1)} pairs are blocked.`;
      return;
    }
    const met = this.graph.arcs.filter(([from]) => from === part).map(([, to]) => this.parts[to].name);
    const { name } = this.parts[part];
    this.told.textContent = met.length > 0 ? `${name} would meet ${met.join(", ")}.` : `${name} meets nothing.`;
  }
}
