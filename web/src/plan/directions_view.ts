// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Cell, CellsData } from "../cells/data";
import { Globe } from "../sphere/globe";
import { Dots, Lines } from "../sphere/marks";
import type { SphereGeometry, SphereHeader } from "../sphere/sphere_data";
import { SpherePicker } from "../sphere/sphere_picker";
import { el } from "../ui/dom";

const fieldOfView = 28;
const strong = 1; // style of edges with solutions
const clickReach = 5; // pixels that the pointer may move during a click

/** The sphere of directions beside the parts: a click picks a cell. */
export class DirectionsView {
  readonly element = el("div", { class: "directions" });
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.PerspectiveCamera(fieldOfView, 1, 0.1, 40);
  private readonly renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
  private readonly controls: OrbitControls;
  private readonly globe: Globe;
  private readonly sets: { edges: number[]; paths: Float32Array[]; lines: Lines }[];
  private readonly marked: { points: number[]; dots: Dots }[];
  private readonly litLines = new Lines(6, [], 1.0028);
  private readonly litDots = new Dots(new Float32Array(0), 17);
  private readonly picker: SpherePicker;
  private pressed: { x: number; y: number } | undefined;
  private isScheduled = false;

  constructor(
    header: SphereHeader,
    private readonly data: CellsData,
    private readonly geometry: SphereGeometry,
    private readonly picked: (cell: Cell | undefined, direction: [number, number, number]) => void,
  ) {
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace; // colours go through as they are given
    this.renderer.domElement.setAttribute("aria-label", "Sphere of directions");
    this.element.append(this.renderer.domElement);
    this.globe = new Globe(geometry.map, data.cells.face.length);
    this.picker = new SpherePicker(data, geometry);
    this.sets = [false, true].map((isStrong) => {
      const edges = header.styles.flatMap((style, i) => ((style === strong) === isStrong ? [i] : []));
      const paths = edges.map((edge) => geometry.paths[edge]);
      return { edges, paths, lines: new Lines(isStrong ? 3.4 : 1.4, paths) };
    });
    // Points with solutions have a colour of their own.
    this.marked = [false, true].map((isSolution) => {
      const points = data.cells.point.flatMap((cell, i) => (cell.color >= 0 === isSolution ? [i] : []));
      const at = new Float32Array(points.flatMap((i) => [...geometry.points.slice(3 * i, 3 * i + 3)]));
      return { points, dots: new Dots(at, isSolution ? 13 : 8) };
    });
    this.scene.add(this.globe.back, this.globe.front);
    const marks = [...this.sets.map(({ lines }) => lines.mesh), this.litLines.mesh, ...this.marked.map(({ dots }) => dots.mesh), this.litDots.mesh];
    marks.forEach((mesh, i) => {
      mesh.renderOrder = 3 + i;
      this.scene.add(mesh);
    });
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(2.6, -3, 2.2);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.enablePan = false;
    this.controls.minDistance = 1.25;
    this.controls.maxDistance = 14;
    this.controls.addEventListener("change", () => this.invalidate());
    new ResizeObserver(() => this.resize()).observe(this.element);
    this.listen();
  }

  /** The cell under a pixel of the window, and where on the sphere that is. */
  hit(x: number, y: number): { cell: Cell | undefined; direction: [number, number, number] } | undefined {
    const bounds = this.renderer.domElement.getBoundingClientRect();
    const at = new THREE.Vector2(((x - bounds.left) / bounds.width) * 2 - 1, 1 - ((y - bounds.top) / bounds.height) * 2);
    if (Math.abs(at.x) > 1 || Math.abs(at.y) > 1) return undefined;
    const caster = new THREE.Raycaster();
    this.camera.updateMatrixWorld();
    caster.setFromCamera(at, this.camera);
    const hit = caster.ray.intersectSphere(new THREE.Sphere(new THREE.Vector3(), 1), new THREE.Vector3());
    if (!hit) return undefined;
    const pixel = (2 * Math.tan(THREE.MathUtils.degToRad(fieldOfView / 2)) * this.camera.position.distanceTo(hit)) / bounds.height;
    return { cell: this.picker.cellAt([hit.x, hit.y, hit.z], pixel), direction: [hit.x, hit.y, hit.z] };
  }

  light(cell: Cell | undefined): void {
    const { points, paths } = this.geometry;
    this.globe.light(-1, cell?.kind === "face" ? cell.index : -1);
    this.litLines.setPaths(cell?.kind === "edge" ? [paths[cell.index]] : [], 1.0028);
    this.litDots.setPositions(cell?.kind === "point" ? points.slice(3 * cell.index, 3 * cell.index + 3) : new Float32Array(0));
    this.colorLit();
    this.invalidate();
  }

  /** Turns until a direction is seen. */
  face(direction: readonly number[]): void {
    const toward = new THREE.Vector3(direction[0], direction[1], direction[2]);
    if (toward.dot(this.camera.position.clone().normalize()) > 0.7) return;
    this.camera.position.copy(toward.add(new THREE.Vector3(0.4, -0.6, 0.35))).setLength(4.5);
    this.controls.update();
    this.invalidate();
  }

  themeChanged(isDark: boolean): void {
    const style = getComputedStyle(document.documentElement);
    const color = (text: string) => new THREE.Color().setStyle(text.trim(), THREE.LinearSRGBColorSpace);
    const shade = isDark ? 1 : 0;
    const paper = color(isDark ? "#2b313a" : "#eef0f3");
    const ink = color(isDark ? "#8b95a3" : "#7c8794");
    const { cells, colors } = this.data;
    const fill = (cell: Cell) => (cell.color < 0 ? paper : color(colors[cell.color][shade]));
    const line = (cell: Cell) => (cell.color < 0 ? ink : color(colors[cell.color][2 + shade]));
    this.globe.setColors([...cells.face.map(fill), paper]);
    this.globe.setTheme(color(style.getPropertyValue("--accent")), color(isDark ? "#0d1014" : "#5d6875"));
    for (const { edges, paths, lines } of this.sets) lines.setColors(paths, edges.map((edge) => line(cells.edge[edge])));
    const halo = color(isDark ? "#1b1f25" : "#fbfbfc");
    for (const { points, dots } of this.marked) dots.setColors(points.map((i) => line(cells.point[i])), halo);
    this.colorLit();
    this.invalidate();
  }

  private colorLit(): void {
    const accent = new THREE.Color().setStyle(
      getComputedStyle(document.documentElement).getPropertyValue("--accent").trim(),
      THREE.LinearSRGBColorSpace,
    );
    this.litLines.setColor(accent);
    this.litDots.setColors([accent], new THREE.Color(1, 1, 1));
  }

  private listen(): void {
    const canvas = this.renderer.domElement;
    canvas.addEventListener("pointerdown", (event) => {
      this.pressed = event.isPrimary && event.button === 0 ? { x: event.clientX, y: event.clientY } : undefined;
    });
    canvas.addEventListener("pointerup", (event) => {
      const from = this.pressed;
      this.pressed = undefined;
      if (!from || Math.hypot(event.clientX - from.x, event.clientY - from.y) > clickReach) return;
      const hit = this.hit(event.clientX, event.clientY);
      this.picked(hit?.cell, hit?.direction ?? [0, 0, 0]);
    });
  }

  private invalidate(): void {
    if (this.isScheduled) return;
    this.isScheduled = true;
    requestAnimationFrame(() => {
      this.isScheduled = false;
      this.controls.update();
      this.renderer.render(this.scene, this.camera);
    });
  }

  private resize(): void {
    const size = Math.max(1, Math.min(this.element.clientWidth, this.element.clientHeight));
    const ratio = Math.min(2, devicePixelRatio);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(size, size);
    for (const dots of [...this.marked.map((set) => set.dots), this.litDots]) dots.setPixelRatio(ratio);
    this.invalidate();
  }
}
