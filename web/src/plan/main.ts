// SPDX-License-Identifier: Apache-2.0
import { cellsOf, readHeader } from "../cells/data";
import { start } from "../cells/start";
import { readGeometry, type SphereHeader } from "../sphere/sphere_data";
import { readPlan } from "./plan_data";
import { PlanPage } from "./plan_page";
import "./plan.css";

start((host) => {
  if (!document.createElement("canvas").getContext("webgl2")) {
    throw new Error("It needs WebGL 2. It may be switched off in the browser's settings, or the graphics driver may be missing.");
  }
  const plan = readPlan();
  const header = readHeader<SphereHeader>("quoin-sphere");
  const geometry = readGeometry(header);
  const sphere = header.faces.length > 0 ? { header, data: cellsOf(header), geometry } : undefined;
  return new PlanPage(host, plan, sphere);
});
