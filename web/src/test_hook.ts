// SPDX-License-Identifier: Apache-2.0
import type { Measurement } from "./measure";
import type { SectionAxis } from "./section";
import { describeFace, type FaceInfo } from "./ui/card";
import type { Viewer } from "./viewer";

/** What tests, and people at the console, may ask of the page. Pixels are those of the window. */
export interface TestHook {
  ready: boolean;
  error?: string;
  triangleCount?: number;
  faceCount?: number;
  pick?(x: number, y: number): FaceInfo | undefined;
  picked?(): FaceInfo | undefined;
  measured?(): Measurement | undefined;
  /** Position from 0 to 1 along the axis; undefined switches the section off. */
  setSection?(axis: SectionAxis, position: number | undefined): void;
  setExplosion?(amount: number): void;
  /** Milliseconds per frame, each waited for. */
  frameTime?(frames: number): number;
  pickTime?(picks: number): number;
}

declare global {
  interface Window {
    quoinView: TestHook;
  }
}

export function makeTestHook(viewer: Viewer): TestHook {
  const { stage, data } = viewer;
  const timed = (times: number, action: () => void) => {
    const start = performance.now();
    for (let i = 0; i < times; ++i) action();
    return (performance.now() - start) / times;
  };
  const gl = stage.renderer.getContext();
  return {
    ready: true,
    triangleCount: viewer.triangleCount,
    faceCount: data.parts.reduce((sum, part) => sum + part.faceCount, 0),
    pick: (x, y) => {
      const hit = viewer.picker.hitAt(x, y);
      return hit && describeFace(data, hit);
    },
    picked: () => viewer.picked && describeFace(data, viewer.picked),
    measured: () => viewer.measure.result,
    setSection: (axis, position) => {
      viewer.section.isOn = position !== undefined;
      viewer.section.axis = axis;
      if (position !== undefined) viewer.section.position = position;
      viewer.applySection();
    },
    setExplosion: (amount) => viewer.setExplosion(amount),
    frameTime: (frames) =>
      timed(frames, () => {
        stage.draw();
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits for the frame
      }),
    pickTime: (picks) => timed(picks, () => viewer.picker.hitAt(stage.host.clientWidth / 2, stage.host.clientHeight / 2)),
  };
}
