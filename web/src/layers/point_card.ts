// SPDX-License-Identifier: Apache-2.0
// What is known about the picked point, and what of the layers is its own.
import { point } from "../format";
import { el, icon, rows } from "../ui/dom";
import { icons } from "../ui/icons";
import type { CloudView, PickedPoint } from "./cloud_view";
import type { Layer, LayeredData } from "./layered_data";
import type { ValueAxis } from "./value_axis";

const digits = (n: number) => n.toLocaleString("en").replaceAll(",", " ");

export class PointCard {
  readonly element = el("div", { class: "card glass picked", hidden: true, "aria-live": "polite" });

  constructor(
    private readonly data: LayeredData,
    private readonly axis: ValueAxis,
    private readonly view: CloudView,
    private readonly close: () => void,
  ) {}

  hide(): void {
    this.element.hidden = true;
  }

  show(picked: PickedPoint): void {
    const { pointNumbers, layers, givenCount } = this.data;
    const layer = layers[picked.layer];
    const number = picked.point < pointNumbers.length ? pointNumbers[picked.point] : picked.point;
    const close = el("button", { type: "button", "aria-label": "Close", onclick: this.close }, icon(icons.close));
    const title = el("h2", {}, `${layer.elementName || "Point"} ${digits(number)}`);
    this.element.replaceChildren(
      el("header", {}, title, el("span", { class: "of" }, layer.name === "Points" ? "" : layer.name), close),
      el("code", {}, point(this.data.point(picked.point), picked.point < givenCount)),
    );
    const facts = [...this.valueRows(layer, picked.element), ...this.ownRows()];
    if (facts.length > 0) this.element.append(rows(facts));
    if (this.view.isAlone) this.element.append(el("p", { class: "hint" }, "Its own alone is seen; Esc shows all."));
    this.element.hidden = false;
  }

  /** At which value it begins, where that says something. */
  private valueRows({ shown, elementName }: Layer, element: number): [string, string][] {
    if (!shown || !elementName) return [];
    let [from, to] = [0, shown.length];
    while (from < to) {
      const middle = (from + to) >> 1;
      if (shown[middle] > element) to = middle;
      else from = middle + 1;
    }
    const text = (value: number) => this.axis.text(this.axis.read(this.data.values[value]));
    const isWithin = !this.data.hasAllValues && from > 0 && text(from - 1) !== text(from);
    return [[this.axis.name, isWithin ? `${text(from - 1)} to ${text(from)}` : text(from)]];
  }

  private ownRows(): [string, string][] {
    if (!this.view.isAlone) return [];
    const own: [string, string][] = this.view.layers
      .filter(({ layer, selectedCount }) => selectedCount > 0 && layer.kind !== "points")
      .map((drawn) => [drawn.layer.name, digits(drawn.selectedCount)]);
    return own.length > 0 ? own : [["Its own", "not in this page"]];
  }
}
