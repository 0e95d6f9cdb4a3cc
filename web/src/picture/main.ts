// SPDX-License-Identifier: Apache-2.0
import { CellsPage } from "../cells/cells_page";
import { cellsOf, readHeader } from "../cells/data";
import { start } from "../cells/start";
import { PlanarView, type PictureHeader } from "./planar_view";

const keys: [string, string][] = [
  ["Drag, arrow keys", "move"],
  ["Wheel, pinch", "zoom to the pointer"],
];

start((host) => {
  const header = readHeader<PictureHeader>("quoin-picture");
  const data = cellsOf(header);
  return new CellsPage(host, data, new PlanarView(header, data), keys);
});
