// What a step changed, what it should have changed, and which rules are broken.

import { button, el, type Child } from '../dom';
import { parseElement, type Element } from '../model/mesh';
import type { PointerChange, RuleBreak, WrongPointer } from '../model/types';

export type Choose = (element: Element) => void;

/** A name as a button that selects it, if it names an element. */
export function elementLink(text: string, choose: Choose): Child {
  const element = parseElement(text);
  if (!element) return el('span', { class: 'mono' }, text);
  return button(text, () => choose(element), { class: 'link mono' });
}

export function brokenRules(breaks: RuleBreak[], choose: Choose): HTMLElement {
  if (breaks.length === 0) {
    return el('p', { class: 'good' }, '✓ No mesh rule is broken.');
  }
  return el(
    'ul',
    { class: 'breaks' },
    ...breaks.map((b) => {
      const element = parseElement(b.look_at) ?? parseElement(b.element);
      const text = [el('strong', { class: 'mono' }, b.rule), ` ${b.element}: `,
        `${b.actual}; expected ${b.expected}`];
      return el(
        'li',
        { title: b.meaning },
        element
          ? el('button', { type: 'button', class: 'break', on: { click: () => choose(element) } }, ...text)
          : el('span', { class: 'break' }, ...text),
      );
    }),
  );
}

export function changedPointers(changes: PointerChange[], wrong: WrongPointer[], choose: Choose): HTMLElement {
  const bad = new Map(wrong.map((w) => [w.pointer, w]));
  if (changes.length === 0) return el('p', { class: 'quiet' }, 'This step changed no pointer.');
  const rows = changes.map((c) => {
    const name = `${c.element}.${c.pointer}`;
    const fault = bad.get(name);
    return el(
      'tr',
      { class: fault ? 'wrong' : undefined },
      el('th', { scope: 'row' }, elementLink(c.element, choose), `.${c.pointer}`),
      el('td', {}, c.before === '' ? el('span', { class: 'tag' }, 'new') : elementLink(c.before, choose)),
      el('td', { class: 'arrow', 'aria-hidden': 'true' }, '→'),
      el('td', {}, c.after === '' ? 'deleted' : elementLink(c.after, choose)),
      el('td', {}, fault ? ['✗ must be ', fault.expected].join('') : ''),
    );
  });
  return el(
    'table',
    { class: 'changes' },
    el('thead', { class: 'unseen' }, el('tr', {},
      ...['pointer', 'old', '', 'new', 'remark'].map((t) => el('th', { scope: 'col' }, t)))),
    el('tbody', {}, ...rows),
  );
}

/** Pointers that the code did not write at all. */
export function notChanged(wrong: WrongPointer[], choose: Choose): HTMLElement | null {
  const rows = wrong.filter((w) => !w.was_set);
  if (rows.length === 0) return null;
  return el(
    'table',
    { class: 'changes' },
    el('tbody', {}, ...rows.map((w) =>
      el('tr', { class: 'wrong' },
        el('th', { scope: 'row' }, elementLink(w.pointer, choose)),
        el('td', {}, 'still ', elementLink(w.actual, choose)),
        el('td', { class: 'arrow', 'aria-hidden': 'true' }, ''),
        el('td', {}, 'must be ', el('strong', {}, elementLink(w.expected, choose))),
      ))),
  );
}
