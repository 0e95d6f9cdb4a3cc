// SPDX-License-Identifier: Apache-2.0
import type { Cell, CellsData } from "../cells/data";
import type { PageHook } from "../cells/start";
import type { SphereGeometry, SphereHeader } from "../sphere/sphere_data";
import { Theme } from "../theme";
import { el, rows } from "../ui/dom";
import { DirectionsView } from "./directions_view";
import { Film, type Step } from "./film";
import { GraphView } from "./graph_view";
import type { Plan, PlanMove } from "./plan_data";
import { PartsView } from "./parts_view";

const secondsPerStep = 1.5;
const mostListed = 40;
const awayFactor = 0.9; // of the assembly's size

export interface SpherePart {
  header: SphereHeader;
  data: CellsData;
  geometry: SphereGeometry;
}

/** What tests, and people at the console, may ask of the page. */
export interface PlanHook extends PageHook {
  steps(): number;
  time(): number;
  seek(time: number): void;
  offsets(): number[][];
  pick(x: number, y: number): Cell | undefined;
  picked(): Cell | undefined;
}

interface Try {
  direction: readonly number[];
  moving: number[];
}

/** The parts and their way apart, the sphere of directions, and the graph of what is looked at. */
export class PlanPage {
  private readonly theme = new Theme(() => this.directions?.themeChanged(this.theme.name === "dark"));
  private readonly view: PartsView;
  private readonly film: Film;
  private readonly graph: GraphView;
  private readonly directions: DirectionsView | undefined;
  private readonly slider: HTMLInputElement;
  private readonly play: HTMLButtonElement;
  private readonly caption = el("p", { class: "caption", "aria-live": "polite" });
  private readonly choices = el("div", { class: "choices" });
  private readonly card = el("section", { class: "cell", hidden: true });
  private time = 0;
  private isPlaying = false;
  private lastFrame = 0;
  private cell: Cell | undefined;
  private cellDirection: readonly number[] = [0, 0, 1];
  private tried: Try | undefined;

  constructor(
    host: HTMLElement,
    private readonly plan: Plan,
    private readonly sphere: SpherePart | undefined,
  ) {
    this.view = new PartsView(plan.parts);
    this.film = new Film(plan, awayFactor * this.view.extent);
    this.graph = new GraphView(plan.parts);
    if (sphere) {
      this.directions = new DirectionsView(sphere.header, sphere.data, sphere.geometry, (cell, at) => this.pick(cell, at));
    }
    this.slider = el("input", { type: "range", min: 0, max: this.film.length, step: 0.01, value: 0, "aria-label": "Step" });
    this.slider.addEventListener("input", () => this.seek(Number(this.slider.value)));
    this.play = el("button", { type: "button", class: "play", onclick: () => this.toggle() }, "Play");
    const button = (text: string, label: string, run: () => void) => el("button", { type: "button", "aria-label": label, onclick: run }, text);
    const controls = el(
      "div",
      { class: "controls glass" },
      button("‹", "Step back", () => this.seek(Math.ceil(this.time) - 1)),
      this.play,
      button("›", "Step on", () => this.seek(Math.floor(this.time) + 1)),
      this.slider,
      button("◐", "Light or dark", () => this.theme.toggle()),
    );
    controls.hidden = this.film.length === 0;
    const side = el("aside", { class: "side glass", "aria-label": "Directions and blocking graph" });
    if (this.directions) side.append(this.directions.element);
    side.append(this.card, this.graph.element, this.choices, el("section", {}, rows(plan.facts)));
    const heading = el("div", { class: "heading" }, el("h1", {}, plan.title || "Quoin"), el("p", {}, `${plan.parts.length} parts`));
    host.append(el("div", { class: "plan" }, el("div", { class: "main" }, this.view.element, heading, el("div", { class: "below" }, this.caption, controls)), side));
    this.listenToKeys();
    this.directions?.themeChanged(this.theme.name === "dark");
    this.refresh();
  }

  hook(): PlanHook {
    return {
      ready: true,
      steps: () => this.film.length,
      time: () => this.time,
      seek: (time) => this.seek(time),
      offsets: () => this.film.poses(this.time).map((pose) => pose.offset),
      pick: (x, y) => this.directions?.hit(x, y)?.cell,
      picked: () => this.cell,
    };
  }

  private seek(time: number): void {
    this.time = Math.min(this.film.length, Math.max(0, time));
    this.tried = undefined;
    this.pick(undefined, [0, 0, 1]);
  }

  private toggle(): void {
    this.isPlaying = !this.isPlaying;
    if (this.isPlaying && this.time >= this.film.length) this.time = 0;
    this.lastFrame = performance.now();
    this.play.textContent = this.isPlaying ? "Pause" : "Play";
    if (this.isPlaying) requestAnimationFrame(() => this.frame());
  }

  private frame(): void {
    if (!this.isPlaying) return;
    const now = performance.now();
    const before = Math.floor(this.time);
    this.time = Math.min(this.film.length, this.time + Math.min(0.2, (now - this.lastFrame) / 1000) / secondsPerStep);
    this.lastFrame = now;
    if (this.time >= this.film.length) this.toggle();
    if (Math.floor(this.time) !== before) this.refresh();
    else this.pose();
    if (this.isPlaying) requestAnimationFrame(() => this.frame());
  }

  /** The step that is being made, or is next; at the end the last one. */
  private step(): Step | undefined {
    return this.film.steps[Math.min(Math.floor(this.time), this.film.length - 1)];
  }

  private refresh(): void {
    this.slider.max = `${this.film.length}`;
    this.pose();
    const step = this.step();
    this.choices.replaceChildren();
    if (this.cell) return this.showGraph(this.plan.cellGraphs[this.cell.kind][this.cell.index], this.plan.parts.map((_, i) => i));
    this.card.hidden = true;
    if (!step) return this.showWithoutSteps();
    const move = this.film.moveOf(step);
    this.showGraph(move.graph, this.plan.states[step.state].parts, move.moving);
    this.directions?.face(move.direction);
    this.showAlternatives(step);
    this.caption.textContent = this.describe(step, move);
  }

  private showWithoutSteps(): void {
    const isHeld = this.plan.interlocked.length > 0;
    this.caption.textContent = isHeld ? "No set of parts can move away from the others." : "Pick a cell of the sphere of directions.";
    this.graph.show({ arcs: [], movable: [] }, this.plan.parts.map((_, i) => i), []);
    this.graph.element.hidden = true;
  }

  private describe(step: Step, move: PlanMove): string {
    const number = this.film.steps.indexOf(step) + 1;
    const end = this.film.ends.length > 0 && this.time >= this.film.length ? ` These stay together: ${this.film.ends.map((state) => this.names(this.plan.states[state].parts)).join("; ")}.` : "";
    return `Step ${number} of ${this.film.length}: ${this.names(move.moving)} along ${move.exact}.${end}`;
  }

  private pose(): void {
    this.slider.value = `${this.time}`;
    const poses = this.film.poses(this.time);
    this.view.light(this.tried?.moving ?? []);
    for (const part of this.tried?.moving ?? []) {
      for (const axis of [0, 1, 2]) poses[part].offset[axis] += 0.5 * this.view.extent * (this.tried?.direction[axis] ?? 0);
    }
    this.view.pose(poses);
  }

  private names(parts: number[]): string {
    const shown = parts.slice(0, mostListed).map((part) => this.plan.parts[part].name);
    return shown.join(", ") + (parts.length > mostListed ? ` and ${parts.length - mostListed} more` : "");
  }

  private showGraph(graph: number, within: number[], lit: number[] = this.tried?.moving ?? []): void {
    this.graph.element.hidden = false;
    this.graph.show(this.plan.graphs[graph], within, lit);
  }

  private showAlternatives(step: Step): void {
    const { moves } = this.plan.states[step.state];
    if (moves.length < 2) return;
    const list = el("ul", { class: "list" });
    moves.slice(0, mostListed).forEach((move, i) => {
      const choose = () => {
        this.film.choose(step.state, i);
        this.seek(this.film.steps.findIndex((other) => other.state === step.state));
      };
      const button = el("button", { type: "button", "aria-pressed": `${i === step.move}`, onclick: choose }, `${this.names(move.moving)} along ${move.exact}`);
      list.append(el("li", {}, button));
    });
    this.choices.append(el("h2", {}, "Instead of this step"), list);
  }

  private pick(cell: Cell | undefined, direction: readonly number[]): void {
    this.cell = cell;
    this.tried = undefined;
    this.directions?.light(cell);
    if (!cell || !this.sphere) return this.refresh();
    const { points, paths } = this.sphere.geometry;
    const path = paths[cell.index] ?? [];
    const middle = 3 * Math.floor(path.length / 6);
    if (cell.kind === "point") direction = [...points.slice(3 * cell.index, 3 * cell.index + 3)];
    if (cell.kind === "edge") direction = [...path.slice(middle, middle + 3)];
    this.cellDirection = direction;
    this.time = 0;
    if (this.isPlaying) this.toggle();
    this.showCell(cell);
    this.refresh();
  }

  private showCell(cell: Cell): void {
    const sets = this.plan.graphs[this.plan.cellGraphs[cell.kind][cell.index]].movable;
    const list = el("ul", { class: "list" });
    for (const moving of sets.slice(0, mostListed)) {
      const run = () => {
        this.tried = { direction: this.cellDirection, moving };
        this.refresh();
      };
      list.append(el("li", {}, el("button", { type: "button", onclick: run }, this.names(moving))));
    }
    if (sets.length > mostListed) list.append(el("li", { class: "more" }, `and ${sets.length - mostListed} more`));
    const facts = cell.facts.filter(([name]) => name === "Direction" || name === "Blocked pairs");
    this.card.replaceChildren(el("h2", {}, cell.name), rows(facts), el("p", {}, sets.length > 0 ? "These sets can move:" : "Nothing can move."), list);
    this.card.hidden = false;
    this.caption.textContent = `${cell.name} of the sphere of directions`;
  }

  private listenToKeys(): void {
    const keys = new Map<string, () => void>([
      [" ", () => this.toggle()],
      ["arrowright", () => this.seek(Math.floor(this.time) + 1)],
      ["arrowleft", () => this.seek(Math.ceil(this.time) - 1)],
      ["escape", () => this.pick(undefined, [0, 0, 1])],
      ["l", () => this.theme.toggle()],
    ]);
    addEventListener("keydown", (event) => {
      const isTyping = event.target instanceof HTMLInputElement || (event.target instanceof HTMLButtonElement && event.key === " ");
      if (event.ctrlKey || event.metaKey || event.altKey || isTyping) return;
      const action = keys.get(event.key.toLowerCase());
      if (!action) return;
      event.preventDefault();
      action();
    });
  }
}
