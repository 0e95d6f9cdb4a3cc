// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import { Explosion } from "./explosion";
import { Measure } from "./measure";
import { count } from "./format";
import { faceNormal } from "./part_geometry";
import { PartMesh } from "./part_mesh";
import { Picker, type Hit } from "./picking";
import type { SceneData } from "./scene_data";
import { Section, type SectionAxis } from "./section";
import { isometric, Stage } from "./stage";
import { makeTestHook, type TestHook } from "./test_hook";
import { Theme } from "./theme";
import { FaceCard } from "./ui/card";
import { ExplosionDock, SectionDock } from "./ui/docks";
import { el } from "./ui/dom";
import { Gizmo } from "./ui/gizmo";
import { helpSheet } from "./ui/help";
import { Panel } from "./ui/panel";
import { Toolbar, type Tool } from "./ui/toolbar";
import { SectionHandle } from "./ui/section_handle";

const isNarrow = () => innerWidth <= 760;
const snapReach = 9; // pixels
const mostTrianglesToHover = 250_000; // beyond it, looking under the pointer at every move would cost too much
const mostEdgesAtFirst = 400_000;

/** The whole page. */
export class Viewer {
  readonly stage: Stage;
  readonly meshes: PartMesh[] = [];
  readonly picker: Picker;
  readonly section: Section;
  readonly explosion: Explosion;
  readonly measure: Measure;
  readonly triangleCount: number;
  picked: Hit | undefined;
  areEdgesShown = true;
  areNormalsShown = false;
  private readonly theme = new Theme(() => this.applyTheme());
  private readonly toolbar: Toolbar;
  private readonly panel: Panel;
  private readonly card: FaceCard;
  private readonly sectionDock: SectionDock;
  private readonly explosionDock: ExplosionDock;
  private readonly handle: SectionHandle;
  private readonly help = helpSheet();
  private readonly toast = el("div", { class: "toast glass", role: "status", hidden: true });
  private isChoosingFace = false;
  private pointer: { x: number; y: number } | undefined;

  constructor(
    private readonly host: HTMLElement,
    readonly data: SceneData,
    device: string,
    tell: (title: string, explanation: string) => void,
  ) {
    const canvasHost = el("div", { class: "stage" });
    host.append(canvasHost);
    // Drawn by the processor, many small triangles cost three times as much with smooth outlines.
    const isSoftware = /swiftshader|llvmpipe|software|basic render/i.test(device);
    const triangles = data.parts.reduce((sum, part) => sum + part.triangleCount, 0);
    this.stage = new Stage(canvasHost, !isSoftware || triangles < 150_000);
    this.triangleCount = this.addParts();
    this.explosion = new Explosion(this.stage, this.meshes);
    this.picker = new Picker(this.stage, this.meshes, data);
    this.section = new Section(this.stage, this.meshes, () => this.explosion.corners(), () => this.colorLines());
    this.measure = new Measure(data, this.stage);

    this.panel = new Panel(data, this.meshes, {
      showPart: (mesh, isShown) => this.showPart(mesh, isShown),
      lightOrigin: (origin) => this.lightOrigin(origin),
    });
    this.panel.isShown = !isNarrow();
    this.card = new FaceCard(data, () => this.pick(undefined), () => this.cutAlongPicked());
    this.sectionDock = new SectionDock(data, this.section, (axis) => this.chooseAxis(axis), () => this.applySection());
    this.explosionDock = new ExplosionDock(this.explosion, () => this.applyExplosion());
    this.handle = new SectionHandle(this.stage, this.section, () => this.applySection());
    const tools = this.tools();
    this.toolbar = new Toolbar(tools);
    const gizmo = new Gizmo((direction) => this.look(direction));
    host.append(
      this.measure.overlay,
      this.handle.element,
      this.heading(),
      gizmo.element,
      this.panel.element,
      el("div", { class: "bottom" }, this.toast, el("div", { class: "cards" }, this.card.element, this.measure.card), this.sectionDock.element, this.explosionDock.element, this.toolbar.element),
      this.help,
    );
    this.stage.onFrame = () => {
      this.measure.draw();
      this.handle.update();
      gizmo.update(this.stage.camera);
    };
    this.areEdgesShown = data.parts.reduce((sum, part) => sum + part.edges.length / 2, 0) <= mostEdgesAtFirst;
    this.listen(tools.flat());
    this.stage.renderer.domElement.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      tell("The graphics device was lost.", "Reload the page to draw again.");
    });
    this.showEdges();
    this.makeRoom();
    window.addEventListener("resize", () => this.makeRoom());
    this.stage.lookFrom(isometric, false);
    if (this.triangleCount === 0) this.say("There is nothing to show: the scene is empty.", true);
  }

  testHook(): TestHook {
    return makeTestHook(this);
  }

  pick(hit: Hit | undefined): void {
    this.picked = hit;
    for (const mesh of this.meshes) mesh.highlight(hit?.mesh === mesh ? hit.face : -1);
    if (hit) this.card.show(hit);
    else this.card.hide();
    this.stage.invalidate();
  }

  applySection(): void {
    this.section.apply();
    this.sectionDock.refresh();
    this.makeRoom();
    this.toolbar.refresh();
  }

  setExplosion(amount: number): void {
    this.explosion.amount = amount;
    this.explosionDock.amount = amount;
    this.applyExplosion();
  }

  chooseAxis(axis: SectionAxis): void {
    this.section.isOn = true;
    if (axis !== "face") {
      this.section.axis = axis;
      this.section.faceViewer();
      this.applySection();
    } else if (this.picked) {
      this.cutAlongPicked();
    } else {
      this.isChoosingFace = true;
      this.say("Pick the face to cut parallel to.", true);
    }
  }

  private addParts(): number {
    let triangles = 0;
    this.data.parts.forEach((part, index) => {
      const mesh = new PartMesh(part, index, triangles, this.stage.shared);
      triangles += part.triangleCount;
      this.meshes.push(mesh);
      this.stage.scene.add(mesh.group);
    });
    return triangles;
  }

  private heading(): HTMLElement {
    const faces = this.data.parts.reduce((sum, part) => sum + part.faceCount, 0);
    const summary = `${count(faces, "face")} · ${count(this.triangleCount, "triangle")}`;
    return el("div", { class: "heading" }, el("h1", {}, this.data.title || "Quoin"), el("p", {}, summary));
  }

  private tools(): Tool[][] {
    const { stage, section, measure } = this;
    return [
      [{ icon: "fit", name: "Fit", key: "F", run: () => stage.fit() }],
      [
        { icon: "edges", name: "Edges", key: "E", isOn: () => this.areEdgesShown, run: () => this.toggleEdges() },
        { icon: "triangles", name: "Triangles", key: "W", isOn: () => stage.shared.showTriangles.value > 0, run: () => this.toggleTriangles() },
        { icon: "normals", name: "Normals", key: "N", isOn: () => this.areNormalsShown, run: () => this.toggleNormals() },
      ],
      [
        { icon: "section", name: "Section", key: "S", isOn: () => section.isOn, run: () => this.toggleSection() },
        {
          icon: "explode",
          name: "Pull apart",
          key: "A",
          isOn: () => this.explosion.amount > 0,
          run: () => this.toggleExplosion(),
          isHidden: this.explosion.pieceCount < 2,
        },
        { icon: "measure", name: "Measure", key: "M", isOn: () => measure.isOn, run: () => this.toggleMeasure() },
      ],
      [
        { icon: "ortho", name: "Parallel view", key: "O", isOn: () => stage.isOrthographic, run: () => this.toggleOrthographic() },
        { icon: "theme", name: "Light or dark", key: "L", run: () => this.theme.toggle() },
        { icon: "info", name: "Facts", key: "I", isOn: () => this.panel.isShown, run: () => this.togglePanel() },
        { icon: "help", name: "Keys", key: "?", run: () => this.toggleHelp() },
      ],
    ];
  }

  private toggleEdges(): void {
    this.areEdgesShown = !this.areEdgesShown;
    this.showEdges();
  }

  private showEdges(): void {
    for (const mesh of this.meshes) mesh.showEdges(this.areEdgesShown);
    this.applyTheme();
  }

  private toggleTriangles(): void {
    const shown = this.stage.shared.showTriangles;
    shown.value = 1 - shown.value;
    this.changed();
  }

  private toggleNormals(): void {
    this.areNormalsShown = !this.areNormalsShown;
    for (const mesh of this.meshes) mesh.showNormals(this.areNormalsShown);
    this.applyTheme();
  }

  private toggleSection(): void {
    this.section.isOn = !this.section.isOn;
    if (this.section.isOn) this.section.faceViewer();
    this.isChoosingFace = false;
    this.say("");
    this.applySection();
  }

  private toggleExplosion(): void {
    this.setExplosion(this.explosion.amount > 0 ? 0 : 0.5);
    this.stage.fit();
  }

  private applyExplosion(): void {
    this.explosionDock.element.hidden = this.explosion.amount === 0 && !this.explosionDock.element.matches(":focus-within");
    if (this.measure.places.length > 0) this.measure.setOn(this.measure.isOn);
    this.applySection();
  }

  private toggleMeasure(): void {
    this.measure.setOn(!this.measure.isOn);
    if (this.measure.isOn) this.pick(undefined);
    this.host.classList.toggle("measuring", this.measure.isOn);
    this.changed();
  }

  /** What the panel and the tools leave free. */
  private makeRoom(): void {
    const right = this.panel.isShown && !isNarrow() ? this.panel.element.offsetWidth + 16 : 0;
    const docks = [this.sectionDock.element, this.explosionDock.element].filter((dock) => !dock.hidden).length;
    this.stage.setInsets({ top: 62, right, bottom: 68, left: 0 }, 46 * docks);
  }

  private toggleOrthographic(): void {
    this.stage.setOrthographic(!this.stage.isOrthographic);
    this.changed();
  }

  private togglePanel(): void {
    this.panel.isShown = !this.panel.isShown;
    this.makeRoom();
    this.changed();
  }

  private toggleHelp(): void {
    if (this.help.open) this.help.close();
    else this.help.showModal();
  }

  private look(direction: THREE.Vector3): void {
    // Straight down has no up of its own: lean a little towards the front.
    const nearPole = Math.abs(direction.z) > 0.99 * direction.length();
    this.stage.lookFrom(nearPole ? new THREE.Vector3(0, -1e-4, direction.z) : direction);
  }

  private changed(): void {
    this.toolbar.refresh();
    this.stage.invalidate();
  }

  private showPart(mesh: PartMesh, isShown: boolean): void {
    mesh.show(isShown);
    if (!isShown && this.picked?.mesh === mesh) this.pick(undefined);
    this.explosion.measure();
    this.applySection();
  }

  private lightOrigin(origin: number | undefined): void {
    this.stage.shared.highlightOrigin.value = origin ?? -1;
    this.stage.invalidate();
  }

  private cutAlongPicked(): void {
    if (!this.picked) return;
    const { mesh, face, triangle } = this.picked;
    const normal = new THREE.Vector3(...faceNormal(mesh.part, face, triangle));
    const corner = mesh.part.vertex(mesh.part.triangles[3 * triangle]);
    const offset = mesh.offset(mesh.part.piece(face));
    const { center, scale } = this.data;
    const drawn = new THREE.Vector3(...corner.map((x, k) => (x - center[k]) / scale + offset[k]));
    this.section.isOn = true;
    this.section.isFlipped = false;
    this.section.alongFace(normal, drawn.dot(normal));
    this.applySection();
  }

  private applyTheme(): void {
    const accent = getComputedStyle(document.documentElement).getPropertyValue("--accent").trim();
    this.stage.shared.accent.value.setStyle(accent, THREE.SRGBColorSpace);
    this.colorLines();
    this.changed();
  }

  private colorLines(): void {
    const style = getComputedStyle(document.documentElement);
    const parse = (name: string) => new THREE.Color().setStyle(style.getPropertyValue(name).trim(), THREE.LinearSRGBColorSpace);
    const line = parse("--edge");
    const normal = parse("--normal");
    for (const mesh of this.meshes) {
      mesh.setLineColors(new THREE.Vector4(line.r, line.g, line.b, 0.85), new THREE.Vector4(normal.r, normal.g, normal.b, 1));
    }
    this.stage.invalidate();
  }

  private say(text: string, stays = false): void {
    this.toast.textContent = text;
    this.toast.hidden = text === "";
    if (text && !stays) setTimeout(() => (this.toast.hidden = true), 2500);
  }

  private listen(tools: Tool[]): void {
    const canvas = this.stage.renderer.domElement;
    let down: { x: number; y: number } | undefined;
    canvas.addEventListener("pointerdown", (event) => {
      down = event.isPrimary && event.button === 0 ? { x: event.offsetX, y: event.offsetY } : undefined;
      this.hover(undefined);
    });
    canvas.addEventListener("pointerup", (event) => {
      if (!down || Math.hypot(event.offsetX - down.x, event.offsetY - down.y) > 4) return;
      this.click(event.offsetX, event.offsetY);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (event.buttons !== 0 || event.pointerType === "touch") return;
      const isScheduled = this.pointer !== undefined;
      this.pointer = { x: event.offsetX, y: event.offsetY };
      if (!isScheduled) requestAnimationFrame(() => this.hoverAtPointer());
    });
    canvas.addEventListener("pointerleave", () => this.hover(undefined));
    canvas.addEventListener("dblclick", () => this.stage.fit());
    window.addEventListener("keydown", (event) => this.key(event, tools));
  }

  private click(x: number, y: number): void {
    if (this.measure.isOn) {
      const place = this.picker.placeAt(x, y, snapReach);
      if (place) this.measure.add(place);
      return;
    }
    const hit = this.picker.hitAt(x, y);
    this.pick(hit && this.section.isOn && hit.isBack ? undefined : hit);
    if (this.isChoosingFace && this.picked) {
      this.isChoosingFace = false;
      this.say("");
      this.cutAlongPicked();
    }
  }

  private hoverAtPointer(): void {
    const at = this.pointer;
    this.pointer = undefined;
    if (!at || this.triangleCount > mostTrianglesToHover) return;
    if (this.measure.isOn) this.measure.hover(this.picker.placeAt(at.x, at.y, snapReach));
    else this.hover(this.picker.hitAt(at.x, at.y));
  }

  private hovered: Hit | undefined;

  private hover(hit: Hit | undefined): void {
    const shown = hit && this.section.isOn && hit.isBack ? undefined : hit;
    if (shown?.mesh === this.hovered?.mesh && shown?.face === this.hovered?.face) return;
    this.hovered = shown;
    for (const mesh of this.meshes) mesh.hover(shown?.mesh === mesh ? shown.face : -1);
    this.stage.invalidate();
  }

  private key(event: KeyboardEvent, tools: Tool[]): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const key = event.key.length === 1 ? event.key.toUpperCase() : event.key;
    const tool = tools.find((t) => t.key === key && !t.isHidden);
    const views: Record<string, THREE.Vector3> = {
      "1": new THREE.Vector3(0, -1, 0),
      "2": new THREE.Vector3(1, 0, 0),
      "3": new THREE.Vector3(0, 0, 1),
      "4": isometric,
    };
    if (tool) tool.run();
    else if (views[key]) this.look(views[key]);
    else if (this.section.isOn && ["X", "Y", "Z"].includes(key)) this.chooseAxis(key.toLowerCase() as SectionAxis);
    else if (this.section.isOn && key === "C") this.flipSection();
    else if (key === "Escape") this.letGo();
  }

  private flipSection(): void {
    this.section.isFlipped = !this.section.isFlipped;
    this.applySection();
  }

  private letGo(): void {
    this.isChoosingFace = false;
    this.say("");
    if (this.picked) this.pick(undefined);
    else if (this.measure.isOn) this.toggleMeasure();
    else if (this.section.isOn) this.toggleSection();
  }
}
