// SPDX-License-Identifier: Apache-2.0
// What quoin/view/plan_page.cc wrote into this page beside the sphere.
import type { CellKind, Fact } from "../cells/data";

export interface PlanPart {
  name: string;
  vertices: number[]; ///< 3 for each
  triangles: number[];
  edges: number[];
}

export interface PlanMove {
  moving: number[];
  direction: [number, number, number];
  exact: string;
  graph: number;
  moved: number | null;
  rest: number | null;
}

export interface PlanState {
  parts: number[];
  moves: PlanMove[];
  sought: boolean;
}

export interface PlanGraph {
  arcs: [moving: number, met: number][];
  movable: number[][];
}

export interface Plan {
  format: string;
  version: number;
  title: string;
  facts: Fact[];
  parts: PlanPart[];
  states: PlanState[];
  steps: [state: number, move: number][];
  interlocked: number[];
  graphs: PlanGraph[];
  cellGraphs: Record<CellKind, number[]>;
}

/** The plan, which leaves the document. Throws an Error that says what is wrong. */
export function readPlan(): Plan {
  const element = document.getElementById("quoin-plan");
  if (!element) throw new Error("This page holds no plan: it is the empty template of the view.");
  let plan: Plan;
  try {
    plan = JSON.parse(element.textContent ?? "") as Plan;
  } catch {
    throw new Error("The plan in this page is incomplete; the file may have been cut short.");
  }
  if (plan.format !== "quoin-plan" || plan.version !== 1) {
    throw new Error("This page holds a plan in a format that it does not know.");
  }
  element.remove();
  return plan;
}
