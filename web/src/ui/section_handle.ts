// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import type { Section } from "../section";
import type { Stage } from "../stage";
import { svg } from "./dom";

const arm = 46; // pixels

/** An arrow on the cut that is dragged along its normal. */
export class SectionHandle {
  readonly element = svg("svg", { class: "handle" });
  private readonly shaft = svg("line", { class: "shaft" });
  private readonly halo = svg("line", { class: "shaft halo" });
  private readonly head = svg("path", { d: "M0 0-11-5.5-11 5.5z", class: "head" });
  private readonly grip = svg("circle", { r: 13, class: "grip" });
  private drag: { x: number; y: number; offset: number; perPixel: THREE.Vector2 } | undefined;

  constructor(
    private readonly stage: Stage,
    private readonly section: Section,
    private readonly moved: () => void,
  ) {
    this.element.append(this.halo, this.shaft, this.head, this.grip);
    this.grip.addEventListener("pointerdown", (event) => this.start(event as PointerEvent));
    this.grip.addEventListener("pointermove", (event) => this.move(event as PointerEvent));
    for (const end of ["pointerup", "pointercancel"]) this.grip.addEventListener(end, () => (this.drag = undefined));
  }

  update(): void {
    const anchor = this.section.isOn ? this.stage.project(this.section.anchor) : undefined;
    this.element.style.display = anchor ? "" : "none";
    if (!anchor) return;
    const { direction } = this.screenNormal();
    const tip = { x: anchor.x + arm * direction.x, y: anchor.y + arm * direction.y };
    for (const line of [this.shaft, this.halo]) {
      const ends = { x1: anchor.x, y1: anchor.y, x2: tip.x - 8 * direction.x, y2: tip.y - 8 * direction.y };
      for (const [key, value] of Object.entries(ends)) line.setAttribute(key, value.toFixed(1));
    }
    const turn = (Math.atan2(direction.y, direction.x) * 180) / Math.PI;
    this.head.setAttribute("transform", `translate(${tip.x.toFixed(1)} ${tip.y.toFixed(1)}) rotate(${turn.toFixed(1)})`);
    this.grip.setAttribute("cx", tip.x.toFixed(1));
    this.grip.setAttribute("cy", tip.y.toFixed(1));
  }

  /** The normal as it is seen: its direction, and pixels per unit of length. */
  private screenNormal(): { direction: THREE.Vector2; pixels: number } {
    const step = 0.01;
    const anchor = this.section.anchor;
    const a = this.stage.project(anchor);
    const b = this.stage.project(anchor.clone().addScaledVector(this.section.normal, step));
    const seen = a && b ? new THREE.Vector2(b.x - a.x, b.y - a.y) : new THREE.Vector2(0, 0);
    const pixels = seen.length() / step;
    // Seen end on, the arrow points up and a drag of the window's height crosses the solids.
    if (pixels < 12) return { direction: new THREE.Vector2(0, -1), pixels: this.stage.host.clientHeight / 2 };
    return { direction: seen.normalize(), pixels };
  }

  private start(event: PointerEvent): void {
    const { direction, pixels } = this.screenNormal();
    this.drag = { x: event.clientX, y: event.clientY, offset: this.section.offset, perPixel: direction.divideScalar(pixels) };
    this.grip.setPointerCapture(event.pointerId);
    event.preventDefault();
  }

  private move(event: PointerEvent): void {
    if (!this.drag) return;
    const { x, y, offset, perPixel } = this.drag;
    this.section.offset = offset + (event.clientX - x) * perPixel.x + (event.clientY - y) * perPixel.y;
    this.moved();
  }
}
