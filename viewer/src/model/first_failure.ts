// Which failure a report begins with.

import type { Case, Exercise, Group, Report } from './types';

export interface FirstFailure {
  exercise: Exercise;
  case: Case;
}

const counts = (c: Case): boolean => c.verdict !== 'passed' && c.verdict !== 'not judged' && c.excused !== true;

/** Whether nothing was lost but, perhaps, extra credit. */
export function isPassed(exercise: Exercise): boolean {
  return exercise.verdict === 'passed' && exercise.points >= exercise.max_points;
}

/** The first case of an exercise that lost points that are required; those with a finding first. */
function firstOf(exercise: Exercise): Case | undefined {
  const inOrder = (group: Group): Case[] => exercise.cases.filter((c) => c.group === group.name && counts(c));
  const lost = exercise.groups.filter((g) => !g.extra_credit).flatMap(inOrder);
  return lost.find((c) => c.findings.length > 0) ?? lost[0];
}

/** Of all exercises; null if nothing that is required was lost, or no case tells what. */
export function firstFailure(report: Report): FirstFailure | null {
  const found = report.exercises.filter((e) => !isPassed(e)).flatMap((exercise): FirstFailure[] => {
    const first = firstOf(exercise);
    return first ? [{ exercise, case: first }] : [];
  });
  return found.find((f) => f.case.findings.length > 0)
    ?? found.find((f) => !['not compiled', 'not implemented'].includes(f.case.verdict))
    ?? found[0] ?? null;
}
