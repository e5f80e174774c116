// What the grader puts into the page. docs/report.md explains the report.

import type { MeshJson } from './mesh';

export interface PointerCell {
  before: string;
  yours: string;
  expected: string;
  wrong: boolean;
}
export interface PointerTable {
  kind: string;
  columns: string[];
  rows: { element: string; role: string; cells: PointerCell[] }[];
}
export interface WrongPointer {
  pointer: string;
  role: string;
  expected: string;
  actual: string;
  was_set: boolean;
}
export interface PointerDiff {
  corners: string;
  missing: number;
  surplus: number;
  wrong: WrongPointer[];
  tables: PointerTable[];
}
export interface Finding {
  rule: string;
  meaning: string;
  where: string;
  element: string;
  expected: string;
  actual: string;
  look_at: string;
  likely: { name: string; advice: string }[];
  stack: { function: string; file: string; line: number; code: string }[];
  pointers?: PointerDiff;
}
export interface RuleBreak {
  rule: string;
  meaning: string;
  element: string;
  expected: string;
  actual: string;
  look_at: string;
}
export interface PointerChange {
  element: string;
  pointer: string;
  before: string;
  after: string;
}
export interface Scene {
  step: string;
  edge: number | null;
  before: MeshJson;
  yours: MeshJson;
  expected: MeshJson;
  broken: RuleBreak[];
  changes: PointerChange[];
}
export interface Case {
  id: string;
  group: string;
  title: string;
  shrunk_from?: string;
  verdict: string;
  note: string;
  /** Takes no points: another exercise is to blame. */
  excused?: boolean;
  output: string;
  output_bytes: number;
  findings: Finding[];
  scene?: Scene;
  /** A picture of what is wrong: SVG text. */
  picture?: string;
}
export interface Group {
  name: string;
  title: string;
  extra_credit: boolean;
  points: number;
  max_points: number;
  passed: number;
  judged: number;
  cases: number;
  /** Why it earns nothing, though cases passed. */
  why?: string;
}
export interface Exercise {
  name: string;
  title: string;
  verdict: string;
  points: number;
  max_points: number;
  extra_points: number;
  max_extra_points: number;
  notes: string[];
  stand_ins: string[];
  groups: Group[];
  cases: Case[];
}
export interface Report {
  assignment: string;
  submission: string;
  seed: number;
  points: number;
  max_points: number;
  extra_points: number;
  max_extra_points: number;
  /** Of exercises about which nothing could be said; missing if there are none. */
  points_not_judged?: number;
  notes: string[];
  files: { name: string; compiled: boolean; messages: string }[];
  exercises: Exercise[];
}

/** How far the vertices of a subdivided mesh are from OpenSubdiv's, as the grader tells it. */
export interface Deviation {
  /** Of each vertex by number; null: deleted. */
  colors: (string | null)[];
  scale: string[];
  ends: [string, string];
  worst: { vertex: string; text: string }[];
  text: string;
}

export interface StateJson {
  mesh: MeshJson;
  broken: RuleBreak[];
  step?: string;
  told?: Case;
  before?: MeshJson;
  expected?: MeshJson;
  changes?: PointerChange[];
  deviation?: Deviation;
}

/** What `meshgrade view --screenshot` asks for. */
export interface PictureData {
  kind: 'picture';
  title: string;
  panels: { caption: string; state: StateJson; normals?: (number | null)[] }[];
  request: {
    camera: { azimuth: number; elevation: number; distance: number };
    width: number;
    height: number;
    wireframe: boolean;
    ids: boolean;
    smooth: boolean;
    normals: boolean;
    compare: boolean;
  };
}

/** The file class.json of a batch. */
export interface ClassRow {
  key: string;
  people: { id: string; name: string; email: string }[];
  submitted_at: string;
  late: boolean;
  status: string;
  reason: string;
  points: number;
  extra_points: number;
  exercises: ExercisePoints[];
  late_deduction: number;
  late_note: string;
}
export interface ExercisePoints {
  name: string;
  title?: string;
  verdict: string;
  points: number;
  max_points: number;
  extra_points: number;
  max_extra_points: number;
}
export interface ClassResults {
  assignment: string;
  max_points: number;
  max_extra_points: number;
  exercises: ExercisePoints[];
  rows: ClassRow[];
  left_out: { what: string; why: string }[];
}

/** Keys of hand-ins that share so much of their code, and the page that shows it side by side. */
export interface SimilarHandIns {
  page: string;
  percent: number;
  groups: string[][];
}

export interface ClassPageData {
  kind: 'class';
  class: ClassResults;
  /** The page of each report, by the key of its hand-in. */
  links: Record<string, string>;
  similar?: SimilarHandIns;
}

export type PageData =
  | { kind: 'empty' }
  | { kind: 'report'; report: Report }
  | ClassPageData
  | PictureData
  | { kind: 'live'; token: string; start: LiveStart };

/** What the live page begins with; null: the mesh of the server. */
export type LiveStart =
  | null
  | { kind: 'curve'; name: string; points: [number, number][] }
  | { kind: 'patch'; name: string; nets: [number, number, number][][][] };
