// What all live pages share: the head with the state of the build, and the server's news.

import { el, replace, type Child } from '../dom';
import type { Case } from '../model/types';
import { findingBlock, pointerTables } from '../panels/case_card';
import { verdictTag } from '../panels/verdict';
import type { LiveState } from './answers';
import type { Connection } from './connection';

export function output(text: string): Child {
  if (text === '') return null;
  return el('details', {}, el('summary', {}, 'What the code printed'), el('pre', { tabindex: 0 }, text));
}

/** What the judge says of the code, folded but for the first finding. */
export function verdict(told: Case, title: string): Child[] {
  const [first, ...others] = told.findings;
  const pointers = told.findings.find((f) => f.pointers)?.pointers;
  return [
    el('h3', {}, verdictTag(told.verdict), ` ${title}`),
    told.note !== '' && el('p', { class: 'note' }, told.note),
    first && findingBlock(first, true),
    pointers && foldedTables(pointerTables(pointers)),
    others.length > 0 && el('details', {},
      el('summary', {}, others.length === 1 ? '1 more finding' : `${others.length} more findings`),
      ...others.map((f) => findingBlock(f, false))),
    output(told.output),
  ];
}

function foldedTables(tables: HTMLElement): HTMLElement {
  tables.removeAttribute('open');
  return tables;
}

/** The messages of the compiler, if it had any. */
export function compilerBanner(build: LiveState['build']): Child {
  const failed = build.files.filter((f) => !f.compiled);
  if (failed.length === 0) return null;
  return el('div', { class: 'stop' }, el('h3', {}, '✗ Does not compile'),
    el('p', {}, 'The program before goes on where there is one.'),
    ...failed.map((f) => el('pre', { tabindex: 0 }, `${f.name}\n${f.messages}`)));
}

export function buildTag(build: LiveState['build']): HTMLElement {
  return build.compiled
    ? el('span', { class: 'tag good' }, '✓ compiled')
    : el('span', { class: 'tag bad' }, '✗ does not compile');
}

/** A page of a Bezier form: head, drawing, side, foot. */
export class BezierShell {
  readonly stage = el('div', { class: 'stage-holder' });
  readonly told = el('div', { class: 'told' });
  readonly lists = el('div', { class: 'lists' });
  readonly foot = el('div', { class: 'actions', role: 'group', 'aria-label': 'Operations' });
  readonly files = el('span', { class: 'file-tools' });
  private readonly status = el('p', { class: 'status', role: 'status' });
  private readonly build = el('span', { class: 'build', role: 'status' });
  private readonly banner = el('div', { class: 'banner', role: 'alert' });
  private busy = false;
  private wanted: (() => Promise<void>) | null = null;

  constructor(app: HTMLElement, private readonly connection: Connection, name: string) {
    document.title = `${name} – Meshgrade`;
    replace(app, el('main', { class: 'live' },
      el('header', { class: 'live-head' }, el('strong', { class: 'brand' }, 'Meshgrade'),
        el('h1', { class: 'live-title' }, name), this.build, this.files),
      el('section', { class: 'mesh-panel', 'aria-label': name }, this.stage,
        el('div', { class: 'side' }, this.status, el('h2', { class: 'unseen' }, 'Your functions'),
          this.banner, this.told, this.lists)),
      el('footer', { class: 'live-foot' }, this.foot)));
    this.say('Loading …');
    void this.look();
  }

  say(text: string): void {
    this.status.textContent = text;
  }

  private loaded(): void {
    if (this.status.textContent === 'Loading …') this.say('');
  }

  /** Calls back after every build. */
  listen(ask: () => Promise<void>): void {
    this.connection.listen(() => {
      void this.look();
      void this.run(ask);
    }, (alive) => {
      if (!alive) this.say('meshgrade view does not answer');
    });
  }

  private async look(): Promise<void> {
    const { build } = await this.connection.look();
    replace(this.build, buildTag(build));
    replace(this.banner, compilerBanner(build));
  }

  /** While a question is under way only the last of those that come is kept. */
  async run(ask: () => Promise<void>): Promise<void> {
    this.wanted = ask;
    if (this.busy) return;
    this.busy = true;
    while (this.wanted) {
      const next: () => Promise<void> = this.wanted;
      this.wanted = null;
      await next().then(() => this.loaded(), (error: Error) => this.say(error.message));
    }
    this.busy = false;
  }
}
