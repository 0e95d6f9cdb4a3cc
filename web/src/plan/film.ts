// SPDX-License-Identifier: Apache-2.0
import type { Plan, PlanMove } from "./plan_data";

export interface Step {
  state: number;
  move: number;
}

/** Where a part is at some time, and how much of it is still part of the story. */
export interface Pose {
  offset: [number, number, number];
  presence: number; ///< 1, and towards 0 once it is on its own
  isMoving: boolean;
}

/** The steps one after the other: at time k, k of them are done. Alternatives may be chosen at any state. */
export class Film {
  steps: Step[] = [];
  /** States at which it ends though their parts are still together. */
  ends: number[] = [];
  private readonly choice = new Map<number, number>();

  constructor(
    private readonly plan: Plan,
    /** How far parts move away. */
    private readonly distance: number,
  ) {
    this.follow();
  }

  get length(): number {
    return this.steps.length;
  }

  moveOf(step: Step): PlanMove {
    return this.plan.states[step.state].moves[step.move];
  }

  choose(state: number, move: number): void {
    this.choice.set(state, move);
    this.follow();
  }

  poses(time: number): Pose[] {
    const poses: Pose[] = this.plan.parts.map(() => ({ offset: [0, 0, 0], presence: 1, isMoving: false }));
    this.steps.forEach((step, k) => {
      const done = Math.min(1, Math.max(0, time - k));
      if (done === 0) return;
      const { moving, direction } = this.moveOf(step);
      const eased = done * done * (3 - 2 * done);
      for (const part of moving) {
        for (const axis of [0, 1, 2]) poses[part].offset[axis] += eased * this.distance * direction[axis];
        poses[part].isMoving = done < 1;
        if (moving.length === 1) poses[part].presence = Math.min(1, 2 - 2 * eased + 0.12);
      }
    });
    return poses;
  }

  /** As disassemble() in quoin/assembly goes: the rest before what was moved. */
  private follow(): void {
    this.steps = [];
    this.ends = [];
    const pending = this.plan.states.length > 0 ? [0] : [];
    while (pending.length > 0) {
      const state = pending.pop() as number;
      const { moves } = this.plan.states[state];
      if (moves.length === 0) {
        this.ends.push(state);
        continue;
      }
      const move = this.choice.get(state) ?? 0;
      this.steps.push({ state, move });
      const { moved, rest } = moves[move];
      if (moved !== null) pending.push(moved);
      if (rest !== null) pending.push(rest);
    }
  }
}
