// SPDX-License-Identifier: Apache-2.0
import type { Tool } from "../ui/toolbar";
import type { Cell } from "./data";

export type Layer = "points" | "edges" | "faces" | "labels";

/** Margins of the window that are covered, in pixels. */
export interface Insets {
  top: number;
  right: number;
  bottom: number;
  left: number;
}

/** What draws the cells of a picture. Pixels are those of the window. */
export interface CellsView {
  /** What lies under the pointer, in what covers the window. */
  readonly element: HTMLElement;
  cellAt(x: number, y: number): Cell | undefined;
  light(hovered: Cell | undefined, picked: Cell | undefined): void;
  /** Moves, if need be, until the cell is seen. */
  bring(cell: Cell): void;
  show(layer: Layer, isShown: boolean): void;
  fit(): void;
  /** By a key: one step to the right and down, as the eye goes. */
  step(right: number, down: number): void;
  zoom(factor: number): void;
  setInsets(insets: Insets): void;
  themeChanged(isDark: boolean): void;
  /** Tools of this view alone. */
  tools(refresh: () => void): Tool[];
}
