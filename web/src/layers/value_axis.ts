// SPDX-License-Identifier: Apache-2.0
// Where values lie on an axis: by their square roots where these have a sense, as radii do.
import { number } from "../format";
import type { LayeredData } from "./layered_data";
import { never } from "./layered_data";

export class ValueAxis {
  readonly low: number;
  readonly high: number;

  constructor(private readonly data: LayeredData) {
    const { values, pairs } = data;
    let low = Infinity;
    let high = -Infinity;
    const include = (value: number) => {
      if (!Number.isFinite(value)) return;
      low = Math.min(low, value);
      high = Math.max(high, value);
    };
    for (let i = 0; i < pairs.count; ++i) {
      include(values[pairs.birth[i]]);
      if (pairs.death[i] !== never) include(values[pairs.death[i]]);
    }
    if (!(low < high)) for (const value of values) include(value);
    if (!(low <= high)) [low, high] = [0, 1];
    this.low = this.place(low);
    this.high = this.place(high);
    if (!(this.low < this.high)) this.high = this.low + Math.max(Math.abs(this.low), 1) * 1e-3;
  }

  get isRoot(): boolean {
    return this.data.rootName !== "";
  }

  get name(): string {
    return this.isRoot ? this.data.rootName : this.data.valueName;
  }

  /** Of a value, in the unit of the axis. */
  place(value: number): number {
    return this.isRoot ? Math.sqrt(Math.max(0, value)) : value;
  }

  /** The value at a place. */
  value(place: number): number {
    return this.isRoot ? place * place : place;
  }

  /** From 0 to 1 along the axis. */
  part(value: number): number {
    return (this.place(value) - this.low) / (this.high - this.low);
  }

  at(part: number): number {
    return this.value(this.low + part * (this.high - this.low));
  }

  /** The last index of a value that is not above; -1 if all are. */
  indexOf(value: number): number {
    const { values } = this.data;
    let [from, to] = [0, values.length];
    while (from < to) {
      const middle = (from + to) >> 1;
      if (values[middle] <= value) from = middle + 1;
      else to = middle;
    }
    return from - 1;
  }

  /** About five round places. */
  ticks(): number[] {
    const range = this.high - this.low;
    let step = 10 ** Math.floor(Math.log10(range));
    if (range / step < 2.5) step /= 2;
    else if (range / step > 6) step *= 2;
    const ticks: number[] = [];
    for (let i = Math.ceil(this.low / step); i * step <= this.high && ticks.length < 12; ++i) ticks.push(i * step);
    return ticks;
  }

  /** As people read it. */
  text(value: number): string {
    if (value === Infinity) return "beyond all doubles";
    return number(value, 6);
  }
}
