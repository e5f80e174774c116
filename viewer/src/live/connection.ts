// Talks to the program that serves this page.

import type {
  CurveAnswer, IsocurvesAnswer, LiveState, PatchAnswer, Point2, Point3,
} from './answers';
import { unpackLive } from './unpack';
import type { StateJson } from '../model/types';
import type { Verb } from '../model/verbs';

export class Connection {
  constructor(private readonly token: string) {}

  /** @throws Error with a text for people if the server says no, or is not there */
  private async post<T>(path: string, body: unknown): Promise<T> {
    const bytes = body instanceof Uint8Array;
    let response: Response;
    try {
      response = await fetch(path, {
        method: 'POST',
        headers: { 'X-Meshgrade-Token': this.token,
          'Content-Type': bytes ? 'application/octet-stream' : 'application/json' },
        body: bytes ? (body as BodyInit) : JSON.stringify(body),
      });
    } catch {
      throw new Error('meshgrade view does not answer: is it still running?');
    }
    if (response.headers.get('Content-Type') === 'application/octet-stream') {
      return unpackLive(await response.arrayBuffer()) as T;
    }
    const text = await response.text();
    if (!response.ok && !text.startsWith('{')) throw new Error(text || `error ${response.status}`);
    const value = JSON.parse(text) as T & { error?: string };
    if (!response.ok) throw new Error(value.error ?? `error ${response.status}`);
    return value;
  }

  look = (): Promise<LiveState> => this.post('/state', {});
  step = (verb: Verb, picked: number[]): Promise<LiveState> =>
    this.post('/step', {
      kind: verb.word,
      ...(verb.picked > 0 ? { [verb.picks]: picked[0] } : {}),
      ...(verb.picked > 1 ? { partner: picked[1] } : {}),
    });
  goTo = (position: number): Promise<LiveState> => this.post('/go', { position });
  open = (name: string, bytes: Uint8Array): Promise<LiveState> =>
    this.post(`/open?name=${encodeURIComponent(name)}`, bytes);
  normals = (): Promise<{ normals?: (number | null)[]; error?: string }> => this.post('/normals', {});

  levels = (): Promise<{ label: string; state: StateJson }[]> => this.post('/levels', {});

  curve = (points: Point2[], t: number): Promise<CurveAnswer> => this.post('/curve', { points, t });
  patch = (net: Point3[][], density: number): Promise<PatchAnswer> => this.post('/patch', { net, density });
  isocurves = (net: Point3[][], u: number, v: number): Promise<IsocurvesAnswer> =>
    this.post('/isocurves', { net, u, v });

  /** Calls back whenever the source was built again, and when the server comes or goes. */
  listen(onChange: () => void, onAlive: (alive: boolean) => void): void {
    const events = new EventSource(`/events?token=${this.token}`);
    events.onmessage = onChange;
    events.onopen = () => onAlive(true);
    events.onerror = () => onAlive(false);
  }
}
