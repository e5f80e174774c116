// A mesh to look at: the 3D view, the states of one step, and lists of what is wrong with it.

import { button, el, keyButton, replace } from '../dom';
import { savePicture } from '../model/export';
import { kindName, nameOf, parseElement, type Element } from '../model/mesh';
import type { Deviation } from '../model/types';
import { MeshView, type ViewOptions } from '../scene/mesh_view';
import type { Viewpoint } from '../scene/viewpoint';
import { hasWebGL } from '../scene/webgl';
import { showInspector } from './inspector';
import { legend } from './legend';
import { arcsOf, marksOf, type MeshState } from './marks';
import { brokenRules, changedPointers, elementLink, notChanged } from './pointer_lists';

const OPTION_TEXT: [keyof ViewOptions, string, string][] = [
  ['ids', 'Ids', 'I'],
  ['arrows', 'Arrows', 'A'],
  ['wireframe', 'Wireframe', 'W'],
  ['compare', 'Distance from OpenSubdiv', 'D'],
];

export class MeshPanel {
  readonly element = el('section', { class: 'mesh-panel', 'aria-label': 'Mesh' });
  readonly view: MeshView | null;
  selected: Element | null = null;
  onSelect: (element: Element | null) => void = () => {};

  /** For what the page has to say about the step. */
  readonly top = el('div', { class: 'top' });
  /** For what the page shows in place of the mesh. */
  readonly cover = el('div', { class: 'cover' });
  /** Where the cover is seen from; null while it is not there. */
  coverEye: () => Viewpoint | null = () => null;
  coverPicture: () => HTMLCanvasElement | null = () => null;
  onOption: () => void = () => {};
  states: MeshState[] = [];

  private readonly stage = el('div', { class: 'stage' });
  private readonly tabs = el('div', { class: 'tabs', role: 'group', 'aria-label': 'State' });
  private readonly tools = el('div', { class: 'tools', role: 'group', 'aria-label': 'View' });
  private readonly inspector = el('div', { class: 'inspector' });
  private readonly lists = el('div', { class: 'lists' });
  private readonly status = el('p', { class: 'status', role: 'status' });
  private current = 0;

  /** @param alone  the page shows nothing else, and subdivides */
  constructor(private readonly alone: boolean) {
    const holder = el('div', { class: 'stage-holder' }, this.tabs, this.stage, this.cover, this.tools);
    const side = el('div', { class: 'side' }, this.status, this.top, this.finder(), this.inspector, this.lists);
    this.element.append(holder, side);
    this.view = this.makeView();
    this.makeTools();
    this.element.addEventListener('keydown', (event) => this.onKey(event));
  }

  private makeView(): MeshView | null {
    if (!hasWebGL()) {
      replace(this.stage, el('p', { class: 'quiet no-webgl' },
        'This browser has no WebGL, so there is no 3D view. Everything else is here.'));
      return null;
    }
    const view = new MeshView(this.stage);
    view.onPick = (element) => this.select(element);
    if (!this.alone) view.eye.zoomOnlyWithFocus();
    return view;
  }

  private makeTools(): void {
    if (!this.view) return;
    const view = this.view;
    for (const [name, text, key] of OPTION_TEXT) {
      if (name === 'compare' && !this.alone) continue;
      const toggle = button(text, () => this.toggle(name), {
        class: 'toggle', 'data-option': name, 'aria-pressed': String(view.options[name]), 'aria-keyshortcuts': key,
      });
      toggle.append(' ', el('kbd', {}, key));
      this.tools.append(toggle);
    }
    const reset = button('Reset', () => this.eye()?.reset(), { 'aria-keyshortcuts': 'Space' });
    reset.append(' ', el('kbd', {}, 'Space'));
    this.tools.append(reset, keyButton('Save picture', 'P', () => this.savePicture()));
  }

  private savePicture(): void {
    const canvas = this.coverPicture() ?? this.view?.snapshot();
    if (canvas) savePicture('mesh.png', canvas);
  }

  private finder(): HTMLElement {
    const field = el('input', {
      type: 'text', class: 'mono', size: 8, placeholder: 'h12', 'aria-label': 'Go to element', autocomplete: 'off',
    });
    const go = (event: Event): void => {
      event.preventDefault();
      const element = parseElement(field.value);
      const there = element && this.state()?.mesh.isLive(element);
      this.status.textContent = there ? '' : `There is no element ${field.value} here.`;
      if (there) this.choose(element);
    };
    return el('form', { class: 'finder', on: { submit: go } }, el('label', {}, 'Go to ', field));
  }

  say(text: string): void {
    this.status.textContent = text;
  }

  toggle(name: keyof ViewOptions): void {
    if (!this.view || (name === 'compare' && !this.alone)) return;
    this.view.setOption(name, !this.view.options[name]);
    if (name === 'compare') this.drawState(false);
    this.tools
      .querySelector(`[data-option=${name}]`)
      ?.setAttribute('aria-pressed', String(this.view.options[name]));
    this.onOption();
  }

  state(): MeshState | undefined {
    return this.states[this.current];
  }

  /** Shows states of one mesh, of which `current` first. */
  show(states: MeshState[], current: number, fit = true): void {
    this.states = states;
    this.current = current;
    this.drawTabs();
    this.drawState(fit);
  }

  private drawTabs(): void {
    this.tabs.hidden = this.states.length < 2;
    replace(
      this.tabs,
      ...this.states.map((state, i) =>
        button(state.label, () => this.goTo(i), { 'aria-pressed': String(i === this.current) })),
    );
  }

  private goTo(i: number): void {
    if (!this.states[i]) return;
    this.current = i;
    [...this.tabs.children].forEach((tab, k) => tab.setAttribute('aria-pressed', String(k === i)));
    this.drawState(false);
  }

  private drawState(fit: boolean): void {
    const state = this.state();
    if (!state) return;
    const deviation = this.deviation();
    this.view?.colorVertices(deviation?.colors ?? null);
    this.view?.show(state.mesh, marksOf(state, deviation), fit);
    if (this.selected && !state.mesh.isLive(this.selected)) this.selected = null;
    this.describe(state);
    this.drawSide(state);
  }

  /** How far the mesh is from OpenSubdiv's, if that is asked for and known of this state. */
  private deviation(): Deviation | null {
    return (this.view?.options.compare && this.state()?.deviation) || null;
  }

  /** In words, for those who do not see the picture. */
  private describe(state: MeshState): void {
    const open = state.mesh.faces().filter((walk) => !walk.closed).map((walk) => nameOf(walk.face));
    const parts = [`Mesh ${state.label}: ${state.mesh.counts()}.`];
    if (state.broken.length > 0) parts.push(`${state.broken.length} broken rules.`);
    if (open.length > 0) parts.push(`Open faces: ${open.slice(0, 8).join(', ')}.`);
    if (state.wrong.length > 0) parts.push(`Wrong pointers: ${state.wrong.slice(0, 8).map((w) => w.pointer).join(', ')}.`);
    const deviation = this.deviation();
    if (deviation) parts.push(`Coloured by the distance from OpenSubdiv. ${deviation.text}`);
    this.view?.canvas.setAttribute('aria-label', parts.join(' '));
  }

  private drawSide(state: MeshState): void {
    const choose = (element: Element): void => this.choose(element);
    const wrong = new Set(state.wrong.map((w) => w.pointer));
    for (const arc of arcsOf(state)) wrong.add(`${nameOf(arc.element)}.${arc.pointer}`);
    showInspector(this.inspector, state.mesh, this.selected, wrong, choose);
    const stale = notChanged(state.wrong, choose);
    const setWrong = state.wrong.filter((w) => w.was_set);
    const deviation = this.deviation();
    replace(
      this.lists,
      deviation && legend(deviation, choose),
      !deviation && this.view?.options.compare && el('p', { class: 'note' },
        'Nothing to compare here: subdivide; the mesh must be joined as it must be.'),
      el('h3', {}, 'Mesh rules'),
      brokenRules(state.broken, choose),
      stale && el('h3', {}, 'Not changed, but must be'),
      stale,
      setWrong.length > 0 && el('h3', {}, 'Set, but wrong'),
      setWrong.length > 0 && el('ul', { class: 'plain' }, ...setWrong.map((w) => el('li', { class: 'wrong-line' },
        elementLink(w.pointer, choose), ' is ', elementLink(w.actual, choose), ', must be ', el('strong', {}, elementLink(w.expected, choose))))),
      state.changes.length > 0 && el('details', { open: state.changes.length <= 24 },
        el('summary', {}, `Changed by this step (${state.changes.length})`),
        changedPointers(state.changes, state.wrong, choose)),
    );
  }

  select(element: Element | null): void {
    this.selected = element;
    this.view?.select(element);
    const state = this.state();
    if (!state) return;
    this.drawSide(state);
    this.status.textContent = element ? `${kindName(element.kind)} ${nameOf(element)} selected` : '';
    this.onSelect(element);
  }

  /** Selects an element and turns the camera to it. */
  choose(element: Element): void {
    if (!this.state()?.mesh.isLive(element)) return;
    this.select(element);
    this.view?.turnTo(element);
  }

  /** Follows a pointer of the selected element. */
  follow(name: string): void {
    const mesh = this.state()?.mesh;
    if (!mesh) return;
    const from = this.selected ?? { kind: 'h', index: 0 };
    const pointer = mesh.pointers(from).find((p) => p.name === name);
    if (pointer?.target) this.choose(pointer.target);
    else if (!this.selected) this.choose(from as Element);
    else if (pointer) this.status.textContent = `${nameOf(from as Element)}.${name} is ${pointer.text}`;
  }

  private onKey(event: KeyboardEvent): void {
    const field = event.target as HTMLElement;
    if (field.closest('input, select, textarea') || event.ctrlKey || event.metaKey || event.altKey) return;
    if (this.handleKey(event.key, event.shiftKey, field instanceof HTMLCanvasElement)) event.preventDefault();
  }

  /** @returns whether the key means something here */
  handleKey(key: string, shift: boolean, onCanvas: boolean): boolean {
    const plain: Record<string, () => void> = {
      n: () => this.follow('next'),
      t: () => this.follow('twin'),
      h: () => this.follow('halfedge'),
      i: () => this.toggle('ids'),
      w: () => this.toggle('wireframe'),
      a: () => this.toggle('arrows'),
      p: () => this.savePicture(),
      d: () => this.toggle('compare'),
      '[': () => this.goTo(this.current - 1),
      ']': () => this.goTo(this.current + 1),
      Escape: () => this.select(null),
    };
    const act = plain[key.length === 1 ? key.toLowerCase() : key];
    if (act) {
      act();
      return true;
    }
    return onCanvas && this.moveCamera(key, shift);
  }

  /** Of what is shown: the mesh, or the cover. */
  private eye(): Viewpoint | null {
    return this.coverEye() ?? this.view?.eye ?? null;
  }

  private moveCamera(key: string, shift: boolean): boolean {
    const eye = this.eye();
    if (!eye) return false;
    const step: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
    };
    const direction = step[key];
    if (direction) {
      const [x, y] = direction;
      if (shift) eye.pan(0.05 * x, 0.05 * y);
      else eye.orbit(0.12 * x, 0.12 * y);
    } else if (key === '+' || key === '=') eye.zoom(0.88);
    else if (key === '-') eye.zoom(1.14);
    else if (key === ' ' || key === 'Home') eye.reset();
    else return false;
    return true;
  }
}
