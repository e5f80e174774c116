import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from './load.mjs';

const { gradedPoints } = await load('panels/class_page.ts');

test('statistics count those who are graded, as summary.txt does', () => {
  const row = (status, points) => ({ key: status, people: [], status, points, exercises: [] });
  const rows = [row('graded', 7), row('ungradable', 0), row('grader error', 0), row('graded', 3), row('not graded yet', 0)];
  assert.deepEqual(gradedPoints({ rows }), [3, 7]);
});
