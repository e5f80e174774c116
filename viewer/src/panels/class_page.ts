// A class: how the points are spread, what goes wrong in each exercise, and a table of all.

import { button, el, replace, type Child } from '../dom';
import type { ClassPageData, ClassResults, ClassRow, SimilarHandIns } from '../model/types';
import { points, toneOf } from './verdict';

const name = (row: ClassRow): string => row.people.map((p) => p.name || p.id).join(', ') || row.key;
/** Those whom the statistics count, here as in summary.txt. */
const isGraded = (row: ClassRow): boolean => row.status === 'graded';
const hasPoints = (row: ClassRow): boolean => row.status === 'graded' || row.status === 'ungradable';

function middle(sorted: number[]): number {
  if (sorted.length === 0) return 0;
  const half = sorted.length / 2;
  return (sorted[Math.floor(half - 0.5)]! + sorted[Math.floor(half)]!) / 2;
}

const SVG = 'http://www.w3.org/2000/svg';
function svg(tag: string, attributes: Record<string, string | number>, text = ''): SVGElement {
  const element = document.createElementNS(SVG, tag);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  element.textContent = text;
  return element;
}

/** How many got how many points: in ten steps, and in a bar of its own all points. */
export function histogram(values: number[], most: number): number[] {
  const bins = new Array<number>(11).fill(0);
  for (const value of values) {
    const share = most > 0 ? value / most : 1;
    // Sums of thirds of points may miss the last bit.
    bins[share >= 1 - 1e-9 ? 10 : Math.max(0, Math.min(9, Math.floor(share * 10 + 1e-9)))]! += 1;
  }
  return bins;
}

/** Points of those who are graded, ascending. Who handed in nothing that can be graded has no part in it. */
export function gradedPoints(results: ClassResults): number[] {
  return results.rows.filter(isGraded).map((row) => row.points).sort((a, b) => a - b);
}

function distribution(results: ClassResults): HTMLElement {
  const values = gradedPoints(results);
  const bins = histogram(values, results.max_points);
  const highest = Math.max(1, ...bins);
  const picture = svg('svg', { viewBox: '0 -10 550 166', role: 'img', class: 'histogram' });
  const words = bins.map((n, i) => i === 10 ? `${n} with all points` : `${n} from ${i * 10} to below ${i * 10 + 10} per cent`);
  picture.append(svg('title', {}, `Distribution of points: ${words.join('; ')}`));
  bins.forEach((n, i) => {
    const height = (n / highest) * 105;
    picture.append(
      svg('rect', { x: 50 * i + 3, y: 125 - height, width: 44, height, rx: 3, class: i === 10 ? 'bin full' : 'bin' }),
      svg('text', { x: 50 * i + 25, y: 118 - height, class: 'bin-count' }, n > 0 ? String(n) : ''),
      svg('text', { x: 50 * i + 25, y: 147, class: 'bin-name' }, i === 10 ? 'all' : points((i * results.max_points) / 10)));
  });
  const fact = (title: string, value: string): HTMLElement =>
    el('div', {}, el('dt', {}, title), el('dd', {}, value));
  return el('section', { class: 'exercise' },
    el('h2', {}, 'Points'),
    el('dl', { class: 'class-facts' },
      fact('graded', `${values.length} of ${results.rows.length}`),
      fact('median', points(middle(values))),
      fact('mean', points(values.reduce((a, b) => a + b, 0) / Math.max(1, values.length))),
      fact('best', points(values.at(-1) ?? 0)),
      fact('of', points(results.max_points))),
    picture);
}

function exerciseFailures(results: ClassResults): HTMLElement {
  const graded = results.rows.filter(isGraded);
  const rows = results.exercises.map((exercise, i) => {
    const verdicts = new Map<string, number>();
    let sum = 0;
    for (const row of graded) {
      const mine = row.exercises[i];
      if (!mine) continue;
      sum += mine.points;
      verdicts.set(mine.verdict, (verdicts.get(mine.verdict) ?? 0) + 1);
    }
    const sorted = [...verdicts].sort((a, b) => b[1] - a[1]);
    const bar = el('span', { class: 'stack-bar', 'aria-hidden': 'true' });
    for (const tone of ['good', 'bad', 'none'] as const) {
      const share = sorted.filter(([v]) => toneOf(v).tone === tone).reduce((n, [, k]) => n + k, 0);
      const part = el('span', { class: `part ${tone}` });
      part.style.flexGrow = String(share);
      bar.append(part);
    }
    return el('tr', {},
      el('th', { scope: 'row' }, exercise.title || exercise.name),
      el('td', {}, bar, el('span', { class: 'quiet' }, sorted.map(([v, n]) => `${n} ${v}`).join(', '))),
      el('td', { class: 'number' }, `${points(sum / Math.max(1, graded.length))} / ${points(exercise.max_points)}`));
  });
  return el('section', { class: 'exercise' },
    el('h2', {}, 'Exercises'),
    el('table', { class: 'groups' },
      el('thead', {}, el('tr', {}, el('th', { scope: 'col' }, 'Exercise'), el('th', { scope: 'col' }, 'Verdicts'),
        el('th', { scope: 'col', class: 'number' }, 'Mean points'))),
      el('tbody', {}, ...rows)));
}

interface Column {
  title: string;
  number: boolean;
  value: (row: ClassRow) => string | number;
  cell: (row: ClassRow) => Child;
}

function columnsOf(results: ClassResults, links: Record<string, string>): Column[] {
  const link = (row: ClassRow): Child =>
    links[row.key] ? el('a', { href: links[row.key] }, name(row)) : name(row);
  return [
    { title: 'Name', number: false, value: (row) => name(row).toLowerCase(), cell: link },
    { title: 'Status', number: false, value: (row) => row.status,
      cell: (row) => el('span', {}, row.status, row.late && el('span', { class: 'tag' }, 'late'),
        row.reason && el('span', { class: 'quiet' }, ` ${row.reason}`),
        row.late_note && el('span', { class: 'quiet' }, ` ${row.late_note}`)) },
    { title: 'Points', number: true, value: (row) => (hasPoints(row) ? row.points : -1),
      cell: (row) => (hasPoints(row) ? el('span', {}, el('strong', {}, points(row.points)),
        row.late_deduction > 0 && el('span', { class: 'quiet' },
          ` = ${points(row.points + row.late_deduction)} − ${points(row.late_deduction)}`)) : '–') },
    { title: 'Extra', number: true, value: (row) => row.extra_points,
      cell: (row) => (hasPoints(row) ? points(row.extra_points) : '–') },
    ...results.exercises.map((exercise, i): Column => ({
      title: exercise.title || exercise.name,
      number: true,
      value: (row) => (row.exercises[i]?.verdict ? row.exercises[i]!.points : -1),
      cell: (row) => {
        const mine = row.exercises[i];
        if (!mine?.verdict) return '–';
        const { sign, tone } = toneOf(mine.verdict);
        return el('span', { title: mine.verdict }, points(mine.points), el('span', { class: `sign ${tone}` }, ` ${sign}`),
          el('span', { class: 'unseen' }, ` ${mine.verdict}`));
      },
    })),
  ];
}

class ClassTable {
  readonly element: HTMLElement;
  private readonly body = el('tbody', {});
  private readonly heads: HTMLElement[];
  private readonly shown = el('p', { class: 'quiet', role: 'status' });
  private readonly rows: { row: ClassRow; element: HTMLElement }[];
  private sorted = 0;
  private down = false;
  private wanted = '';

  constructor(results: ClassResults, private readonly columns: Column[]) {
    this.rows = results.rows.map((row) => ({ row, element: el('tr', {}, ...columns.map((column, i) =>
      i === 0 ? el('th', { scope: 'row' }, column.cell(row)) : el('td', { class: column.number ? 'number' : undefined }, column.cell(row)))) }));
    this.heads = columns.map((column, i) =>
      el('th', { scope: 'col', class: column.number ? 'number' : undefined }, button(column.title, () => this.sortBy(i), { class: 'sort' })));
    const field = el('input', { type: 'search', placeholder: 'Name or status', 'aria-label': 'Show only rows with' });
    field.addEventListener('input', () => {
      this.wanted = field.value.toLowerCase();
      this.draw();
    });
    this.element = el('section', { class: 'exercise' },
      el('div', { class: 'exercise-head' }, el('h2', {}, 'Everybody'), field, this.shown),
      el('div', { class: 'table-scroll', tabindex: 0, role: 'region', 'aria-label': 'Everybody' },
        el('table', { class: 'class-table' }, el('thead', {}, el('tr', {}, ...this.heads)), this.body)));
    this.draw();
  }

  private sortBy(column: number): void {
    this.down = this.sorted === column ? !this.down : this.columns[column]!.number;
    this.sorted = column;
    this.draw();
  }

  private draw(): void {
    const { value } = this.columns[this.sorted]!;
    const kept = this.rows.filter(({ row }) => `${name(row)} ${row.status}`.toLowerCase().includes(this.wanted));
    kept.sort((a, b) => {
      const [x, y] = [value(a.row), value(b.row)];
      const order = typeof x === 'number' ? x - (y as number) : x.localeCompare(y as string);
      return this.down ? -order : order;
    });
    this.body.replaceChildren(...kept.map(({ element }) => element));
    this.heads.forEach((head, i) => {
      if (i === this.sorted) head.setAttribute('aria-sort', this.down ? 'descending' : 'ascending');
      else head.removeAttribute('aria-sort');
    });
    this.shown.textContent = `${kept.length} of ${this.rows.length}`;
  }
}

function similarHandIns(results: ClassResults, similar: SimilarHandIns | undefined): Child {
  if (!similar) return null;
  const names = new Map(results.rows.map((row) => [row.key, name(row)]));
  const { groups, percent } = similar;
  return el('section', { class: 'exercise similar' },
    el('div', { class: 'exercise-head' }, el('h2', {}, 'Alike'), el('a', { href: similar.page }, 'All pairs, side by side')),
    el('p', {}, groups.length === 0
      ? `No two hand-ins share ${percent} % of their code.`
      : `Hand-ins that share ${percent} % of their code or more. Look at the code before you say anything.`),
    groups.length > 0 && el('ul', {}, ...groups.map((group) => el('li', {}, group.map((key) => names.get(key) ?? key).join(', ')))));
}

export function showClass(app: HTMLElement, { class: results, links, similar }: ClassPageData): void {
  document.title = `${results.assignment}: the class`;
  const table = new ClassTable(results, columnsOf(results, links));
  replace(app, el('main', { class: 'report class-page' },
    el('header', { class: 'report-head' },
      el('div', {}, el('p', { class: 'eyebrow' }, `${results.rows.length} hand-ins`), el('h1', {}, results.assignment))),
    distribution(results),
    exerciseFailures(results),
    similarHandIns(results, similar),
    table.element,
    results.left_out.length > 0 && el('section', { class: 'exercise' }, el('h2', {}, 'Left out'),
      el('ul', {}, ...results.left_out.map((o) => el('li', {}, el('span', { class: 'mono' }, o.what), `: ${o.why}`))))));
}
