import { el } from '../dom';

type Tone = 'good' | 'bad' | 'none';

/** Sign and tone of a verdict, so that it is never told by colour alone. */
export function toneOf(verdict: string): { sign: string; tone: Tone } {
  if (verdict === 'passed') return { sign: '✓', tone: 'good' };
  if (verdict === 'not implemented' || verdict === 'not judged') return { sign: '–', tone: 'none' };
  if (verdict === 'grader error') return { sign: '!', tone: 'none' };
  return { sign: '✗', tone: 'bad' };
}

export function verdictTag(verdict: string): HTMLElement {
  const { sign, tone } = toneOf(verdict);
  return el('span', { class: `tag ${tone}` }, `${sign} ${verdict}`);
}

export function points(value: number): string {
  return String(Math.round(value * 100) / 100);
}
