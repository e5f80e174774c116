// Made-up classes, as a batch writes them into the page.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { scratch, source } from './harness.mjs';

/** A class of so many students. */
export function classData(size) {
  const worth = [['edge_flip', 40], ['edge_split', 60]];
  const exercise = ([name, most], verdict, got) => ({
    name, verdict, points: got, max_points: most, extra_points: 0, max_extra_points: 0,
  });
  const rows = Array.from({ length: size }, (_, i) => {
    const exercises = worth.map((w, k) =>
      (i + k) % 3 === 0 ? exercise(w, 'passed', w[1]) : exercise(w, 'failed', (7 * i) % w[1]));
    return {
      key: `k${i}`, people: [{ id: `u${i}`, name: i === 5 ? '<b>Five</b>' : `Student ${i}`, email: '' }],
      submitted_at: '', late: i % 9 === 0, status: 'graded', reason: '',
      points: exercises[0].points + exercises[1].points, extra_points: 0, exercises,
    };
  });
  return {
    kind: 'class',
    class: { assignment: 'A class', max_points: 100, max_extra_points: 0,
      exercises: worth.map((w) => exercise(w, '', 0)), rows, left_out: [] },
    links: { k5: 'results/k5/report.html' },
    similar: { page: 'similar.html', percent: 50, groups: [['k3', 'k4']] },
  };
}

/** The file of its page. */
export function classFile(data) {
  const html = join(scratch, `class_${data.class.rows.length}.html`);
  const page = readFileSync(join(source, 'viewer/dist/viewer.html'), 'utf8');
  writeFileSync(html, page.replace('{"kind":"empty"}', () => JSON.stringify(data).replaceAll('<', '\\u003c')));
  return html;
}
