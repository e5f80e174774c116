// Meshes as files: OBJ as text, GLB as bytes. Faces that do not close are left out.

import type { Mesh } from './mesh';

interface Polygons {
  positions: [number, number, number][];
  polygons: number[][];
}

export function polygonsOf(mesh: Mesh): Polygons {
  const place = new Map<number, number>();
  const positions: [number, number, number][] = [];
  for (let v = 0; v < mesh.vertexCount; ++v) {
    if (!mesh.isLive({ kind: 'v', index: v })) continue;
    place.set(v, positions.length);
    positions.push(mesh.position(v));
  }
  const polygons = mesh
    .faces()
    .filter((walk) => walk.closed)
    .map((walk) => walk.halfedges.map((h) => place.get(mesh.vertex(h))!));
  return { positions, polygons };
}

export function toObj(mesh: Mesh): string {
  const { positions, polygons } = polygonsOf(mesh);
  const lines = [
    ...positions.map((p) => `v ${p.join(' ')}`),
    ...polygons.map((polygon) => `f ${polygon.map((corner) => corner + 1).join(' ')}`),
  ];
  return lines.join('\n') + '\n';
}

const padded = (size: number): number => Math.ceil(size / 4) * 4;

/** Binary glTF 2.0 with one mesh of triangles. */
export function toGlb(mesh: Mesh): Uint8Array {
  const { positions, polygons } = polygonsOf(mesh);
  const corners = polygons.flatMap((p) => p.slice(2).flatMap((_, i) => [p[0]!, p[i + 1]!, p[i + 2]!]));
  const points = Float32Array.from(positions.flat());
  const indices = Uint32Array.from(corners);
  const reach = (pick: (...x: number[]) => number, start: number): number[] =>
    [0, 1, 2].map((axis) => positions.reduce((m, p) => pick(m, Math.fround(p[axis]!)), start));
  const json = JSON.stringify({
    asset: { version: '2.0', generator: 'Meshgrade' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    buffers: [{ byteLength: points.byteLength + indices.byteLength }],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: points.byteLength, target: 34962 },
      { buffer: 0, byteOffset: points.byteLength, byteLength: indices.byteLength, target: 34963 },
    ],
    accessors: [
      { bufferView: 0, componentType: 5126, count: positions.length, type: 'VEC3',
        min: reach(Math.min, Infinity), max: reach(Math.max, -Infinity) },
      { bufferView: 1, componentType: 5125, count: corners.length, type: 'SCALAR' },
    ],
  });
  const text = new TextEncoder().encode(json);
  const jsonSize = padded(text.length);
  const binarySize = points.byteLength + indices.byteLength;
  const bytes = new Uint8Array(12 + 8 + jsonSize + 8 + binarySize).fill(0x20);
  const view = new DataView(bytes.buffer);
  [0x46546c67, 2, bytes.length, jsonSize, 0x4e4f534a].forEach((x, i) => view.setUint32(4 * i, x, true));
  bytes.set(text, 20);
  view.setUint32(20 + jsonSize, binarySize, true);
  view.setUint32(24 + jsonSize, 0x004e4942, true);
  bytes.set(new Uint8Array(points.buffer), 28 + jsonSize);
  bytes.set(new Uint8Array(indices.buffer), 28 + jsonSize + points.byteLength);
  return bytes;
}

/** Hands a picture to the browser's downloads, as PNG. */
export function savePicture(name: string, canvas: HTMLCanvasElement): void {
  canvas.toBlob((blob) => void blob?.arrayBuffer().then((bytes) => saveFile(name, new Uint8Array(bytes))));
}

const SVG_STYLES = ['fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'stroke-linecap', 'stroke-linejoin', 'opacity'];

/** The same for an SVG picture of the page, with the styles that it has here. */
export function saveSvg(name: string, picture: SVGElement): void {
  const copy = picture.cloneNode(true) as SVGElement;
  const originals = [picture, ...picture.querySelectorAll('*')];
  [copy, ...copy.querySelectorAll('*')].forEach((element, i) => {
    const style = getComputedStyle(originals[i]!);
    for (const property of SVG_STYLES) element.setAttribute(property, style.getPropertyValue(property));
  });
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  const ground = document.createElementNS('http://www.w3.org/2000/svg', 'rect');
  for (const side of ['width', 'height']) ground.setAttribute(side, '100%');
  ground.setAttribute('fill', getComputedStyle(picture.parentElement!).backgroundColor);
  copy.prepend(ground);
  saveFile(name, new XMLSerializer().serializeToString(copy));
}

/** Hands a file to the browser's downloads. */
export function saveFile(name: string, content: string | Uint8Array): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([content as BlobPart]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
