// What the program that serves this page answers.

import type { MeshJson } from '../model/mesh';
import type { Verb } from '../model/verbs';
import type { Case, PointerChange, RuleBreak, StateJson } from '../model/types';

export interface LiveState {
  submission: string;
  mesh: string;
  /** What there was to say when the mesh was read. */
  notes: string[];
  verbs: Verb[];
  /** Whether the student's vertex normals can be asked for. */
  has_normals: boolean;
  build: { number: number; compiled: boolean; files: { name: string; compiled: boolean; messages: string }[] };
  timeline: { label: string; verdict: string; subdivides?: boolean }[];
  position: number;
  state: StateJson;
  stopped?: {
    step: string;
    told: Case;
    mesh?: MeshJson;
    broken?: RuleBreak[];
    changes?: PointerChange[];
  };
}

export type Point2 = [number, number];
export type Point3 = [number, number, number];

export interface CurveAnswer {
  levels: Point2[][];
  curve: (Point2 | null)[];
  exact: Point2[];
  told: Case;
}

export interface PatchAnswer {
  grid: (Point3 | null)[];
  told: Case;
}

/** Curves on a surface, by the student's evaluate, as far as it came. */
export interface IsocurvesAnswer {
  along_u: (Point3 | null)[];
  along_v: (Point3 | null)[];
}
