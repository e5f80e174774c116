// Undo and redo by whole states, which are small here.

const LONGEST = 500;

export class History<T> {
  private readonly past: T[] = [];
  private readonly future: T[] = [];

  /** To be called before a change, with the state as it still is. */
  keep(now: T): void {
    this.past.push(structuredClone(now));
    if (this.past.length > LONGEST) this.past.shift();
    this.future.length = 0;
  }

  /** The state before, or null if there is none; `now` can be had again by redo. */
  undo(now: T): T | null {
    return this.swap(this.past, this.future, now);
  }

  redo(now: T): T | null {
    return this.swap(this.future, this.past, now);
  }

  private swap(from: T[], to: T[], now: T): T | null {
    const then = from.pop();
    if (then === undefined) return null;
    to.push(structuredClone(now));
    return then;
  }
}
