// SPDX-License-Identifier: Apache-2.0
import { svg } from "../ui/dom";

/** Where the label of a cell belongs, in pixels of the window. */
export interface ScreenAnchor {
  text: string;
  x: number;
  y: number;
  /** Radius of a disc that the label may fill; undefined: it stands beside the place. */
  room: number | undefined;
}

const font = 14;
const smallFont = 12;
const smallestFont = 9.5;
const mostLabels = 800;
const cell = 64; // pixels

/** Writes labels over a picture such that none covers another: larger room first come first. */
export class Labels {
  readonly element = svg("svg", { class: "labels-over", "aria-hidden": "true" });
  private readonly pool: SVGElement[] = [];

  draw(anchors: ScreenAnchor[]): void {
    const taken = new Map<number, [number, number, number, number][]>();
    let used = 0;
    for (const anchor of anchors) {
      if (used >= mostLabels) break;
      const place = this.place(anchor, taken);
      if (!place) continue;
      const element = (this.pool[used] ??= this.element.appendChild(svg("text", {})));
      ++used;
      element.textContent = anchor.text;
      element.setAttribute("x", place.x.toFixed(1));
      element.setAttribute("y", (place.y + 0.35 * place.size).toFixed(1));
      element.setAttribute("font-size", place.size.toFixed(1));
    }
    for (const spare of this.pool.splice(used)) spare.remove();
  }

  private place(anchor: ScreenAnchor, taken: Map<number, [number, number, number, number][]>) {
    const width = 0.6 * [...anchor.text].length;
    const size = anchor.room === undefined ? smallFont : Math.min(font, anchor.room / Math.hypot(width / 2, 0.5));
    if (size < smallestFont) return undefined;
    const [halfWidth, halfHeight] = [(size * width) / 2, size * 0.55];
    const ways = anchor.room === undefined ? beside : [[0, 0]];
    for (const [wx, wy] of ways) {
      const x = anchor.x + wx * (halfWidth + 5);
      const y = anchor.y + wy * (halfHeight + 5);
      if (x < 0 || y < 0 || x > innerWidth || y > innerHeight) continue;
      if (take(taken, [x - halfWidth, y - halfHeight, x + halfWidth, y + halfHeight])) return { x, y, size };
    }
    return undefined;
  }
}

const beside = [[0.9, -0.9], [-0.9, -0.9], [0.9, 0.9], [-0.9, 0.9], [1, 0], [-1, 0]];

function take(taken: Map<number, [number, number, number, number][]>, box: [number, number, number, number]): boolean {
  const keys: number[] = [];
  for (let i = Math.floor(box[0] / cell); i <= Math.floor(box[2] / cell); ++i) {
    for (let j = Math.floor(box[1] / cell); j <= Math.floor(box[3] / cell); ++j) keys.push(i * 4096 + j);
  }
  const meets = ([l, t, r, b]: [number, number, number, number]) => box[0] < r && l < box[2] && box[1] < b && t < box[3];
  if (keys.some((key) => taken.get(key)?.some(meets))) return false;
  for (const key of keys) taken.set(key, [...(taken.get(key) ?? []), box]);
  return true;
}
