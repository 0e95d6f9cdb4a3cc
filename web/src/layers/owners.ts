// SPDX-License-Identifier: Apache-2.0
// What is seen alone when a point is picked: what its owner owns, and those that links lead to from there, as from a
// saddle along its ways. From where no link leads on, as from a maximum, links are followed against their direction.
import type { LayeredData } from "./layered_data";

/** By owner, whether it is seen. */
export type SeenOwners = Uint8Array;

export class Owners {
  private readonly count: number;
  private readonly onward: Rows;
  private readonly back: Rows;

  constructor(data: LayeredData) {
    const { links, layers } = data;
    const most = (list: ArrayLike<number>) => {
      let found = -1;
      for (let i = 0; i < list.length; ++i) if (list[i] > found) found = list[i];
      return found;
    };
    this.count = 1 + Math.max(most(links), ...layers.map(({ owners }) => (owners ? most(owners) : -1)));
    this.onward = new Rows(links, 0, this.count);
    this.back = new Rows(links, 1, this.count);
  }

  seenWith(owner: number): SeenOwners {
    const rows = this.onward.isEmpty(owner) ? this.back : this.onward;
    const seen = new Uint8Array(this.count);
    const open = [owner];
    seen[owner] = 1;
    for (let at = open.pop(); at !== undefined; at = open.pop()) {
      rows.forEach(at, (next) => {
        if (seen[next]) return;
        seen[next] = 1;
        open.push(next);
      });
    }
    return seen;
  }
}

/** Links by one of their ends. */
class Rows {
  private readonly begin: Uint32Array;
  private readonly list: Uint32Array;

  constructor(links: Uint32Array, end: 0 | 1, count: number) {
    this.begin = new Uint32Array(count + 1);
    for (let i = end; i < links.length; i += 2) ++this.begin[links[i] + 1];
    for (let i = 0; i < count; ++i) this.begin[i + 1] += this.begin[i];
    this.list = new Uint32Array(links.length / 2);
    const next = this.begin.slice();
    for (let i = end; i < links.length; i += 2) this.list[next[links[i]]++] = links[i ^ 1];
  }

  isEmpty(row: number): boolean {
    return this.begin[row] === this.begin[row + 1];
  }

  forEach(row: number, visit: (other: number) => void): void {
    for (let i = this.begin[row]; i < this.begin[row + 1]; ++i) visit(this.list[i]);
  }
}
