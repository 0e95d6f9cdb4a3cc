// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Cell, CellsData } from "../cells/data";
import type { CellsView, Insets, Layer } from "../cells/view";
import { Labels, type ScreenAnchor } from "../picture/labels";
import { el } from "../ui/dom";
import type { Tool } from "../ui/toolbar";
import { Globe } from "./globe";
import { Dots, Lines } from "./marks";
import type { SphereGeometry, SphereHeader } from "./sphere_data";
import { faceMiddles, SpherePicker } from "./sphere_picker";

const fieldOfView = 28;
const layers = { faces: "face", edges: "edge", points: "point" } as const;
const prefersStillness = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** A ball with what lies on it. Draws only when something changed. */
export class SphereView implements CellsView {
  readonly element = el("div", { class: "stage" });
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.PerspectiveCamera(fieldOfView, 1, 0.1, 40);
  private readonly renderer: THREE.WebGLRenderer;
  private readonly controls: OrbitControls;
  private readonly globe: Globe;
  private readonly lines: Lines[];
  private readonly pathsOf: { paths: Float32Array[]; edges: number[] }[];
  private readonly dots: Dots;
  private readonly litLines: [hovered: Lines, picked: Lines] = [new Lines(5, [], 1.0025), new Lines(6, [], 1.0028)];
  private readonly litDots: [hovered: Dots, picked: Dots] = [new Dots(new Float32Array(0), 15), new Dots(new Float32Array(0), 17)];
  private readonly picker: SpherePicker;
  private readonly labels = new Labels();
  private readonly middles: ([number, number, number] | readonly [number, number, number] | undefined)[];
  private insets: Insets = { top: 0, right: 0, bottom: 0, left: 0 };
  private areLabelsShown = true;
  private isGlass = false;
  private isScheduled = false;
  private lastFrame = 0;

  constructor(
    header: SphereHeader,
    private readonly data: CellsData,
    private readonly geometry: SphereGeometry,
  ) {
    if (!document.createElement("canvas").getContext("webgl2")) {
      throw new Error("It needs WebGL 2. It may be switched off in the browser's settings, or the graphics driver may be missing.");
    }
    this.renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace; // colours go through as they are given
    this.renderer.domElement.setAttribute("aria-label", data.title || "Sphere");
    this.element.append(this.renderer.domElement, this.labels.element);
    this.globe = new Globe(geometry.map, data.cells.face.length);
    this.picker = new SpherePicker(data, geometry);
    this.pathsOf = [0, 1, 2].map((weight) => {
      const edges = header.styles.flatMap((style, i) => (weightOf(style) === weight ? [i] : []));
      return { edges, paths: edges.map((edge) => geometry.paths[edge]) };
    });
    this.lines = [1.8, 3.4, 1].map((width, i) => new Lines(width, this.pathsOf[i].paths));
    this.dots = new Dots(geometry.points, 9);
    this.middles = data.cells.face.some((cell) => cell.label) ? faceMiddles(geometry, data.cells.face.length) : [];
    this.scene.add(this.globe.back, this.globe.front, this.dots.mesh);
    for (const lines of [...this.lines, ...this.litLines]) this.scene.add(lines.mesh);
    for (const dots of this.litDots) this.scene.add(dots.mesh);
    [...this.lines, ...this.litLines].forEach((lines, i) => (lines.mesh.renderOrder = 3 + i));
    [this.dots, ...this.litDots].forEach((dots, i) => (dots.mesh.renderOrder = 10 + i));
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.enablePan = false;
    this.controls.enableDamping = !prefersStillness();
    this.controls.dampingFactor = 0.12;
    this.controls.minDistance = 1.25;
    this.controls.maxDistance = 14;
    this.controls.autoRotateSpeed = 1.2;
    this.controls.addEventListener("change", () => this.invalidate());
    this.controls.addEventListener("start", () => (this.controls.autoRotate = false));
    new ResizeObserver(() => this.resize()).observe(this.element);
    this.lookFrom(new THREE.Vector3(1, 0.55, 0.6));
  }

  cellAt(x: number, y: number): Cell | undefined {
    const at = new THREE.Vector2((x / innerWidth) * 2 - 1, 1 - (y / innerHeight) * 2);
    const caster = new THREE.Raycaster();
    this.camera.updateMatrixWorld();
    caster.setFromCamera(at, this.camera);
    const hit = caster.ray.intersectSphere(new THREE.Sphere(new THREE.Vector3(), 1), new THREE.Vector3());
    if (!hit) return undefined;
    const pixel = (2 * Math.tan(THREE.MathUtils.degToRad(fieldOfView / 2)) * this.camera.position.distanceTo(hit)) / innerHeight;
    return this.picker.cellAt([hit.x, hit.y, hit.z], pixel);
  }

  light(hovered: Cell | undefined, picked: Cell | undefined): void {
    const face = (cell: Cell | undefined) => (cell?.kind === "face" ? cell.index : -1);
    this.globe.light(face(hovered), face(picked));
    const { points, paths } = this.geometry;
    [hovered, picked].forEach((cell, i) => {
      this.litLines[i].setPaths(cell?.kind === "edge" ? [paths[cell.index]] : [], 1.0025);
      this.litDots[i].setPositions(cell?.kind === "point" ? points.slice(3 * cell.index, 3 * cell.index + 3) : new Float32Array(0));
    });
    this.colorLit();
    this.invalidate();
  }

  bring(cell: Cell): void {
    const { points, paths } = this.geometry;
    const path = paths[cell.index];
    const middle = cell.kind === "edge" && path ? 3 * Math.floor(path.length / 6) : 0;
    const to =
      cell.kind === "point"
        ? points.slice(3 * cell.index, 3 * cell.index + 3)
        : cell.kind === "edge"
          ? path.slice(middle, middle + 3)
          : (this.middles[cell.index] ?? faceMiddles(this.geometry, this.data.cells.face.length)[cell.index]);
    if (!to || to.length < 3) return;
    const direction = new THREE.Vector3(to[0], to[1], to[2]);
    if (direction.dot(this.camera.position.clone().normalize()) < 0.75) this.lookFrom(direction);
    this.invalidate();
  }

  show(layer: Layer, isShown: boolean): void {
    if (layer === "labels") this.areLabelsShown = isShown;
    else this.picker.isShown[layers[layer]] = isShown;
    if (layer === "faces") this.globe.showFaces(isShown);
    if (layer === "points") this.dots.mesh.visible = isShown && this.geometry.points.length > 0;
    if (layer === "edges") this.lines.forEach((lines, i) => (lines.mesh.visible = isShown && this.pathsOf[i].paths.length > 0));
    this.invalidate();
  }

  fit(): void {
    const direction = this.camera.position.clone().normalize();
    this.camera.position.copy(direction.multiplyScalar(this.fittingDistance()));
    this.controls.update();
    this.invalidate();
  }

  step(right: number, down: number): void {
    this.controls.autoRotate = false;
    const turned = new THREE.Spherical().setFromVector3(zUpToYUp(this.camera.position));
    turned.theta += 0.12 * right;
    turned.phi = THREE.MathUtils.clamp(turned.phi + 0.12 * down, 0.02, Math.PI - 0.02);
    this.camera.position.copy(yUpToZUp(new THREE.Vector3().setFromSpherical(turned)));
    this.controls.update();
    this.invalidate();
  }

  zoom(factor: number): void {
    const distance = THREE.MathUtils.clamp(this.camera.position.length() / factor, this.controls.minDistance, this.controls.maxDistance);
    this.camera.position.setLength(distance);
    this.controls.update();
    this.invalidate();
  }

  setInsets(insets: Insets): void {
    this.insets = insets;
    this.invalidate();
  }

  themeChanged(isDark: boolean): void {
    const style = getComputedStyle(document.documentElement);
    const color = (text: string) => new THREE.Color().setStyle(text.trim(), THREE.LinearSRGBColorSpace);
    const shade = isDark ? 1 : 0;
    const paper = color(isDark ? "#2b313a" : "#eef0f3");
    const ink = color(isDark ? "#e6e9ee" : "#27303b");
    const halo = color(isDark ? "#1b1f25" : "#fbfbfc");
    const { cells, colors } = this.data;
    const fill = (cell: Cell) => (cell.color < 0 ? paper : color(colors[cell.color][shade]));
    const line = (cell: Cell) => (cell.color < 0 ? ink : color(colors[cell.color][2 + shade]));
    this.globe.setColors([...cells.face.map(fill), paper]);
    this.globe.setTheme(color(style.getPropertyValue("--accent")), color(isDark ? "#0d1014" : "#5d6875"));
    this.lines.forEach((lines, i) => lines.setColors(this.pathsOf[i].paths, this.pathsOf[i].edges.map((edge) => line(cells.edge[edge]))));
    this.dots.setColors(cells.point.map(line), halo);
    this.colorLit();
    this.invalidate();
  }

  tools(refresh: () => void): Tool[] {
    return [
      {
        icon: "turn",
        name: "Turn by itself",
        key: "A",
        isOn: () => this.controls.autoRotate,
        run: () => {
          this.controls.autoRotate = !this.controls.autoRotate;
          this.invalidate();
          refresh();
        },
      },
      {
        icon: "glass",
        name: "See through",
        key: "X",
        isOn: () => this.isGlass,
        run: () => {
          this.isGlass = !this.isGlass;
          this.globe.setGlass(this.isGlass);
          this.invalidate();
          refresh();
        },
      },
    ];
  }

  private colorLit(): void {
    const accent = new THREE.Color().setStyle(
      getComputedStyle(document.documentElement).getPropertyValue("--accent").trim(),
      THREE.LinearSRGBColorSpace,
    );
    const white = new THREE.Color(1, 1, 1);
    for (const lines of this.litLines) lines.setColor(accent);
    for (const dots of this.litDots) dots.setColors([accent], white);
  }

  private lookFrom(direction: THREE.Vector3): void {
    const distance = this.camera.position.length() || this.fittingDistance();
    this.camera.position.copy(direction).setLength(distance);
    this.controls.update();
    this.invalidate();
  }

  private fittingDistance(): number {
    const { top, right, bottom, left } = this.insets;
    const free = Math.max(120, Math.min(innerWidth - left - right, innerHeight - top - bottom));
    const halfAngle = Math.atan((Math.tan(THREE.MathUtils.degToRad(fieldOfView / 2)) * 0.95 * free) / innerHeight);
    return 1 / Math.sin(halfAngle);
  }

  private invalidate(): void {
    if (this.isScheduled) return;
    this.isScheduled = true;
    requestAnimationFrame(() => {
      this.isScheduled = false;
      const now = performance.now();
      this.controls.update(Math.min(0.5, (now - this.lastFrame) / 1000));
      this.lastFrame = now;
      this.draw();
      if (this.controls.autoRotate) this.invalidate();
    });
  }

  private draw(): void {
    const { top, right, bottom, left } = this.insets;
    this.camera.setViewOffset(innerWidth, innerHeight, (right - left) / 2, (bottom - top) / 2, innerWidth, innerHeight);
    this.camera.near = Math.max(0.05, this.camera.position.length() - 1.2);
    this.camera.far = this.camera.position.length() + 1.2;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    this.renderer.render(this.scene, this.camera);
    this.labels.draw(this.areLabelsShown ? this.anchors() : []);
  }

  private anchors(): ScreenAnchor[] {
    const { cells } = this.data;
    const { points, paths } = this.geometry;
    const seen: ScreenAnchor[] = [];
    const add = (cell: Cell, to: ArrayLike<number> | undefined, room: number | undefined) => {
      if (!cell.label || !to) return;
      const p = new THREE.Vector3(to[0], to[1], to[2]);
      // On the near side, and not where it is seen very slantwise.
      if (p.dot(this.camera.position) < 1 + 0.22 * p.distanceTo(this.camera.position)) return;
      p.project(this.camera);
      seen.push({ text: cell.label, x: ((p.x + 1) / 2) * innerWidth, y: ((1 - p.y) / 2) * innerHeight, room });
    };
    cells.point.forEach((cell, i) => add(cell, points.subarray(3 * i, 3 * i + 3), undefined));
    cells.face.forEach((cell, i) => add(cell, this.middles[i], 60));
    cells.edge.forEach((cell, i) => add(cell, paths[i].subarray(3 * Math.floor(paths[i].length / 6)), undefined));
    return seen;
  }

  private resize(): void {
    const ratio = Math.min(2.5, devicePixelRatio);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(Math.max(1, innerWidth), Math.max(1, innerHeight));
    this.camera.aspect = innerWidth / Math.max(1, innerHeight);
    for (const dots of [this.dots, ...this.litDots]) dots.setPixelRatio(ratio);
    this.invalidate();
  }
}

/** Index of the lines that draw edges of a style. */
function weightOf(style: number): number {
  return style === 1 ? 1 : style >= 2 ? 2 : 0;
}

function zUpToYUp(v: THREE.Vector3): THREE.Vector3 {
  return new THREE.Vector3(v.y, v.z, v.x);
}

function yUpToZUp(v: THREE.Vector3): THREE.Vector3 {
  return new THREE.Vector3(v.z, v.x, v.y);
}
