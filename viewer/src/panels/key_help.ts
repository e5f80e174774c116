// The list of keys, on `?`.

import { button, el, keyButton, replace } from '../dom';

export type KeyRow = [keys: string, what: string];

/** Keys of the 3D view, wherever it is. */
export const VIEW_KEYS: KeyRow[] = [
  ['N, T, H', 'follow next, twin, or the half-edge of what is selected'],
  ['I, W, A', 'names, wireframe, arrows'],
  ['[ and ]', 'before, yours, expected'],
  ['arrow keys', 'turn the view, with Shift move it'],
  ['+, -, Space', 'nearer, further, reset'],
  ['P', 'save the picture'],
  ['Esc', 'select nothing'],
];

export class KeyHelp {
  readonly button: HTMLButtonElement;
  private readonly dialog: HTMLDialogElement;
  private readonly rows = el('tbody');

  constructor(rows: KeyRow[]) {
    this.setRows(rows);
    this.dialog = el('dialog', { class: 'key-help', 'aria-label': 'Keys' },
      el('h2', {}, 'Keys'),
      el('table', {}, this.rows),
      button('Close', () => this.dialog.close(), { class: 'primary' }));
    this.button = keyButton('Keys', '?', () => this.show());
    document.addEventListener('keydown', (event) => {
      if (event.key !== '?' || (event.target as Element).closest('input, select, textarea')) return;
      event.preventDefault();
      this.show();
    });
  }

  setRows(rows: KeyRow[]): void {
    replace(this.rows, ...rows.map(([keys, what]) =>
      el('tr', {}, el('th', { scope: 'row' }, el('kbd', {}, keys)), el('td', {}, what))));
  }

  private show(): void {
    if (!this.dialog.isConnected) document.body.append(this.dialog);
    if (!this.dialog.open) this.dialog.showModal();
  }
}
