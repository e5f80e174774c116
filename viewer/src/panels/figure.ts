// The grader's picture of a case, taken apart: its panels stand beside each other where there is
// room and below each other where there is none, and its list is text that wraps.

import { el, picture, type Child } from '../dom';

const SVG = 'http://www.w3.org/2000/svg';
/** The smallest letters of a picture, and how small they may become on the screen. */
const SMALLEST = 13;
const READABLE = 13;

function panelAlone(panel: Element): HTMLElement {
  const box = panel.getAttribute('data-box')!;
  const width = Number(box.split(' ')[2]);
  const alone = document.createElementNS(SVG, 'svg');
  alone.setAttribute('viewBox', box);
  alone.setAttribute('role', 'img');
  alone.setAttribute('aria-label', panel.querySelector('text')?.textContent ?? '');
  panel.removeAttribute('transform');
  alone.append(panel);
  const holder = el('div', { class: 'figure-panel', tabindex: 0, role: 'group',
    'aria-label': panel.getAttribute('class')!.replace('panel ', '') });
  holder.append(alone);
  holder.style.setProperty('--least', `${Math.ceil((width * READABLE) / SMALLEST)}px`);
  holder.style.setProperty('--most', `${1.15 * width}px`);
  return holder;
}

function listLine(line: Element): HTMLElement {
  const text = line.getAttribute('data-text') ?? '';
  const number = line.getAttribute('data-number');
  const name = line.getAttribute('class') ?? '';
  return el('p', { class: `figure-${name}` }, number !== null && el('span', { class: 'figure-number' }, number),
    number === null ? text : el('span', { class: 'mono' }, text));
}

export function figure(svgText: string): Child {
  const svg = picture(svgText);
  if (!svg) return null;
  const panels = [...svg.querySelectorAll('.panel[data-box]')];
  if (panels.length === 0) return el('figure', { class: 'figure whole' }, svg);
  const description = svg.querySelector('desc')?.textContent ?? '';
  return el('figure', { class: 'figure', 'aria-label': description },
    el('div', { class: 'figure-panels' }, ...panels.map(panelAlone)),
    el('figcaption', { class: 'figure-list' }, ...[...svg.querySelectorAll('.list > g')].map(listLine)));
}
