// One case of a report: its findings, pointer tables, picture, and the mesh in 3D.

import { button, el, type Child } from '../dom';
import { Mesh } from '../model/mesh';
import type { Case, Finding, PointerDiff, PointerTable, Scene } from '../model/types';
import { figure } from './figure';
import type { MeshState } from './marks';
import { MeshPanel } from './mesh_panel';
import { verdictTag } from './verdict';

function fact(name: string, value: string, tone = ''): Child[] {
  return value === '' ? [] : [el('dt', {}, name), el('dd', { class: tone }, value)];
}

function stackList(finding: Finding): Child {
  if (finding.stack.length === 0) return null;
  return el(
    'ol',
    { class: 'stack' },
    ...finding.stack.map((frame) =>
      el('li', {},
        el('span', { class: 'mono' }, frame.function),
        frame.file !== '' && el('span', { class: 'quiet' }, ` ${frame.file}:${frame.line}`),
        frame.code !== '' && el('code', { class: 'line' }, frame.code))),
  );
}

export function findingBlock(finding: Finding, first: boolean): HTMLElement {
  return el(
    'div',
    { class: first ? 'finding first' : 'finding' },
    el('p', { class: 'rule' },
      el('span', { class: 'mono rule-name' }, finding.rule),
      finding.meaning !== '' && el('span', {}, ` ${finding.meaning}`)),
    finding.where !== '' && el('p', { class: 'quiet' }, finding.where),
    el('dl', { class: 'facts' },
      ...fact('at', finding.element, 'mono'),
      ...fact('expected', finding.expected, 'want'),
      ...fact('yours', finding.actual, 'bad-text'),
      ...fact('look at', finding.look_at, 'look')),
    finding.likely.length > 0 && el('div', { class: 'likely' },
      ...finding.likely.map((m, i) => el('p', {}, el('strong', {}, i === 0 ? 'probably ' : 'or '), m.advice))),
    stackList(finding),
  );
}

function pointerTable(table: PointerTable): HTMLElement {
  const cell = (c: PointerTable['rows'][0]['cells'][0]): HTMLElement => {
    if (!c.wrong) {
      const moved = c.before !== c.yours && c.before !== '';
      return el('td', {}, el('span', { class: 'mono' }, c.yours === '' ? '·' : c.yours),
        moved && el('span', { class: 'quiet was' }, `was ${c.before}`));
    }
    return el('td', { class: 'wrong' },
      el('span', { class: 'mono yours' }, '✗ ', c.yours === '' ? 'missing' : c.yours),
      el('span', { class: 'want' }, 'expected ', el('strong', { class: 'mono' }, c.expected)));
  };
  const rows = table.rows.map((row) =>
    el('tr', {},
      el('th', { scope: 'row' }, el('span', { class: 'mono' }, row.element === '' ? '(missing)' : row.element),
        row.role !== '' && el('span', { class: 'quiet role' }, row.role)),
      ...row.cells.map(cell)));
  const wide = table.columns.length > 1;
  return el('div', { class: wide ? 'table-scroll' : 'table-scroll short', tabindex: 0, role: 'region', 'aria-label': table.kind },
    el('table', { class: wide ? 'pointer-table wide' : 'pointer-table' },
      el('caption', {}, table.kind),
      el('thead', {}, el('tr', {}, el('td', {}), ...table.columns.map((c) => el('th', { scope: 'col' }, c)))),
      el('tbody', {}, ...rows)));
}

export function pointerTables(diff: PointerDiff): HTMLElement {
  const wrong = diff.wrong.length;
  return el(
    'details',
    { class: 'tables', open: true },
    el('summary', {}, `All pointers around the edge${wrong > 0 ? ` (${wrong} wrong)` : ''}`),
    el('p', { class: 'quiet' }, diff.corners),
    (diff.missing > 0 || diff.surplus > 0) && el('p', { class: 'bad-text' },
      [diff.missing > 0 && `${diff.missing} elements are missing`,
        diff.surplus > 0 && `${diff.surplus} are created but not needed`].filter(Boolean).join('; ')),
    ...diff.tables.map(pointerTable),
  );
}

export function statesOf(scene: Scene, wrong: PointerDiff['wrong']): MeshState[] {
  const plain = { broken: [], changes: [], wrong: [] };
  return [
    { label: 'Before', mesh: new Mesh(scene.before), ...plain },
    { label: 'Yours', mesh: new Mesh(scene.yours), broken: scene.broken, changes: scene.changes, wrong },
    { label: 'Expected', mesh: new Mesh(scene.expected), ...plain },
  ];
}

/** The one 3D view of the page: browsers allow only a few at a time. */
let openView: { panel: MeshPanel; close: () => void } | null = null;

function sceneBlock(c: Case, scene: Scene): HTMLElement {
  const wrong = c.findings.find((f) => f.pointers)?.pointers?.wrong ?? [];
  const place = el('div', { class: 'scene-place' });
  const open = button('Show this step in 3D', () => {
    openView?.close();
    const panel = new MeshPanel(false);
    place.append(panel.element);
    starter.hidden = true;
    openView = {
      panel,
      close: () => {
        panel.view?.dispose();
        panel.element.remove();
        starter.hidden = false;
        openView = null;
      },
    };
    panel.show(statesOf(scene, wrong), 1);
  }, { class: 'primary show-3d' });
  const starter = el('p', { class: 'starter' }, open,
    el('span', { class: 'quiet' }, ` ${scene.step}: before, yours and expected`));
  place.append(starter);
  return place;
}

function outputBlock(c: Case): Child {
  if (c.output === '') return null;
  const cut = c.output_bytes > c.output.length ? ` (the first ${c.output.length} of ${c.output_bytes} bytes)` : '';
  return el('details', { class: 'output' }, el('summary', {}, `What the code printed${cut}`),
    el('pre', { tabindex: 0 }, c.output));
}

export function caseCard(c: Case): HTMLDetailsElement {
  const pointers = c.findings.find((f) => f.pointers)?.pointers;
  const [first, ...others] = c.findings;
  const card = el(
    'details',
    { class: 'case', id: `case-${c.id}` },
    el('summary', {}, verdictTag(c.verdict), el('span', { class: 'case-title' }, c.title),
      el('span', { class: 'mono quiet case-id' }, c.id)),
  );
  const body = (): HTMLElement => el('div', { class: 'case-body' },
    c.shrunk_from && el('p', { class: 'quiet' }, `Made smaller; it was: ${c.shrunk_from}`),
    c.note !== '' && el('p', { class: 'note' }, c.note),
    first && findingBlock(first, true),
    c.picture ? figure(c.picture) : null,
    c.scene && sceneBlock(c, c.scene),
    pointers && pointerTables(pointers),
    others.length > 0 && el('details', { class: 'more', open: others.length < 3 },
      el('summary', {}, `${others.length} more ${others.length === 1 ? 'finding' : 'findings'} in this case`),
      ...others.map((f) => findingBlock(f, false))),
    outputBlock(c));
  // A report has hundreds of cases: each is filled when it is opened.
  const fill = (): void => {
    if (card.open && card.children.length === 1) card.append(body());
  };
  card.addEventListener('toggle', fill);
  card.addEventListener('fill', fill);
  return card;
}

/** Opens a card at once, without waiting for the browser's event. */
export function openCase(card: HTMLDetailsElement): void {
  card.open = true;
  card.dispatchEvent(new Event('fill'));
}
