// The pointers of the selected element, each one a step to where it leads.

import { button, el, replace } from '../dom';
import { kindName, nameOf, type Element, type Mesh } from '../model/mesh';

const KEYS: Record<string, string> = { next: 'N', twin: 'T', halfedge: 'H' };

export function showInspector(
  panel: HTMLElement,
  mesh: Mesh,
  selected: Element | null,
  wrong: Set<string>,
  choose: (element: Element) => void,
): void {
  if (!selected) {
    replace(panel, el('p', { class: 'quiet' }, 'Click an element, or name one: h12, v3, e5, f2.'));
    return;
  }
  const rows = mesh.pointers(selected).map((pointer) => {
    const isWrong = wrong.has(`${nameOf(selected)}.${pointer.name}`);
    const target = pointer.target;
    return el(
      'tr',
      { class: isWrong ? 'wrong' : undefined },
      el('th', { scope: 'row' }, pointer.name),
      el(
        'td',
        {},
        target
          ? button(pointer.text, () => choose(target), { class: 'link mono' })
          : el('span', { class: 'mono' }, pointer.text),
        isWrong && el('span', { class: 'tag bad' }, '✗ wrong'),
      ),
      el('td', { class: 'key' }, KEYS[pointer.name] ? el('kbd', {}, KEYS[pointer.name]) : null),
    );
  });
  replace(
    panel,
    el('h3', {}, el('span', { class: 'dot', 'aria-hidden': 'true' }), `${kindName(selected.kind)} ${nameOf(selected)}`),
    el('table', { class: 'pointers' }, el('tbody', {}, ...rows)),
    selected.kind === 'v' && el('p', { class: 'mono quiet' }, positionText(mesh, selected.index)),
  );
}

function positionText(mesh: Mesh, v: number): string {
  const short = (x: number): string => String(Math.round(x * 1e4) / 1e4);
  return `(${mesh.position(v).map(short).join(', ')})`;
}
