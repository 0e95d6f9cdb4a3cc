// SPDX-License-Identifier: Apache-2.0
import { start } from "../cells/start";
import { readLayers } from "./layered_data";
import { LayersPage } from "./layers_page";
import "./layers.css";

start((host) => {
  if (!document.createElement("canvas").getContext("webgl2")) {
    throw new Error("It needs WebGL 2. It may be switched off in the browser's settings, or the graphics driver may be missing.");
  }
  return new LayersPage(host, readLayers());
});
