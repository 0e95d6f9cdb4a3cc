// SPDX-License-Identifier: Apache-2.0
// Where values lie on an axis: by their square roots where these have a sense, as radii do; evenly or by logarithms.
import { number } from "../format";
import { never, type LayeredData } from "./layered_data";

const wideRange = 30; // times the middle death; beyond it logarithms show more

export class ValueAxis {
  low = 0;
  high = 1;
  /** Whether logarithms have a sense. */
  readonly canBeLog: boolean;
  private readonly least: number; // as people read them
  private readonly most: number;
  private readonly floor: number; // what is less is there too, with logarithms
  private log = false;

  constructor(private readonly data: LayeredData) {
    const seen = this.finiteOnes().sort();
    this.least = seen.length > 0 ? seen[0] : 0;
    this.most = seen.length > 0 ? seen[seen.length - 1] : 1;
    const above = seen.subarray(seen.findIndex((x) => x > 0));
    this.floor = above.length > 0 ? above[Math.floor(above.length / 200)] : 0;
    this.canBeLog = this.least >= 0 && this.floor > 0 && this.most > 2 * this.floor;
    this.isLog = this.canBeLog && this.most > wideRange * above[Math.floor(above.length / 2)];
  }

  get isLog(): boolean {
    return this.log;
  }

  set isLog(isLog: boolean) {
    this.log = isLog && this.canBeLog;
    this.low = this.log ? Math.log10(this.floor) : this.least;
    this.high = this.log ? Math.log10(this.most) : this.most;
    if (!(this.low < this.high)) this.high = this.low + Math.max(Math.abs(this.low), 1) * 1e-3;
  }

  get isRoot(): boolean {
    return this.data.rootName !== "";
  }

  get name(): string {
    return this.isRoot ? this.data.rootName : this.data.valueName;
  }

  /** As people read a value: its root, where that has a sense. */
  read(value: number): number {
    return this.isRoot ? Math.sqrt(Math.max(0, value)) : value;
  }

  /** The value that is read so. */
  value(read: number): number {
    return this.isRoot ? read * Math.abs(read) : read;
  }

  /** From 0 to 1 along the axis. */
  part(value: number): number {
    return this.partOf(this.read(value));
  }

  partOf(read: number): number {
    const place = this.log ? Math.log10(Math.max(this.floor, read)) : read;
    return (place - this.low) / (this.high - this.low);
  }

  at(part: number): number {
    if (part <= 0) return this.value(this.least);
    if (part >= 1) return this.value(this.most) + 1e-12 * Math.abs(this.value(this.most)); // roots are rounded
    const place = this.low + part * (this.high - this.low);
    return this.value(this.log ? 10 ** place : place);
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

  /** About five round numbers. */
  ticks(): number[] {
    return this.log ? this.logTicks() : this.evenTicks();
  }

  /** As people read it. */
  text(read: number): string {
    return read === Infinity ? "beyond all doubles" : number(read, 6);
  }

  private evenTicks(): number[] {
    const range = this.high - this.low;
    let step = 10 ** Math.floor(Math.log10(range));
    if (range / step < 2.5) step /= 2;
    else if (range / step > 6) step *= 2;
    const ticks: number[] = [];
    for (let i = Math.ceil(this.low / step); i * step <= this.high && ticks.length < 12; ++i) ticks.push(i * step);
    return ticks;
  }

  private logTicks(): number[] {
    const factors = this.high - this.low < 2 ? [1, 2, 5] : [1];
    const every = Math.ceil((this.high - this.low) / 7);
    const ticks: number[] = [];
    for (let power = Math.floor(this.low); power <= this.high; power += every) {
      for (const factor of factors) {
        const tick = Number(`${factor}e${power}`);
        if (Math.log10(tick) >= this.low && Math.log10(tick) <= this.high) ticks.push(tick);
      }
    }
    return ticks;
  }

  /** Births and deaths as they are read, or all values where there are no pairs. */
  private finiteOnes(): Float64Array {
    const { values, pairs } = this.data;
    const used = new Set<number>();
    for (let i = 0; i < pairs.count; ++i) {
      used.add(pairs.birth[i]);
      if (pairs.death[i] !== never) used.add(pairs.death[i]);
    }
    const indices = used.size > 1 ? [...used] : [...values.keys()];
    return Float64Array.from(indices.map((i) => values[i]).filter(Number.isFinite), (value) => this.read(value));
  }
}
