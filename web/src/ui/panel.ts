// SPDX-License-Identifier: Apache-2.0
import { count, number } from "../format";
import { cssColor, originColor } from "../palette";
import type { PartMesh } from "../part_mesh";
import { originName, type Fact, type SceneData } from "../scene_data";
import { el, icon, rows } from "./dom";
import { icons } from "./icons";

const mostListed = 200;

export interface PanelActions {
  showPart(mesh: PartMesh, isShown: boolean): void;
  lightOrigin(origin: number | undefined): void;
}

/** Facts, parts and inputs, on the right. */
export class Panel {
  readonly element = el("aside", { class: "panel glass", "aria-label": "Facts" });

  constructor(
    data: SceneData,
    meshes: PartMesh[],
    private readonly actions: PanelActions,
  ) {
    this.element.append(this.summary(data));
    if (meshes.length > 1) this.element.append(this.parts(meshes));
    else if (meshes[0]?.part.facts.length) this.element.append(this.section(meshes[0].part.name || "Part", rows(meshes[0].part.facts)));
    const origins = originsOf(meshes);
    if (origins.size > 1) this.element.append(this.origins(data, origins));
  }

  get isShown(): boolean {
    return !this.element.hidden;
  }

  set isShown(isShown: boolean) {
    this.element.hidden = !isShown;
  }

  private summary(data: SceneData): HTMLElement {
    const total = (key: "faceCount" | "triangleCount" | "vertexCount") =>
      data.parts.reduce((sum, part) => sum + part[key], 0);
    const facts: Fact[] = [...data.facts];
    const size = sizeOf(data);
    if (size && !facts.some(([name]) => name === "Size")) facts.push(["Size", size]);
    const have = (name: string) => facts.some(([given]) => given.toLowerCase() === name.toLowerCase());
    if (!have("Faces")) facts.push(["Faces", digits(total("faceCount"))]);
    if (!have("Triangles")) facts.push(["Triangles", digits(total("triangleCount"))]);
    if (!have("Vertices")) facts.push(["Vertices", digits(total("vertexCount"))]);
    return this.section("", rows(facts));
  }

  private section(title: string, ...content: Node[]): HTMLElement {
    return el("section", {}, title ? el("h2", {}, title) : undefined, ...content);
  }

  private parts(meshes: PartMesh[]): HTMLElement {
    const list = el("ul", { class: "list" });
    for (const mesh of meshes.slice(0, mostListed)) list.append(this.partRow(mesh));
    if (meshes.length > mostListed) list.append(el("li", { class: "more" }, `and ${meshes.length - mostListed} more`));
    return this.section(count(meshes.length, "part"), list);
  }

  private partRow(mesh: PartMesh): HTMLElement {
    const name = mesh.part.name || `Part ${mesh.index}`;
    const toggle = el(
      "button",
      { type: "button", class: "eye", "aria-pressed": "true", "aria-label": `Show ${name}`, title: "Hide or show" },
      icon(icons.eye),
    );
    toggle.addEventListener("click", () => {
      const isShown = toggle.getAttribute("aria-pressed") !== "true";
      toggle.setAttribute("aria-pressed", `${isShown}`);
      this.actions.showPart(mesh, isShown);
    });
    const facts: Fact[] = [...mesh.part.facts];
    if (!facts.some(([key]) => key.toLowerCase() === "faces")) facts.push(["Faces", digits(mesh.part.faceCount)]);
    const swatch = el("span", { class: "swatch", style: `background:${cssColor(mesh.capColor)}` });
    const details = el("details", {}, el("summary", { title: name }, swatch, el("span", { class: "name" }, name)), rows(facts));
    return el("li", { class: "part" }, details, toggle);
  }

  private origins(data: SceneData, origins: Map<number, number>): HTMLElement {
    const list = el("ul", { class: "list origins", onmouseleave: () => this.actions.lightOrigin(undefined) });
    const sorted = [...origins].sort((a, b) => a[0] - b[0]);
    for (const [origin, faces] of sorted.slice(0, mostListed)) {
      const light = () => this.actions.lightOrigin(origin);
      const name = originName(data, origin);
      list.append(
        el(
          "li",
          { onmouseenter: light, onfocus: light, onblur: () => this.actions.lightOrigin(undefined), tabindex: 0, title: name },
          el("span", { class: "swatch", style: `background:${cssColor(originColor(origin))}` }),
          el("span", { class: "name" }, name),
          el("span", { class: "count" }, digits(faces)),
        ),
      );
    }
    if (sorted.length > mostListed) list.append(el("li", { class: "more" }, `and ${sorted.length - mostListed} more`));
    return this.section("Faces by input", list);
  }
}

/** Number of faces by input. */
function originsOf(meshes: PartMesh[]): Map<number, number> {
  const counts = new Map<number, number>();
  for (const { part } of meshes) {
    for (let face = 0; face < part.faceCount; ++face) {
      counts.set(part.origin(face), (counts.get(part.origin(face)) ?? 0) + 1);
    }
  }
  return counts;
}

function sizeOf(data: SceneData): string {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const part of data.parts) {
    for (let v = 0; v < part.vertexCount; ++v) {
      part.vertex(v).forEach((x, axis) => {
        low[axis] = Math.min(low[axis], x);
        high[axis] = Math.max(high[axis], x);
      });
    }
  }
  if (!(low[0] <= high[0])) return "";
  return `${low.map((x, axis) => number(high[axis] - x, 6)).join(" × ")}${data.unit ? ` ${data.unit}` : ""}`;
}

function digits(n: number): string {
  return n.toLocaleString("en").replaceAll(",", "\u202f");
}
