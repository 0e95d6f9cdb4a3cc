// SPDX-License-Identifier: Apache-2.0
import type { Insets } from "../cells/view";

const mostZoom = 4000;

/** Which part of a sheet the window shows: window = (x, y) + scale * sheet. */
export class PanAndZoom {
  x = 0;
  y = 0;
  scale = 1;
  private insets: Insets = { top: 0, right: 0, bottom: 0, left: 0 };
  private readonly pointers = new Map<number, { x: number; y: number }>();

  constructor(
    host: HTMLElement,
    private readonly sheet: [number, number],
    private readonly changed: () => void,
  ) {
    host.addEventListener("wheel", (event) => this.onWheel(event), { passive: false });
    host.addEventListener("pointerdown", (event) => {
      this.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      host.setPointerCapture(event.pointerId);
    });
    host.addEventListener("pointermove", (event) => this.onMove(event));
    for (const end of ["pointerup", "pointercancel"] as const) {
      host.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    }
  }

  setInsets(insets: Insets): void {
    const before = this.middle();
    this.insets = insets;
    const after = this.middle();
    this.pan(after.x - before.x, after.y - before.y);
  }

  fit(): void {
    const { width, height } = this.middle();
    this.scale = this.fittingScale();
    this.x = this.insets.left + (width - this.scale * this.sheet[0]) / 2;
    this.y = this.insets.top + (height - this.scale * this.sheet[1]) / 2;
    this.changed();
  }

  pan(dx: number, dy: number): void {
    this.x += dx;
    this.y += dy;
    this.changed();
  }

  zoomInMiddle(factor: number): void {
    const { x, y } = this.middle();
    this.zoomAt(x, y, factor);
  }

  /** Makes a place of the sheet seen, with what is around it. */
  bring(x: number, y: number, size: number): void {
    const { x: mx, y: my, width, height } = this.middle();
    const seen = Math.min(width, height);
    if (size > 0 && size * this.scale < seen / 40) this.scale = Math.min((seen / 4) / size, 60 * this.fittingScale());
    const [wx, wy] = [this.x + this.scale * x, this.y + this.scale * y];
    const isSeen = Math.abs(wx - mx) < 0.42 * width && Math.abs(wy - my) < 0.42 * height;
    if (!isSeen) [this.x, this.y] = [mx - this.scale * x, my - this.scale * y];
    this.changed();
  }

  private fittingScale(): number {
    const { width, height } = this.middle();
    return 0.96 * Math.min(width / this.sheet[0], height / this.sheet[1]);
  }

  /** Of what is free of the window. */
  private middle() {
    const { top, right, bottom, left } = this.insets;
    const width = Math.max(100, innerWidth - left - right);
    const height = Math.max(100, innerHeight - top - bottom);
    return { x: left + width / 2, y: top + height / 2, width, height };
  }

  private zoomAt(x: number, y: number, factor: number): void {
    const least = 0.3 * this.fittingScale();
    const next = Math.min(Math.max(this.scale * factor, least), mostZoom * this.fittingScale());
    const by = next / this.scale;
    this.x = x - by * (x - this.x);
    this.y = y - by * (y - this.y);
    this.scale = next;
    this.changed();
  }

  private onWheel(event: WheelEvent): void {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 33 : event.deltaMode === 2 ? 400 : 1;
    this.zoomAt(event.clientX, event.clientY, Math.exp(-event.deltaY * lines * (event.ctrlKey ? 0.01 : 0.0016)));
  }

  private onMove(event: PointerEvent): void {
    const last = this.pointers.get(event.pointerId);
    if (!last) return;
    const now = { x: event.clientX, y: event.clientY };
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
    this.pointers.set(event.pointerId, now);
    if (!other) return this.pan(now.x - last.x, now.y - last.y);
    const spread = (p: { x: number; y: number }) => Math.max(10, Math.hypot(p.x - other.x, p.y - other.y));
    this.pan((now.x - last.x) / 2, (now.y - last.y) / 2);
    this.zoomAt((now.x + other.x) / 2, (now.y + other.y) / 2, spread(now) / spread(last));
  }
}
