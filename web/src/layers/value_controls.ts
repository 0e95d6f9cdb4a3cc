// SPDX-License-Identifier: Apache-2.0
// The slider with the value as a number beside it, and a button that lets it grow by itself.
import { el } from "../ui/dom";
import type { LayeredData } from "./layered_data";
import type { ValueAxis } from "./value_axis";

const steps = 1000; // of the slider; one more stands for all values
const everything = steps + 10;
const growth = 10_000; // milliseconds from the least value to the largest

export class ValueControls {
  readonly element: HTMLElement;
  private readonly slider: HTMLInputElement;
  private readonly play: HTMLButtonElement;
  private readonly fields: { input: HTMLInputElement; isRoot: boolean }[] = [];
  private value = 0;
  private isPlaying = false;
  private part = 0;
  private lastFrame = 0;

  constructor(
    private readonly data: LayeredData,
    private readonly axis: ValueAxis,
    private readonly choose: (value: number) => void,
  ) {
    const name = this.axis.name || "Value";
    this.slider = el("input", { type: "range", min: 0, max: everything, step: 1, "aria-label": name });
    this.slider.addEventListener("input", () => this.slide());
    this.play = el("button", { type: "button", onclick: () => this.toggle() }, "Play");
    this.element = el("div", { class: "controls glass" }, this.play, this.slider);
    if (axis.isRoot) this.addField(data.rootName, true);
    this.addField(data.valueName || "Value", false);
  }

  setValue(value: number): void {
    this.value = value;
    const exact = this.data.values[value];
    const part = this.axis.part(exact);
    const isLast = value === this.data.values.length - 1 && part > 1;
    if (document.activeElement !== this.slider && !this.isPlaying) {
      this.slider.value = `${isLast ? everything : Math.round(steps * Math.min(1, part))}`;
    }
    this.slider.setAttribute("aria-valuetext", this.axis.text(this.axis.read(exact)));
    for (const { input, isRoot } of this.fields) {
      input.value = this.axis.text(isRoot ? this.axis.read(exact) : exact);
      input.removeAttribute("aria-invalid");
    }
  }

  toggle(): void {
    this.isPlaying = !this.isPlaying;
    this.play.textContent = this.isPlaying ? "Pause" : "Play";
    if (!this.isPlaying) return;
    const part = this.axis.part(this.data.values[this.value]);
    this.part = part >= 1 ? 0 : Math.max(0, part);
    this.lastFrame = performance.now();
    requestAnimationFrame(() => this.grow());
  }

  stop(): void {
    if (this.isPlaying) this.toggle();
  }

  /** The slider by so many of its steps. */
  step(by: number): void {
    this.stop();
    this.slider.value = `${Number(this.slider.value) + by}`;
    this.slide();
  }

  private addField(name: string, isRoot: boolean): void {
    const input = el("input", { type: "text", inputmode: "decimal", spellcheck: "false", "aria-label": name });
    input.addEventListener("change", () => this.typed(input, isRoot));
    this.fields.push({ input, isRoot });
    this.element.append(el("label", {}, el("span", {}, name), input));
  }

  private typed(input: HTMLInputElement, isRoot: boolean): void {
    this.stop();
    const given = Number(input.value.trim().replace("−", "-").replace(",", "."));
    if (input.value.trim() === "" || Number.isNaN(given)) {
      input.setAttribute("aria-invalid", "true");
      return;
    }
    // What was rounded for reading means the value itself.
    const exact = this.data.values[this.value];
    const isSame = this.axis.text(isRoot ? this.axis.read(exact) : exact) === this.axis.text(given);
    if (!isSame) this.choose(Math.max(0, this.axis.indexOf(isRoot ? this.axis.value(given) : given)));
    else this.setValue(this.value);
  }

  private slide(): void {
    this.stop();
    const at = Number(this.slider.value);
    this.choose(at > steps ? this.data.values.length - 1 : Math.max(0, this.axis.indexOf(this.axis.at(at / steps))));
  }

  private grow(): void {
    if (!this.isPlaying) return;
    const now = performance.now();
    this.part = Math.min(1, this.part + Math.min(250, now - this.lastFrame) / growth);
    this.lastFrame = now;
    this.slider.value = `${Math.round(steps * this.part)}`;
    this.choose(Math.max(0, this.axis.indexOf(this.axis.at(this.part))));
    if (this.part >= 1) return this.toggle();
    requestAnimationFrame(() => this.grow());
  }
}
