// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import { svg } from "./dom";

const axes: [string, THREE.Vector3, string][] = [
  ["X", new THREE.Vector3(1, 0, 0), "var(--axis-x)"],
  ["Y", new THREE.Vector3(0, 1, 0), "var(--axis-y)"],
  ["Z", new THREE.Vector3(0, 0, 1), "var(--axis-z)"],
];
const size = 76;
const arm = 26;

/** The three directions as they are seen; a click looks along one. */
export class Gizmo {
  readonly element = svg("svg", { viewBox: `0 0 ${size} ${size}`, width: size, height: size, class: "gizmo" });
  private readonly parts: { axis: THREE.Vector3; line: SVGElement | undefined; knob: SVGElement }[] = [];

  constructor(look: (direction: THREE.Vector3) => void) {
    for (const [name, axis, color] of axes) {
      this.add(name, axis, color, look);
      this.add("", axis.clone().negate(), color, look);
    }
  }

  update(camera: THREE.Camera): void {
    const turn = camera.quaternion.clone().invert();
    const seen = this.parts.map((part) => ({ part, at: part.axis.clone().applyQuaternion(turn) }));
    seen.sort((a, b) => a.at.z - b.at.z);
    for (const { part, at } of seen) {
      const x = size / 2 + arm * at.x;
      const y = size / 2 - arm * at.y;
      part.knob.setAttribute("transform", `translate(${x.toFixed(2)} ${y.toFixed(2)})`);
      part.knob.style.opacity = at.z < -0.3 ? "0.7" : "1";
      if (part.line) {
        part.line.setAttribute("x2", x.toFixed(2));
        part.line.setAttribute("y2", y.toFixed(2));
        this.element.append(part.line);
      }
      this.element.append(part.knob);
    }
  }

  private add(name: string, axis: THREE.Vector3, color: string, look: (direction: THREE.Vector3) => void): void {
    const line = name
      ? svg("line", { x1: size / 2, y1: size / 2, style: `stroke:${color}`, "stroke-width": 2, "stroke-linecap": "round" })
      : undefined;
    const knob = svg("g", { class: name ? "knob" : "knob far", style: `--axis:${color}` });
    knob.append(svg("circle", { r: name ? 8 : 4.5 }));
    if (name) {
      const text = svg("text", { "text-anchor": "middle", dy: "0.36em" });
      text.textContent = name;
      knob.append(text);
    }
    knob.addEventListener("click", () => look(axis));
    this.parts.push({ axis, line, knob });
  }
}
