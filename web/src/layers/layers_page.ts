// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import type { PageHook } from "../cells/start";
import { count } from "../format";
import { cssColor } from "../palette";
import { isometric } from "../stage";
import { Theme } from "../theme";
import { el, icon, rows } from "../ui/dom";
import { Gizmo } from "../ui/gizmo";
import { icons } from "../ui/icons";
import { CloudView, type PickedPoint } from "./cloud_view";
import { Diagram } from "./diagram";
import { never, type LayeredData } from "./layered_data";
import { PointCard } from "./point_card";
import { ValueAxis } from "./value_axis";
import { ValueControls } from "./value_controls";

const clickReach = 4; // pixels that the pointer may move during a click
const narrow = 760;
const longClass = 0.2; // of the longest of any degree

/** What tests, and people at the console, may ask of the page. */
export interface LayersHook extends PageHook {
  value(): number;
  setValue(value: number): void;
  shown(): Record<string, number>;
  placeOfPoint(point: number): { x: number; y: number } | undefined;
  placeOfPair(pair: number): { x: number; y: number };
  pick(x: number, y: number): number | undefined;
  /** How many elements of each layer are drawn. */
  drawn(): Record<string, number>;
  frameTime(frames: number): number;
  movingFrameTime(frames: number): number;
}

const digits = (n: number) => n.toLocaleString("en").replaceAll(",", " ");

/** Points and what stands on them, the slider, the diagram, and the numbers at the value. */
export class LayersPage {
  private readonly theme = new Theme(() => this.themeChanged());
  private readonly view: CloudView;
  private readonly axis: ValueAxis;
  private readonly controls: ValueControls | undefined;
  private readonly diagram: Diagram | undefined;
  private readonly side = el("aside", { class: "side glass", "aria-label": "Facts" });
  private readonly card: PointCard;
  private readonly numbers: { cell: HTMLElement; at: (value: number) => number }[] = [];
  private value = 0;

  constructor(
    host: HTMLElement,
    private readonly data: LayeredData,
  ) {
    const frame = el("div", { class: "cloud" });
    host.append(frame);
    this.view = new CloudView(data, frame);
    this.axis = new ValueAxis(data);
    const said = data.givenCount > 0 ? count(data.givenCount, "point") : "There is nothing to show: there are no points.";
    frame.append(el("div", { class: "heading" }, el("h1", {}, data.title || "Quoin"), el("p", {}, said)));
    if (!this.view.isFlat) frame.append(this.gizmo());
    this.card = new PointCard(data, this.axis, this.view, () => this.letGo());
    frame.append(this.card.element, this.side);
    if (data.pairs.count > 0) {
      const mark = (points: number[]) => this.lookAt(undefined, points);
      this.diagram = new Diagram(data, this.axis, (value) => this.choose(value), () => this.show(this.value), mark);
    }
    if (data.values.length > 1) {
      this.controls = new ValueControls(data, this.axis, (value) => this.show(value));
      frame.append(el("div", { class: "below" }, this.controls.element));
    }
    this.fillSide();
    this.makeRoom();
    addEventListener("resize", () => this.makeRoom());
    this.listenToKeys();
    this.listenToClicks();
    this.view.stage.renderer.domElement.addEventListener("webglcontextlost", () => location.reload());
    this.view.home(false);
    this.themeChanged();
    this.show(data.value ?? this.firstValue());
    this.diagram?.letGo();
  }

  hook(): LayersHook {
    return {
      ready: true,
      value: () => this.value,
      setValue: (value) => this.choose(value),
      shown: () => Object.fromEntries(this.view.layers.map((drawn) => [drawn.layer.name, drawn.countAt(this.value)])),
      placeOfPoint: (index) => {
        const { left, top } = this.view.element.getBoundingClientRect();
        const [x, y, z] = this.data.relative.subarray(3 * index, 3 * index + 3);
        this.view.stage.updateCameras();
        const at = this.view.stage.project(new THREE.Vector3(x, y, z));
        return at && { x: at.x + left, y: at.y + top };
      },
      placeOfPair: (pair) => this.diagram?.placeOf(pair) ?? { x: 0, y: 0 },
      pick: (x, y) => this.view.pointAt(x, y)?.point,
      drawn: () => Object.fromEntries(this.view.layers.map((drawn) => [drawn.layer.name, drawn.isSeen ? drawn.drawnCount : 0])),
      frameTime: (frames) => this.view.frameTime(frames),
      movingFrameTime: (frames) => this.view.movingFrameTime(frames),
    };
  }

  /** Where the longest class is born, of the highest degree of which there is a long one: what is around a void. */
  private firstValue(): number {
    const { pairs, values } = this.data;
    const best: { pair: number; length: number }[] = [];
    for (let pair = 0; pair < pairs.count; ++pair) {
      const degree = pairs.degree[pair];
      if (degree === 0 || pairs.death[pair] === never) continue;
      const length = this.axis.read(values[pairs.death[pair]]) - this.axis.read(values[pairs.birth[pair]]);
      if (!(length <= (best[degree]?.length ?? 0))) best[degree] = { pair, length };
    }
    const there = best.filter((one) => one !== undefined); // best has no entry of degree 0
    const longest = Math.max(...there.map((one) => one.length));
    const found = there.filter((one) => one.length > longClass * longest).pop();
    return found ? pairs.birth[found.pair] : Math.max(0, values.length - 1);
  }

  private choose(value: number): void {
    this.controls?.stop();
    this.show(value);
  }

  private show(value: number): void {
    this.value = Math.max(0, Math.min(this.data.values.length - 1, value));
    this.view.show(this.value);
    for (const { cell, at } of this.numbers) cell.textContent = digits(at(this.value));
    if (this.data.values.length === 0) return;
    this.controls?.setValue(this.value);
    this.diagram?.setValue(this.value);
  }

  private number(at: (value: number) => number): HTMLElement {
    const cell = el("span", {});
    this.numbers.push({ cell, at });
    return cell;
  }

  private fillSide(): void {
    const { counts, facts } = this.data;
    this.side.append(this.layerList());
    const tables = counts.map(({ name, rows: list }) => {
      const lines = list.map((row): [string, Node] => [row.name, this.number((value) => row.at[value] ?? 0)]);
      return el("div", {}, el("h2", {}, name), rows(lines));
    });
    if (tables.length > 0) this.side.append(el("section", { class: "counts" }, ...tables));
    if (this.diagram) this.side.append(this.diagram.element);
    if (facts.length > 0) this.side.append(el("section", {}, rows(facts)));
    const button = (text: string, run: () => void) => el("button", { type: "button", onclick: run }, text);
    const tools = el("div", { class: "tools" }, button("Fit", () => this.view.stage.fit()), button("Parallel", () => this.toggleParallel()), button("Light or dark", () => this.theme.toggle()));
    this.side.append(el("section", {}, tools));
  }

  private layerList(): HTMLElement {
    const list = el("ul", { class: "list" });
    for (const drawn of this.view.layers) {
      const { name, colors } = drawn.layer;
      const color = colors && colors.length > 0 ? colors : drawn.layer.color;
      const toggle = el("button", { type: "button", class: "eye", "aria-pressed": `${drawn.isShown}`, "aria-label": `Show ${name}`, title: "Hide or show" }, icon(icons.eye));
      toggle.addEventListener("click", () => {
        this.view.showLayer(drawn, !drawn.isShown);
        toggle.setAttribute("aria-pressed", `${drawn.isShown}`);
      });
      const swatch = el("span", { class: "swatch", style: `background:${cssColor([color[0], color[1], color[2]])}` });
      const shown = this.number((value) => drawn.countAt(value));
      shown.className = "count";
      list.append(el("li", {}, swatch, el("span", { class: "name", title: name }, name), shown, toggle));
    }
    return el("section", {}, el("h2", {}, "Shown"), list);
  }

  private gizmo(): Node {
    const gizmo = new Gizmo((direction) => this.look(direction));
    this.view.follow(() => gizmo.update(this.view.stage.camera));
    return gizmo.element;
  }

  private look(direction: THREE.Vector3): void {
    // Straight down has no up of its own: lean a little towards the front.
    const nearPole = Math.abs(direction.z) > 0.99 * direction.length();
    this.view.stage.lookFrom(nearPole ? new THREE.Vector3(0, -1e-4, direction.z) : direction);
  }

  private toggleParallel(): void {
    this.view.stage.setOrthographic(!this.view.stage.isOrthographic);
  }

  private makeRoom(): void {
    const isNarrow = innerWidth <= narrow;
    const right = isNarrow ? 0 : this.side.offsetWidth + 12;
    this.view.stage.setInsets({ top: 62, right, bottom: this.controls ? 68 : 12, left: 0 });
  }

  private themeChanged(): void {
    this.diagram?.themeChanged(this.theme.name === "dark");
    this.view?.stage.invalidate();
  }

  private pick(x: number, y: number): void {
    const picked = this.view.pointAt(x, y);
    if (!picked) return this.letGo();
    this.lookAt(picked, [picked.point]);
    this.diagram?.pickAt(picked.point);
  }

  /** At a picked point, alone with what is its own, or at others, which are marked. */
  private lookAt(picked: PickedPoint | undefined, marked: number[]): void {
    this.view.select(picked && this.data.layers[picked.layer].owners?.[picked.element]);
    this.view.mark(marked);
    if (picked) this.card.show(picked);
    else this.card.hide();
  }

  private letGo(): void {
    this.lookAt(undefined, []);
    this.diagram?.letGo();
  }

  private listenToClicks(): void {
    const canvas = this.view.stage.renderer.domElement;
    let pressed: { x: number; y: number } | undefined;
    canvas.addEventListener("pointerdown", (event) => (pressed = event.button === 0 ? { x: event.clientX, y: event.clientY } : undefined));
    canvas.addEventListener("pointerup", (event) => {
      if (pressed && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) <= clickReach) this.pick(event.clientX, event.clientY);
      pressed = undefined;
    });
    canvas.addEventListener("dblclick", () => this.view.stage.fit());
  }

  private listenToKeys(): void {
    const { stage } = this.view;
    const keys = new Map<string, (isLarge: boolean) => void>([
      [" ", () => this.controls?.toggle()],
      ["arrowright", (isLarge) => (isLarge ? this.controls?.step(10) : this.choose(this.value + 1))],
      ["arrowleft", (isLarge) => (isLarge ? this.controls?.step(-10) : this.choose(this.value - 1))],
      ["escape", () => this.letGo()],
      ["f", () => stage.fit()],
      ["o", () => this.toggleParallel()],
      ["l", () => this.theme.toggle()],
      ["1", () => this.look(new THREE.Vector3(0, -1, 0))],
      ["2", () => this.look(new THREE.Vector3(1, 0, 0))],
      ["3", () => this.look(new THREE.Vector3(0, 0, 1))],
      ["4", () => this.look(isometric)],
    ]);
    addEventListener("keydown", (event) => {
      const isTyping = event.target instanceof HTMLInputElement || (event.target instanceof HTMLButtonElement && event.key === " ");
      if (event.ctrlKey || event.metaKey || event.altKey || isTyping) return;
      const action = keys.get(event.key.toLowerCase());
      if (!action) return;
      event.preventDefault();
      action(event.shiftKey);
    });
  }
}
