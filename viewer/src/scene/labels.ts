// Ids and callouts, drawn as text over the 3D view.

import { Vector3, type Camera } from 'three';
import type { Palette } from './colors';
import type { Plane, Vec } from './shapes';

export interface Label {
  text: string;
  at: Vec;
  /** Hidden when it faces away from the camera; zero: always shown. */
  normal: Vec;
  /** Of all faces around it: hidden when all of them face away. */
  planes?: Plane[];
  style: 'vertex' | 'halfedge' | 'face' | 'edge' | 'wrong' | 'selected';
}

const FONT = 'ui-monospace, "SFMono-Regular", Menlo, Consolas, "DejaVu Sans Mono", monospace';

function facesAway({ centre: [a, b, c], normal: [x, y, z] }: Plane, eye: Vector3): boolean {
  return x * (eye.x - a) + y * (eye.y - b) + z * (eye.z - c) <= 0;
}

function isHidden(label: Label, camera: Camera): boolean {
  const { at, normal, planes } = label;
  if (planes && planes.length > 0) return planes.every((plane) => facesAway(plane, camera.position));
  if (normal.every((x) => x === 0)) return false;
  return facesAway({ centre: at, normal }, camera.position);
}

export function drawLabels(
  canvas: HTMLCanvasElement,
  labels: Label[],
  camera: Camera,
  colors: Palette,
): void {
  const context = canvas.getContext('2d');
  if (!context) return;
  const ratio = canvas.width / Math.max(1, canvas.clientWidth);
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const point = new Vector3();
  for (const label of labels) {
    if (isHidden(label, camera)) continue;
    point.set(...label.at).project(camera);
    if (Math.abs(point.z) > 1) continue;
    const x = ((point.x + 1) / 2) * canvas.clientWidth;
    const y = ((1 - point.y) / 2) * canvas.clientHeight;
    drawLabel(context, label, x, y, colors);
  }
}

function drawLabel(
  context: CanvasRenderingContext2D,
  label: Label,
  x: number,
  y: number,
  colors: Palette,
): void {
  const boxed = label.style === 'vertex' || label.style === 'edge' || label.style === 'wrong' || label.style === 'selected';
  context.font = `${boxed ? '600 ' : ''}13px ${FONT}`;
  if (!boxed) {
    context.lineWidth = 3;
    context.lineJoin = 'round';
    context.strokeStyle = colors.ground;
    context.strokeText(label.text, x, y);
    context.fillStyle = label.style === 'face' ? colors.muted : colors.ink;
    context.fillText(label.text, x, y);
    return;
  }
  const width = context.measureText(label.text).width + 10;
  const fill = { vertex: colors.ink, edge: colors.muted, wrong: colors.wrong, selected: colors.selected }[
    label.style as 'vertex' | 'edge' | 'wrong' | 'selected'
  ];
  context.fillStyle = fill;
  context.beginPath();
  context.roundRect(x - width / 2, y - 10, width, 20, 5);
  context.fill();
  context.fillStyle = colors.ground;
  context.fillText(label.text, x, y + 0.5);
}
