// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import { cross, dot, sub, triangleCorners } from "./part_geometry";
import type { PartMesh } from "./part_mesh";
import type { SceneData, Vec3 } from "./scene_data";
import type { Stage } from "./stage";

export interface Hit {
  mesh: PartMesh;
  triangle: number;
  face: number;
  isBack: boolean; ///< seen from inside, as through a cut
}

/** A place on a solid: its true coordinates, and where it is drawn (relative, moved by the explosion). */
export interface Place {
  point: Vec3;
  drawn: THREE.Vector3;
  isVertex: boolean;
}

/** Finds what is seen at a pixel by drawing triangle numbers instead of colours, in a window of a few pixels. */
export class Picker {
  private readonly scene = new THREE.Scene();
  private readonly targets = new Map<number, THREE.WebGLRenderTarget>();

  constructor(
    private readonly stage: Stage,
    private readonly meshes: PartMesh[],
    private readonly data: SceneData,
  ) {
    for (const mesh of meshes) if (mesh.part.triangleCount > 0) this.scene.add(mesh.pickMesh);
  }

  hitAt(x: number, y: number): Hit | undefined {
    const ids = this.read(x, y, 0);
    return this.hit(ids, 0);
  }

  /** Where the line of sight meets the triangle, or its corner nearby. */
  placeAt(x: number, y: number, reach: number): Place | undefined {
    const ids = this.read(x, y, reach);
    const vertex = this.nearestVertex(ids, x, y, reach);
    if (vertex) return vertex;
    const hit = this.hit(ids, 4 * (reach * (2 * reach + 1) + reach));
    return hit && this.placeOn(hit, x, y);
  }

  placeOn(hit: Hit, x: number, y: number): Place | undefined {
    const cut = this.stage.shared.cut.value;
    const ray = this.stage.ray(x, y);
    const isOnCut = hit.isBack && cut.lengthSq() > 0 && (cut.x !== 0 || cut.y !== 0 || cut.z !== 0);
    const drawn = isOnCut ? meetPlane(ray, cut) : this.meetTriangle(ray, hit);
    if (!drawn) return undefined;
    const offset = hit.mesh.offset(hit.mesh.part.piece(hit.face));
    const { center, scale } = this.data;
    const point = [0, 1, 2].map((k) => center[k] + scale * (drawn.getComponent(k) - offset[k])) as Vec3;
    return { point, drawn, isVertex: false };
  }

  private hit(ids: Uint8Array, at: number): Hit | undefined {
    const id = ids[at] + 256 * (ids[at + 1] + 256 * (ids[at + 2] + 256 * (ids[at + 3] & 127)));
    if (id === 0) return undefined;
    const mesh = this.meshes.find((m) => id - 1 < m.firstTriangle + m.part.triangleCount);
    if (!mesh) return undefined;
    const triangle = id - 1 - mesh.firstTriangle;
    return { mesh, triangle, face: mesh.part.triangleFaces[triangle], isBack: ids[at + 3] >= 128 };
  }

  private read(x: number, y: number, reach: number): Uint8Array {
    const { renderer } = this.stage;
    const size = 2 * reach + 1;
    const target = this.targets.get(size) ?? new THREE.WebGLRenderTarget(size, size, { samples: 0 });
    this.targets.set(size, target);
    this.stage.updateCameras({ left: Math.floor(x) - reach, top: Math.floor(y) - reach, size });
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(this.scene, this.stage.camera);
    renderer.setRenderTarget(null);
    this.stage.updateCameras();
    const ids = new Uint8Array(4 * size * size);
    renderer.readRenderTargetPixels(target, 0, 0, size, size, ids);
    return ids;
  }

  private nearestVertex(ids: Uint8Array, x: number, y: number, reach: number): Place | undefined {
    let best: Place | undefined;
    let least = reach * reach;
    const seen = new Set<string>();
    for (let at = 0; at < ids.length; at += 4) {
      const hit = this.hit(ids, at);
      const key = hit && `${hit.mesh.index} ${hit.triangle}`;
      if (!hit || !key || hit.isBack || seen.has(key)) continue;
      seen.add(key);
      for (const point of triangleCorners(hit.mesh.part, hit.triangle)) {
        const drawn = this.drawn(point, hit);
        const seenAt = this.stage.project(drawn);
        if (!seenAt || this.isCutAway(drawn)) continue;
        const distance = (seenAt.x - x) ** 2 + (seenAt.y - y) ** 2;
        if (distance < least) [least, best] = [distance, { point, drawn, isVertex: true }];
      }
    }
    return best;
  }

  private isCutAway(p: THREE.Vector3): boolean {
    const cut = this.stage.shared.cut.value;
    return cut.x * p.x + cut.y * p.y + cut.z * p.z > cut.w + 1e-6;
  }

  private drawn(point: Vec3, hit: Hit): THREE.Vector3 {
    const { center, scale } = this.data;
    const offset = hit.mesh.offset(hit.mesh.part.piece(hit.face));
    return new THREE.Vector3(...point.map((value, k) => (value - center[k]) / scale + offset[k]));
  }

  private meetTriangle(ray: THREE.Ray, hit: Hit): THREE.Vector3 | undefined {
    const [a, b, c] = triangleCorners(hit.mesh.part, hit.triangle).map((p) => this.drawn(p, hit).toArray() as Vec3);
    const normal = cross(sub(b, a), sub(c, a));
    const slope = dot(normal, ray.direction.toArray() as Vec3);
    if (slope === 0) return new THREE.Vector3(...a);
    const t = dot(normal, sub(a, ray.origin.toArray() as Vec3)) / slope;
    return ray.at(t, new THREE.Vector3());
  }
}

function meetPlane(ray: THREE.Ray, cut: THREE.Vector4): THREE.Vector3 | undefined {
  const normal = new THREE.Vector3(cut.x, cut.y, cut.z);
  const slope = normal.dot(ray.direction);
  if (slope === 0) return undefined;
  return ray.at((cut.w - normal.dot(ray.origin)) / slope, new THREE.Vector3());
}
