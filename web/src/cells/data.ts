// SPDX-License-Identifier: Apache-2.0
// What quoin/view/cells_json.h writes of the cells of a picture.

export type CellKind = "face" | "edge" | "point";
export type Fact = [string, string];
type Row = [name: string, label: string, facts: Fact[], color: number];
/** Fill on light, fill on dark, line on light, line on dark. */
export type Shades = [string, string, string, string];

export interface Cell {
  kind: CellKind;
  index: number;
  name: string;
  label: string;
  facts: Fact[];
  color: number; ///< index into colors, or -1
}

export interface CellsHeader {
  format: string;
  version: number;
  title: string;
  facts: Fact[];
  legend: [string, number][];
  colors: Shades[];
  faces: Row[];
  edges: Row[];
  points: Row[];
}

export interface CellsData {
  title: string;
  facts: Fact[];
  legend: [string, number][];
  colors: Shades[];
  cells: Record<CellKind, Cell[]>;
}

export const kinds: CellKind[] = ["face", "edge", "point"];

/** The header of that name, which leaves the document. Throws an Error that says what is wrong. */
export function readHeader<Header extends CellsHeader>(format: string): Header {
  const element = document.getElementById(format);
  if (!element) throw new Error("This page holds no picture: it is the empty template of the view.");
  let header: Header;
  try {
    header = JSON.parse(element.textContent ?? "") as Header;
  } catch {
    throw new Error("The picture in this page is incomplete; the file may have been cut short.");
  }
  if (header.format !== format || header.version !== 1) {
    throw new Error("This page holds a picture in a format that it does not know.");
  }
  element.remove();
  return header;
}

export function cellsOf(header: CellsHeader): CellsData {
  const { title, facts, legend, colors } = header;
  const cells = (kind: CellKind, rows: Row[]) =>
    rows.map(([name, label, ownFacts, color], index) => ({
      kind,
      index,
      name: name || `${kind[0].toUpperCase()}${kind.slice(1)} ${index}`,
      label,
      facts: ownFacts,
      color,
    }));
  return {
    title,
    facts,
    legend,
    colors,
    cells: { face: cells("face", header.faces), edge: cells("edge", header.edges), point: cells("point", header.points) },
  };
}
