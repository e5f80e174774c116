// Which function of the student's is meant by a word and by what is selected.

import { nameOf, type Element, type Kind, type Mesh } from './mesh';

/** What the student's functions can do, as the grader lists it. */
export interface Verb {
  /** "collapse"; several may have one word, each for another kind of element. */
  word: string;
  /** "c"; an upper-case letter with Shift. Several: any of them. */
  keys: string;
  /** "vertex", "edge", "face"; empty: the whole mesh. */
  picks: string;
  /** How many elements are picked. */
  picked: number;
  subdivides: boolean;
}

/** Verbs of one word. */
export interface Word {
  word: string;
  keys: string;
  verbs: Verb[];
}

const KINDS: Record<string, Kind> = { vertex: 'v', edge: 'e', face: 'f' };

/** Each word once, in the order of the list. */
export function wordsOf(verbs: Verb[]): Word[] {
  const words: Word[] = [];
  for (const verb of verbs) {
    const known = words.find((w) => w.word === verb.word);
    if (known) known.verbs.push(verb);
    else words.push({ word: verb.word, keys: verb.keys, verbs: [verb] });
  }
  return words;
}

/** How a key is called: "C", "Shift+D". */
export function keyName(key: string): string {
  return key !== key.toLowerCase() ? `Shift+${key}` : key.toUpperCase();
}

/** "catmull-clark" as a button has it. */
export const titleOf = (word: string): string => word.charAt(0).toUpperCase() + word.slice(1);

/** "an edge or a face" */
export function picksText(word: Word): string {
  const kinds = word.verbs.map(({ picks }) => `${/^[aeiou]/.test(picks) ? 'an' : 'a'} ${picks}`);
  return kinds.join(' or ');
}

/** The word that a key stands for: an upper-case letter is that with Shift. */
export function wordOfKey(words: Word[], key: string, shift: boolean): Word | undefined {
  const letter = shift ? key.toUpperCase() : key.toLowerCase();
  return words.find(({ keys }) => keys.includes(letter)) ??
    words.find(({ keys }) => shift && keys === keys.toLowerCase() && keys.includes(key.toLowerCase()));
}

/** A verb with what it is about, or why there is none. */
export interface Meant {
  verb: Verb | null;
  picked: number | null;
}

/** What a word means for the selected element. A half-edge stands for its edge. */
export function meaning(word: Word, selected: Element | null, mesh: Mesh | undefined): Meant {
  for (const verb of word.verbs) {
    if (verb.picked === 0) return { verb, picked: null };
    const kind = KINDS[verb.picks];
    if (selected && selected.kind === kind) return { verb, picked: selected.index };
    if (kind === 'e' && selected?.kind === 'h' && mesh) {
      const edge = mesh.edge(selected.index);
      if (edge >= 0) return { verb, picked: edge };
    }
  }
  return { verb: null, picked: null };
}

/** "e3" of a verb that picks edges. */
export const pickedName = (verb: Verb, index: number): string =>
  nameOf({ kind: KINDS[verb.picks] ?? 'e', index });
