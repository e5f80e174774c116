// The control nets of a surface of several patches. Patches that meet have points in the same
// place: they move together, so that the surface does not tear.

export type Net = [number, number, number][][];

/** A place, and all control points that are there. */
export interface ControlPoint {
  at: [number, number, number];
  of: { patch: number; row: number; col: number }[];
}

export function controlPoints(nets: Net[]): ControlPoint[] {
  const places = new Map<string, ControlPoint>();
  nets.forEach((net, patch) => net.forEach((points, row) => points.forEach((at, col) => {
    const key = at.join(' ');
    const place = places.get(key) ?? { at, of: [] };
    place.of.push({ patch, row, col });
    places.set(key, place);
  })));
  return [...places.values()];
}

/** Moves all control points of a place. @returns the patches that have changed */
export function movePoint(nets: Net[], point: ControlPoint, to: [number, number, number]): number[] {
  for (const { patch, row, col } of point.of) nets[patch]![row]![col] = [...to];
  point.at = [...to];
  return [...new Set(point.of.map((p) => p.patch))];
}
