// A grading report: the points, the first failure, a line for each exercise, and a section with
// its cases for each that did not pass.

import { el, replace, type Child } from '../dom';
import { firstFailure, isPassed, type FirstFailure } from '../model/first_failure';
import type { Case, Exercise, Group, Report } from '../model/types';
import { caseCard, openCase } from './case_card';
import { points, toneOf, verdictTag } from './verdict';

function bar(value: number, most: number, label: string): HTMLElement {
  const share = most > 0 ? Math.max(0, Math.min(1, value / most)) : 0;
  const fill = el('span', { class: 'bar-fill' });
  fill.style.width = `${100 * share}%`;
  const words = label === '' ? { 'aria-hidden': 'true' } : { role: 'img', 'aria-label': label };
  return el('span', { class: 'bar', ...words }, fill);
}

function score(value: number, most: number): HTMLElement {
  return el('span', { class: 'score' }, el('strong', {}, points(value)), ` / ${points(most)}`);
}

function head(report: Report): HTMLElement {
  const extra = report.max_extra_points > 0
    ? el('span', { class: 'quiet' }, `extra credit ${points(report.extra_points)} / ${points(report.max_extra_points)}`)
    : null;
  return el(
    'header',
    { class: 'report-head' },
    el('div', {},
      el('p', { class: 'eyebrow' }, report.assignment),
      el('h1', {}, report.submission)),
    el('div', { class: 'total' },
      score(report.points, report.max_points),
      bar(report.points, report.max_points, `${points(report.points)} of ${points(report.max_points)} points`),
      extra,
      report.points_not_judged
        ? el('span', { class: 'quiet' }, `${points(report.points_not_judged)} points were not judged: a person has to decide`)
        : null),
  );
}

function rowContent(exercise: Exercise): Child[] {
  const { sign, tone } = toneOf(exercise.verdict);
  const extra = exercise.max_extra_points > 0
    ? `, extra credit ${points(exercise.extra_points)} / ${points(exercise.max_extra_points)}` : '';
  return [
    el('span', { class: `sign ${tone}`, 'aria-hidden': 'true' }, sign),
    el('span', { class: 'overview-name' }, exercise.title,
      el('span', { class: 'quiet verdict-text' }, exercise.verdict, extra)),
    bar(exercise.points, exercise.max_points, ''),
    score(exercise.points, exercise.max_points)];
}

/** What passed is one line, to be opened; what did not, a link to its section. */
function overview(report: Report): HTMLElement {
  return el(
    'nav',
    { class: 'overview', 'aria-label': 'Exercises' },
    ...report.exercises.map((exercise) => isPassed(exercise)
      ? el('details', { class: 'overview-passed', id: `exercise-${exercise.name}` },
        el('summary', { class: 'overview-row' }, ...rowContent(exercise)),
        el('div', { class: 'exercise-body' }, ...exerciseBody(exercise, null)))
      : el('a', { href: `#exercise-${exercise.name}`, class: 'overview-row' }, ...rowContent(exercise))),
  );
}

function groupTable(exercise: Exercise): HTMLElement {
  return el('table', { class: 'groups' },
    el('thead', {}, el('tr', {}, ...['What is tried', 'Passed', 'Points'].map((t, i) =>
      el('th', { scope: 'col', class: i > 0 ? 'number' : undefined }, t)))),
    el('tbody', {}, ...exercise.groups.map((g) =>
      el('tr', {},
        el('th', { scope: 'row' }, g.title === '' ? g.name : g.title, g.extra_credit && el('span', { class: 'tag' }, 'extra credit'),
          g.why !== undefined && el('span', { class: 'quiet' }, ` ${g.why}`)),
        el('td', { class: 'number' }, `${g.passed} of ${g.judged}`),
        el('td', { class: 'number' }, score(g.points, g.max_points))))));
}

function passedList(cases: Case[]): Child {
  if (cases.length === 0) return null;
  return el('details', { class: 'passed' },
    el('summary', {}, `✓ ${cases.length} ${cases.length === 1 ? 'case' : 'cases'} passed`),
    el('ul', {}, ...cases.map((c) => el('li', {}, c.title, ' ', el('span', { class: 'mono quiet' }, c.id)))));
}

const FIRST_CASES = 3;

/** The first cases of a group that went wrong, and the others folded away. */
function failedCases(group: Group, cases: Case[]): Child[] {
  const cards = cases.map(caseCard);
  const [first, others] = [cards.slice(0, FIRST_CASES), cards.slice(FIRST_CASES)];
  const title = group.title === '' ? group.name : group.title;
  if (others.length === 0) return first;
  return [...first, el('details', { class: 'others' },
    el('summary', {}, `${others.length} more like these: ${title}`), ...others)];
}

/** Where no case has more to tell than why it did not run, each reason is said once. */
function untriedCases(cases: Case[]): Child[] {
  const reasons = [...new Set(cases.map((c) => c.note).filter((note) => note !== ''))];
  return [...reasons.slice(0, FIRST_CASES).map((reason) => el('p', { class: 'note' }, reason)),
    el('details', { class: 'others' },
      el('summary', {}, `${cases.length} ${cases.length === 1 ? 'case' : 'cases'} of it`), ...cases.map(caseCard))];
}

/** @param above  the case that the page begins with: it is not told twice */
function exerciseBody(exercise: Exercise, above: Case | null): Child[] {
  const isPlain = (c: Case): boolean => c.verdict === 'passed' && c.output === '';
  const failed = exercise.cases.filter((c) => !isPlain(c));
  const told = failed.some((c) => c.findings.length > 0);
  const isUntried = failed.length > 0 && !told && failed.every((c) => c.output === '');
  const rest = failed.filter((c) => c !== above);
  const cards = isUntried ? (rest.length > 0 ? untriedCases(rest) : []) : exercise.groups.flatMap((group) =>
    failedCases(group, rest.filter((c) => c.group === group.name)));
  return [
    ...exercise.notes.map((note) => el('p', { class: 'note' }, note)),
    exercise.stand_ins.length > 0 && el('p', { class: 'note' },
      `Judged with a right solution of ${exercise.stand_ins.join(', ')} in place of yours.`),
    groupTable(exercise),
    above && el('p', {}, 'At the top of this page: ',
      el('a', { class: 'mono', href: `#case-${above.id}` }, above.id)),
    ...cards,
    passedList(exercise.cases.filter(isPlain)),
  ];
}

function exerciseSection(exercise: Exercise, first: FirstFailure | null): HTMLElement {
  const above = first?.exercise === exercise ? first.case : null;
  const section = el(
    'section',
    { class: 'exercise', id: `exercise-${exercise.name}` },
    el('div', { class: 'exercise-head' },
      el('h2', {}, exercise.title), verdictTag(exercise.verdict), score(exercise.points, exercise.max_points)),
    ...exerciseBody(exercise, above),
  );
  const told = !above && exercise.cases.find((c) => c.verdict !== 'passed' && c.findings.length > 0);
  const card = told && section.querySelector<HTMLDetailsElement>(`#${CSS.escape(`case-${told.id}`)}`);
  if (card) openCase(card);
  return section;
}

/** What to look at first, before anything else. */
function firstSection(first: FirstFailure | null): Child {
  if (!first || first.case.findings.length === 0 && first.case.note === '') return null;
  const card = caseCard(first.case);
  openCase(card);
  card.classList.add('told');
  return el('section', { class: 'exercise first-failure' },
    el('div', { class: 'exercise-head' }, el('h2', {}, 'Look at this first'),
      el('a', { href: `#exercise-${first.exercise.name}` }, first.exercise.title)),
    card);
}

/** What does not compile comes before everything that could be wrong with it. */
function notCompiled(report: Report): Child {
  const broken = report.files.filter((f) => !f.compiled);
  if (broken.length === 0) return null;
  return el('section', { class: 'files' },
    ...broken.map((f) => el('details', { open: true },
      el('summary', {}, el('span', { class: 'mono' }, f.name), ' ', verdictTag('not compiled')),
      el('pre', { tabindex: 0 }, f.messages))));
}

function notes(report: Report): Child {
  if (report.notes.length === 0) return null;
  return el('section', { class: 'files' },
    el('ul', { class: 'notes' }, ...report.notes.map((n) => el('li', {}, n))));
}

export function showReport(app: HTMLElement, report: Report): void {
  document.title = `${report.submission}: ${points(report.points)} of ${points(report.max_points)} points`;
  const first = firstFailure(report);
  replace(
    app,
    el('main', { class: 'report' },
      head(report),
      notCompiled(report),
      firstSection(first),
      overview(report),
      notes(report),
      ...report.exercises.filter((e) => !isPassed(e)).map((e) => exerciseSection(e, first)),
      el('footer', { class: 'quiet' }, `Meshgrade, random cases from seed ${report.seed}. Repeat a case: `,
        el('code', {}, 'meshgrade replay CASE'), '.')),
  );
  // On paper the first of everything that failed is open; the style leaves out the tables of all
  // but the very first.
  window.addEventListener('beforeprint', () => {
    for (const card of app.querySelectorAll<HTMLDetailsElement>('.exercise > details.case')) openCase(card);
    for (const more of app.querySelectorAll<HTMLDetailsElement>('.told details')) more.open = true;
  });
}
