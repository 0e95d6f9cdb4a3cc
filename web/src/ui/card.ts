// SPDX-License-Identifier: Apache-2.0
import { exactPlaneText, type ExactPlane } from "../exact_plane";
import { facePlane, number, shortened, type FacePlane } from "../format";
import { faceNormal } from "../part_geometry";
import type { Hit } from "../picking";
import { originName, type SceneData } from "../scene_data";
import { faceArea } from "../face_area";
import { el, icon, rows } from "./dom";
import { icons } from "./icons";

export interface FaceInfo {
  part: string;
  partIndex: number;
  face: number;
  plane: string; ///< exact, of any length, unless it begins with ≈
  normal: string;
  origins: { origin: number; name: string; face: number }[];
}

const mostOrigins = 6;

function planeOf(hit: Hit): FacePlane {
  return facePlane(hit.mesh.part, hit.face, hit.triangle);
}

export function describeFace(data: SceneData, hit: Hit): FaceInfo {
  const { part, index } = hit.mesh;
  const plane = planeOf(hit);
  return {
    part: part.name || `Part ${index}`,
    partIndex: index,
    face: hit.face,
    plane: plane.exact ? exactPlaneText(plane.exact) : plane.text,
    normal: `(${faceNormal(part, hit.face, hit.triangle).map((x) => number(x, 7)).join(", ")})`,
    origins: part.origins(hit.face).map(({ origin, face }) => ({ origin, face, name: originName(data, origin) })),
  };
}

/** What is known about the picked face. */
export class FaceCard {
  readonly element = el("div", { class: "card glass", "aria-live": "polite", hidden: true });

  constructor(
    private readonly data: SceneData,
    private readonly close: () => void,
    private readonly cut: () => void,
  ) {}

  show(hit: Hit): void {
    const info = describeFace(this.data, hit);
    const plane = planeOf(hit);
    const from = el("span");
    info.origins.slice(0, mostOrigins).forEach(({ name, face }) => from.append(el("div", {}, `${name}, face ${face}`)));
    if (info.origins.length > mostOrigins) from.append(el("div", {}, `and ${info.origins.length - mostOrigins} more`));
    const unit = this.data.unit ? ` ${this.data.unit}²` : "";
    this.element.replaceChildren(
      el(
        "header",
        {},
        el("h2", {}, `Face ${info.face}`),
        el("span", { class: "of" }, info.part),
        el("button", { type: "button", "aria-label": "Close", onclick: () => this.close() }, icon(icons.close)),
      ),
      rows([
        ["Plane", el("code", {}, plane.text)],
        ...(plane.exact ? [this.exactRow(plane.exact, info.plane)] : []),
        ["Normal", el("code", {}, info.normal)],
        ["Area", `≈ ${number(faceArea(hit.mesh.part, hit.face), 7)}${unit}`],
        ["From", from],
      ]),
      el("button", { type: "button", class: "action", onclick: () => this.cut() }, "Cut parallel to this face"),
    );
    this.element.hidden = false;
  }

  /** What is too long to read can be copied. */
  private exactRow(plane: ExactPlane, whole: string): [string, Node] {
    const copy = el("button", { type: "button", class: "copy" }, "Copy in full");
    copy.addEventListener("click", () => void copyText(whole).then((done) => (copy.textContent = done ? "Copied" : "Could not copy")));
    return ["Exactly", el("span", {}, el("code", { title: whole }, shortened(plane)), copy)];
  }

  hide(): void {
    this.element.hidden = true;
  }
}

/** Pages opened from a file may not have the clipboard's interface: then through a selection. */
async function copyText(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const field = el("textarea", { class: "hidden-text" });
    field.value = text;
    document.body.append(field);
    field.select();
    const done = document.execCommand("copy");
    field.remove();
    return done;
  }
}
