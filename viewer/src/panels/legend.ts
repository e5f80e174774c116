// The legend of a mesh that is coloured by its distance from OpenSubdiv's answer.

import { button, el } from '../dom';
import { parseElement, type Element } from '../model/mesh';
import type { Deviation } from '../model/types';

/** @param choose  turns the camera to a vertex; null: on paper */
export function legend(deviation: Deviation, choose: ((element: Element) => void) | null): HTMLElement {
  const bar = el('div', { class: 'legend-bar', 'aria-hidden': 'true' });
  bar.style.backgroundImage = `linear-gradient(to right, ${deviation.scale.join(', ')})`;
  const worst = deviation.worst.map(({ vertex, text }) => {
    const element = parseElement(vertex);
    return el('li', {}, choose && element ? button(text, () => choose(element), { class: 'link' }) : text);
  });
  return el('section', { class: 'legend', 'aria-label': 'Distance from OpenSubdiv' },
    el('h3', {}, 'Distance from OpenSubdiv'),
    bar,
    el('div', { class: 'legend-ends' }, el('span', {}, deviation.ends[0]), el('span', {}, deviation.ends[1])),
    el('p', {}, deviation.text),
    choose && worst.length > 0 && el('ol', { class: 'worst' }, ...worst));
}
