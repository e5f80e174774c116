// What is marked in the picture of a state.

import { nameOf, parseElement, parsePointer, type Mesh } from '../model/mesh';
import type { Deviation, PointerChange, RuleBreak, WrongPointer } from '../model/types';
import type { Arc, Marks } from '../scene/mesh_view';

/** One state of a mesh, with what the grader says about it. */
export interface MeshState {
  label: string;
  mesh: Mesh;
  broken: RuleBreak[];
  changes: PointerChange[];
  wrong: WrongPointer[];
  deviation?: Deviation;
}

function pointerRemark(w: WrongPointer): string {
  return ` ${w.was_set ? 'is' : 'still'} ${w.actual.split(' ')[0]}`;
}

/** Pointers that break a rule or are wrong, each once. */
export function arcsOf(state: MeshState): Arc[] {
  const arcs = new Map<string, Arc>();
  const note = (where: string, text: string): void => {
    const parsed = parsePointer(where);
    if (!parsed || !state.mesh.isLive(parsed.element)) return;
    const name = `${nameOf(parsed.element)}.${parsed.pointer}`;
    if (arcs.has(name)) return;
    const pointer = state.mesh.pointers(parsed.element).find((p) => p.name === parsed.pointer);
    if (!pointer) return;
    arcs.set(name, { ...parsed, target: pointer.target, text: `${name}${text}` });
  };
  for (const w of state.wrong) note(w.pointer, pointerRemark(w));
  if (arcs.size === 0) for (const b of state.broken) note(b.look_at, '');
  return [...arcs.values()];
}

/** @param deviation  whose worst vertices are marked; null: of none */
export function marksOf(state: MeshState, deviation: Deviation | null): Marks {
  const vertices = (deviation?.worst ?? []).map(({ vertex }) => parseElement(vertex));
  return {
    arcs: arcsOf(state),
    changed: new Set(state.changes.map((c) => c.element)),
    vertices: vertices.flatMap((v) => (v ? [v.index] : [])),
  };
}
