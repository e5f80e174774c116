// The curves of constant u and of constant v through a point of a surface, chosen by sliders or
// by the pointer.

import { el } from '../dom';

export class Isocurves {
  readonly tools = el('span', { class: 'iso-tools' });
  patch = 0;
  private readonly choice: HTMLSelectElement;
  private readonly sliders: Record<'u' | 'v', HTMLInputElement>;
  private readonly shown: Record<'u' | 'v', HTMLOutputElement>;

  /** @param change  is called when the point was moved */
  constructor(patches: number, private readonly change: () => void) {
    this.choice = el('select', { 'aria-label': 'Patch' },
      ...Array.from({ length: patches }, (_, i) => el('option', { value: i }, `Patch ${i + 1}`)));
    this.choice.addEventListener('change', () => {
      this.patch = Number(this.choice.value);
      change();
    });
    const slider = (name: string): HTMLInputElement => {
      const made = el('input', { type: 'range', min: 0, max: 1, step: 0.01, value: 0.5, 'aria-label': name });
      made.addEventListener('input', () => {
        this.write();
        change();
      });
      return made;
    };
    this.sliders = { u: slider('u'), v: slider('v') };
    this.shown = { u: el('output', { class: 'mono' }), v: el('output', { class: 'mono' }) };
    if (patches > 1) this.tools.append(this.choice);
    for (const name of ['u', 'v'] as const) {
      this.tools.append(el('label', { class: 'slider' }, `${name} `, this.sliders[name], this.shown[name]));
    }
    this.write();
  }

  get u(): number {
    return Number(this.sliders.u.value);
  }
  get v(): number {
    return Number(this.sliders.v.value);
  }

  /** To where the pointer is. */
  moveTo(patch: number, u: number, v: number): void {
    this.patch = patch;
    this.choice.value = String(patch);
    this.sliders.u.value = String(u);
    this.sliders.v.value = String(v);
    this.write();
    this.change();
  }

  private write(): void {
    for (const name of ['u', 'v'] as const) this.shown[name].textContent = this[name].toFixed(2);
  }
}
