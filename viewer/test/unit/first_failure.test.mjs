// Which failure a report begins with.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from './load.mjs';

const { firstFailure, isPassed } = await load('model/first_failure.ts');

const finding = { rule: 'twin-edge' };
const group = (name, extra_credit = false) => ({ name, extra_credit });
const made = (id, verdict, group, findings = []) => ({ id, verdict, group, findings, note: '' });
const exercise = (name, verdict, cases, points = verdict === 'passed' ? 5 : 0) =>
  ({ name, verdict, points, max_points: 5, groups: [group('basic'), group('extra', true)], cases });
const firstId = (...exercises) => firstFailure({ exercises })?.case.id;

test('The first case with a finding is told, of the first exercise that has one', () => {
  const plain = exercise('a', 'not implemented', [made('a1', 'not implemented', 'basic')]);
  const wrong = exercise('b', 'failed',
    [made('b1', 'crashed', 'basic'), made('b2', 'failed', 'basic', [finding])]);
  assert.equal(firstId(plain, wrong), 'b2');
});

test('Extra credit, what was excused and what is not judged are no failures', () => {
  const extra = exercise('a', 'passed', [made('a1', 'failed', 'extra', [finding])]);
  const excused = exercise('b', 'failed', [{ ...made('b1', 'failed', 'basic', [finding]), excused: true }]);
  const unjudged = exercise('c', 'not judged', [made('c1', 'not judged', 'basic')]);
  assert.equal(firstId(extra, excused, unjudged), undefined);
  assert.ok(isPassed(extra));
});

test('Without findings a crash comes before what is not there yet', () => {
  const empty = exercise('a', 'not implemented', [made('a1', 'not implemented', 'basic')]);
  const crash = exercise('b', 'crashed', [made('b1', 'crashed', 'basic')]);
  assert.equal(firstId(empty, crash), 'b1');
  assert.equal(firstId(empty), 'a1');
});
