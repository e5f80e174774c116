// The live viewer: every step is done by the student's own functions, on the server.

import { button, el, keyButton, replace, type Child } from '../dom';
import { saveFile, toGlb, toObj } from '../model/export';
import { Mesh, parseElement } from '../model/mesh';
import { findingBlock } from '../panels/case_card';
import type { MeshState } from '../panels/marks';
import { KeyHelp, VIEW_KEYS, type KeyRow } from '../panels/key_help';
import { MeshPanel } from '../panels/mesh_panel';
import { toneOf, verdictTag } from '../panels/verdict';
import { keyName, meaning, pickedName, picksText, titleOf, wordOfKey, wordsOf, type Verb, type Word } from '../model/verbs';
import type { LiveState } from './answers';
import type { Connection } from './connection';
import { LevelsCover } from './levels';
import { buildTag, compilerBanner, output, verdict } from './shell';

function keyRows(words: Word[], hasNormals: boolean): KeyRow[] {
  return [
    ...words.map((word): KeyRow => [[...word.keys].map(keyName).join(' or '),
      word.verbs[0]!.picked === 0 ? `${word.word}, the whole mesh` : `${word.word} ${picksText(word)}`]),
    ['Z, Y', 'undo, redo'],
    ...(hasNormals ? [['Q', 'smooth shading by your normals, and the normals'] as KeyRow] : []),
    ['V', 'all levels of subdivision beside each other'],
    ['D', 'the distance from OpenSubdiv'],
    ...VIEW_KEYS,
  ];
}

const PLAIN = { broken: [], changes: [], wrong: [] };

function statesOf(live: LiveState): { states: MeshState[]; current: number } {
  const { state, stopped } = live;
  const wrong = state.told?.findings.find((f) => f.pointers)?.pointers?.wrong ?? [];
  const states: MeshState[] = [];
  if (state.before) states.push({ label: 'Before', mesh: new Mesh(state.before), ...PLAIN });
  const current = states.length;
  states.push({
    label: state.step ? `After ${state.step}` : 'Start',
    mesh: new Mesh(state.mesh),
    broken: state.broken,
    changes: state.changes ?? [],
    wrong,
    deviation: state.deviation,
  });
  if (state.expected) states.push({ label: 'Expected', mesh: new Mesh(state.expected), ...PLAIN });
  if (stopped?.mesh) {
    states.push({ label: 'When it stopped', mesh: new Mesh(stopped.mesh),
      broken: stopped.broken ?? [], changes: stopped.changes ?? [], wrong: [] });
  }
  return { states, current };
}

export class LivePage {
  private readonly panel = new MeshPanel(true);
  private readonly timeline = el('ol', { class: 'timeline', 'aria-label': 'Steps' });
  private readonly title = el('h1', { class: 'live-title' });
  private readonly build = el('span', { class: 'build', role: 'status' });
  private readonly banner = el('div', { class: 'banner', role: 'alert' });
  private readonly told = el('div', { class: 'told' });
  private readonly levels = new LevelsCover();
  private readonly help = new KeyHelp(VIEW_KEYS);
  private readonly wordButtons = el('span', { class: 'verbs' });
  private readonly smoothButton = keyButton('Smooth', 'Q', () => void this.toggleSmooth(),
    { 'data-option': 'smooth', 'aria-pressed': 'false', hidden: true });
  private words: Word[] = [];
  /** The first of two elements, while the second is looked for. */
  private first: { verb: Verb; index: number } | null = null;
  private live: LiveState | null = null;
  private normals: Float32Array | null = null;
  private busy = false;
  private lookAgain = false;

  constructor(app: HTMLElement, private readonly connection: Connection) {
    this.panel.top.append(el('h2', { class: 'unseen' }, 'The step'), this.banner, this.told);
    this.panel.cover.append(this.levels.element);
    this.panel.coverEye = () => this.levels.eye;
    this.panel.coverPicture = () => this.levels.snapshot();
    this.panel.onOption = () => void this.drawLevels();
    const head = el('header', { class: 'live-head' },
      el('strong', { class: 'brand' }, 'Meshgrade'), this.title, this.build, this.fileTools());
    replace(app, el('main', { class: 'live' }, head, this.panel.element,
      el('footer', { class: 'live-foot' }, this.timeline, this.actions())));
    document.addEventListener('keydown', (event) => this.onKey(event));
    connection.listen(() => void this.reload(), (alive) => this.showAlive(alive));
    this.panel.say('Loading …');
    void this.run(connection.look, true);
  }

  private fileTools(): HTMLElement {
    const input = el('input', { type: 'file', class: 'unseen', tabindex: -1, 'aria-hidden': 'true',
      accept: '.obj,.off,.ply,.stl,.gltf,.glb,.dae' });
    input.addEventListener('change', () => {
      const file = input.files?.[0];
      if (!file) return;
      void file.arrayBuffer().then((buffer) =>
        this.run(() => this.connection.open(file.name, new Uint8Array(buffer)), true));
      input.value = '';
    });
    const stem = (): string => (this.live?.mesh ?? 'mesh').replace(/\.[^.]*$/, '');
    const mesh = (): Mesh | undefined => this.panel.state()?.mesh;
    return el('span', { class: 'file-tools' },
      button('Open mesh', () => input.click()), input,
      button('Save OBJ', () => mesh() && saveFile(`${stem()}.obj`, toObj(mesh()!))),
      button('Save GLB', () => mesh() && saveFile(`${stem()}.glb`, toGlb(mesh()!))),
      this.help.button);
  }

  private actions(): HTMLElement {
    return el('div', { class: 'actions', role: 'group', 'aria-label': 'Operations' },
      this.wordButtons,
      keyButton('Undo', 'Z', () => this.move(-1)),
      keyButton('Redo', 'Y', () => this.move(1)),
      keyButton('Next', 'N', () => this.panel.follow('next')),
      keyButton('Twin', 'T', () => this.panel.follow('twin')),
      keyButton('Half-edge', 'H', () => this.panel.follow('halfedge')),
      this.smoothButton, this.levelsButton());
  }

  /** The buttons of the student's functions, as the grader lists them. */
  private takeVerbs(live: LiveState): void {
    if (this.words.length > 0) return;
    this.words = wordsOf(live.verbs);
    replace(this.wordButtons, ...this.words.map((word) =>
      keyButton(titleOf(word.word), word.keys === '' ? '' : keyName(word.keys.charAt(0)), () => this.step(word))));
    this.smoothButton.hidden = !live.has_normals;
    this.help.setRows(keyRows(this.words, live.has_normals));
  }

  private levelsButton(): HTMLButtonElement {
    const made = keyButton('Levels', 'V', () => void this.toggleLevels());
    made.dataset['option'] = 'levels';
    made.setAttribute('aria-pressed', 'false');
    return made;
  }

  /** Level 0, 1, ... beside each other, or the one mesh again. */
  private async toggleLevels(): Promise<void> {
    if (!this.panel.view) return;
    const on = !this.levels.shown;
    document.querySelector('[data-option=levels]')?.setAttribute('aria-pressed', String(on));
    document.body.classList.toggle('with-levels', on);
    if (!on) {
      this.levels.hide();
      return;
    }
    this.levels.element.hidden = false;
    await this.drawLevels();
  }

  private async drawLevels(): Promise<void> {
    const { view } = this.panel;
    if (!this.levels.shown || !view) return;
    try {
      const levels = await this.connection.levels();
      if (this.levels.shown) this.levels.show(levels, view.options);
    } catch (error) {
      this.panel.say((error as Error).message);
    }
  }

  private onKey(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    if (target.closest('input, select, textarea')) return;
    const acts: Record<string, () => void> = {
      z: () => this.move(event.shiftKey ? 1 : -1),
      y: () => this.move(1),
      v: () => void this.toggleLevels(),
      ...(this.live?.has_normals ? { q: () => void this.toggleSmooth() } : {}),
    };
    const word = event.key.length === 1 ? wordOfKey(this.words, event.key, event.shiftKey) : undefined;
    const act = word ? () => this.step(word) : acts[event.key.toLowerCase()];
    if (event.key === 'Escape') this.forgetFirst();
    if (act) act();
    else if (!this.panel.handleKey(event.key, event.shiftKey, target === document.body)) return;
    event.preventDefault();
  }

  private step(word: Word): void {
    const mesh = this.live ? this.panel.states[this.panelCurrent()]?.mesh : undefined;
    const { verb, picked } = meaning(word, this.panel.selected, mesh);
    if (!verb) {
      this.panel.say(`Select ${picksText(word)} to ${word.word}.`);
      return;
    }
    const picks = picked === null ? [] : [picked];
    if (verb.picked > 1 && picked !== null) {
      if (this.first?.verb !== verb) {
        this.keepFirst(verb, picked);
        return;
      }
      picks.unshift(this.first.index);
    }
    this.forgetFirst();
    void this.run(() => this.connection.step(verb, picks), false);
  }

  private keepFirst(verb: Verb, index: number): void {
    this.first = { verb, index };
    this.panel.view?.markPicked(parseElement(pickedName(verb, index)));
    const again = verb.keys === '' ? titleOf(verb.word) : keyName(verb.keys.charAt(0));
    this.panel.say(`${titleOf(verb.word)} ${pickedName(verb, index)} with which ${verb.picks}? Select it, and ${again} again.`);
  }

  private forgetFirst(): void {
    if (!this.first) return;
    this.first = null;
    this.panel.view?.markPicked(null);
  }

  private panelCurrent(): number {
    return this.live?.state.before ? 1 : 0;
  }

  private move(by: number): void {
    const position = (this.live?.position ?? 0) + by;
    if (!this.live || position < 0 || position >= this.live.timeline.length) return;
    void this.run(() => this.connection.goTo(position), false);
  }

  private async reload(): Promise<void> {
    const before = this.live?.build.number;
    await this.run(this.connection.look, false);
    if (this.live && this.live.build.number !== before) this.panel.say('Built again, and every step repeated.');
  }

  /** One request at a time: a key that is held down must not pile them up. */
  private async run(ask: () => Promise<LiveState>, fit: boolean): Promise<void> {
    if (this.busy) {
      this.lookAgain ||= ask === this.connection.look;
      return;
    }
    this.busy = true;
    document.body.classList.add('busy');
    try {
      this.live = await ask();
      this.panel.say('');
      this.normals = null;
      this.draw(fit);
      if (this.panel.view?.options.smooth) await this.fetchNormals();
    } catch (error) {
      this.panel.say((error as Error).message);
    } finally {
      this.busy = false;
      document.body.classList.remove('busy');
    }
    if (!this.lookAgain) return;
    this.lookAgain = false;
    await this.reload();
  }

  private async toggleSmooth(): Promise<void> {
    const view = this.panel.view;
    if (!view) return;
    const on = !view.options.smooth;
    view.options.smooth = on;
    view.options.normalLines = on;
    document.querySelector('[data-option=smooth]')?.setAttribute('aria-pressed', String(on));
    if (on && !this.normals) await this.fetchNormals();
    else view.setNormals(this.normals);
  }

  private async fetchNormals(): Promise<void> {
    try {
      const { normals, error } = await this.connection.normals();
      this.normals = normals ? Float32Array.from(normals.map((x) => x ?? NaN)) : null;
      if (error) this.panel.say(`Your normals: ${error}`);
    } catch (error) {
      this.panel.say((error as Error).message);
    }
    this.panel.view?.setNormals(this.normals);
  }

  private showAlive(alive: boolean): void {
    document.body.classList.toggle('cut-off', !alive);
    if (!alive) this.build.textContent = '✗ meshgrade view does not answer';
    else if (this.live) this.drawBuild(this.live);
  }

  private draw(fit: boolean): void {
    const live = this.live!;
    document.title = `${live.mesh} – Meshgrade`;
    const level = live.timeline.slice(0, live.position + 1).filter((s) => s.subdivides).length;
    this.takeVerbs(live);
    this.forgetFirst();
    replace(this.title, el('span', {}, live.mesh),
      el('span', { class: 'quiet' }, ` with ${live.submission}${level > 0 ? `, level ${level}` : ''}`));
    this.drawBuild(live);
    this.drawTimeline(live);
    replace(this.banner, ...stoppedBanner(live));
    replace(this.told, ...readersNotes(live), ...this.verdictOf(live));
    const { states, current } = statesOf(live);
    this.panel.show(states, current, fit);
    void this.drawLevels();
  }

  private verdictOf(live: LiveState): Child[] {
    const { told, step } = live.state;
    return told && !live.stopped ? verdict(told, step ?? '') : [];
  }

  private drawBuild(live: LiveState): void {
    replace(this.build, buildTag(live.build));
  }

  private drawTimeline(live: LiveState): void {
    const items = live.timeline.map((entry, i) => {
      const { sign, tone } = toneOf(entry.verdict);
      const item = button(entry.label, () => void this.run(() => this.connection.goTo(i), false), {
        class: i > live.position ? 'undone' : undefined,
        'aria-current': i === live.position ? 'step' : undefined,
      });
      if (entry.verdict !== '') item.prepend(el('span', { class: `sign ${tone}`, title: entry.verdict }, `${sign} `));
      return el('li', {}, item);
    });
    if (live.stopped) {
      items.push(el('li', {}, el('span', { class: 'stopped-step' }, `✗ ${live.stopped.step}`)));
    }
    replace(this.timeline, ...items);
    this.timeline.querySelector('[aria-current]')?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  }
}

/** Beside the mesh as it was read; a step has other things to tell. */
function readersNotes(live: LiveState): Child[] {
  if (live.position > 0 || live.stopped || live.notes.length === 0) return [];
  return [el('div', { class: 'readers-notes' },
    el('h3', {}, `About ${live.mesh}`), ...live.notes.map((note) => el('p', {}, note)))];
}

function stoppedBanner(live: LiveState): Child[] {
  const parts: Child[] = [compilerBanner(live.build)];
  const { stopped } = live;
  if (stopped) {
    parts.push(el('div', { class: 'stop' },
      el('h3', {}, verdictTag(stopped.told.verdict), ` ${stopped.step}`),
      stopped.told.note !== '' && el('p', {}, stopped.told.note),
      ...stopped.told.findings.map((f) => findingBlock(f, true)),
      output(stopped.told.output),
      el('p', { class: 'quiet' }, 'The mesh before is kept. Save a change, and this step is tried again.')));
  }
  return parts;
}
