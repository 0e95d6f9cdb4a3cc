// SPDX-License-Identifier: Apache-2.0
import { number } from "../format";
import type { Explosion } from "../explosion";
import type { Section, SectionAxis } from "../section";
import type { SceneData } from "../scene_data";
import { el, icon } from "./dom";
import { icons } from "./icons";

/** Sliders above the toolbar that belong to a tool. */
export class SectionDock {
  readonly element: HTMLElement;
  private readonly slider = rangeInput("Position of the cut");
  private readonly value = el("output", { class: "value" });
  private readonly axes: Record<SectionAxis, HTMLButtonElement>;

  constructor(
    private readonly data: SceneData,
    private readonly section: Section,
    private readonly choose: (axis: SectionAxis) => void,
    private readonly changed: () => void,
  ) {
    this.axes = {
      x: this.axisButton("x", "X"),
      y: this.axisButton("y", "Y"),
      z: this.axisButton("z", "Z"),
      face: this.axisButton("face", "Face"),
    };
    this.slider.addEventListener("input", () => {
      this.section.position = Number(this.slider.value);
      this.changed();
    });
    const flip = () => {
      this.section.isFlipped = !this.section.isFlipped;
      this.changed();
    };
    this.element = el(
      "div",
      { class: "dock glass", hidden: true },
      el("div", { class: "segments", role: "group", "aria-label": "Direction of the cut" }, ...Object.values(this.axes)),
      this.slider,
      this.value,
      el("button", { type: "button", class: "round", "aria-label": "Keep the other side (C)", title: "Keep the other side (C)", onclick: flip }, icon(icons.flip)),
    );
  }

  refresh(): void {
    const { section } = this;
    this.element.hidden = !section.isOn;
    for (const [axis, button] of Object.entries(this.axes)) button.setAttribute("aria-pressed", `${axis === section.axis}`);
    this.slider.value = String(section.position);
    const along = section.normal.toArray().reduce((sum, n, k) => sum + n * this.data.center[k], 0);
    const name = section.axis === "face" ? "n" : section.axis;
    this.value.textContent = `${name} = ${number(along + this.data.scale * section.offset, 5)}`;
  }

  private axisButton(axis: SectionAxis, label: string): HTMLButtonElement {
    return el("button", { type: "button", "data-axis": axis, onclick: () => this.choose(axis) }, label);
  }
}

export class ExplosionDock {
  readonly element: HTMLElement;
  private readonly slider = rangeInput("How far the pieces are apart");

  constructor(explosion: Explosion, changed: () => void) {
    this.slider.value = "0";
    this.slider.addEventListener("input", () => {
      explosion.amount = Number(this.slider.value);
      changed();
    });
    this.element = el("div", { class: "dock glass", hidden: true }, el("span", { class: "label" }, "Apart"), this.slider);
  }

  set amount(amount: number) {
    this.slider.value = String(amount);
  }
}

function rangeInput(label: string): HTMLInputElement {
  return el("input", { type: "range", min: 0, max: 1, step: 0.001, "aria-label": label });
}
