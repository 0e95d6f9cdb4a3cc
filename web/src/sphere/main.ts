// SPDX-License-Identifier: Apache-2.0
import { CellsPage } from "../cells/cells_page";
import { cellsOf, readHeader } from "../cells/data";
import { start } from "../cells/start";
import { readGeometry, type SphereHeader } from "./sphere_data";
import { SphereView } from "./sphere_view";

const keys: [string, string][] = [
  ["Drag, arrow keys", "turn"],
  ["Wheel, pinch", "zoom"],
  ["A  X", "turn by itself, see through"],
];

start((host) => {
  const header = readHeader<SphereHeader>("quoin-sphere");
  const data = cellsOf(header);
  return new CellsPage(host, data, new SphereView(header, data, readGeometry(header)), keys);
});
