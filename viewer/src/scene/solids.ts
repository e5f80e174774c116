// What the 3D view consists of, as objects of three.js. Lengths are those of the mesh.

import * as THREE from 'three';
import { add, length, mix, scale, sub, unit, type Surface, type Vec } from './shapes';

/** Pairs of ends. */
export function lineObject(points: Float32Array, color: string): THREE.LineSegments {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(points, 3));
  const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color }));
  lines.userData['detail'] = true;
  return lines;
}

export function triangleObject(points: Vec[], color: string, onTop: boolean): THREE.Mesh {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(Float32Array.from(points.flat()), 3));
  const material = new THREE.MeshBasicMaterial({ color, side: THREE.DoubleSide, depthTest: !onTop });
  const object = new THREE.Mesh(geometry, material);
  object.renderOrder = onTop ? 2 : 1;
  return object;
}

export function ballObject(at: Vec, radius: number, color: string): THREE.Mesh {
  const object = new THREE.Mesh(
    new THREE.SphereGeometry(radius, 20, 14),
    new THREE.MeshBasicMaterial({ color, depthTest: false }),
  );
  object.position.set(...at);
  object.renderOrder = 3;
  return object;
}

export function tubeObject(points: Vec[], color: string, radius: number): THREE.Mesh {
  const curve = new THREE.CatmullRomCurve3(points.map((p) => new THREE.Vector3(...p)));
  const object = new THREE.Mesh(
    new THREE.TubeGeometry(curve, points.length > 2 ? 32 : 1, radius, 8),
    new THREE.MeshBasicMaterial({ color, depthTest: false }),
  );
  object.renderOrder = 3;
  return object;
}

/** An arrow that rises towards `outward` on its way; `size` is half that of the mesh. */
export function arcObjects(from: Vec, to: Vec, outward: Vec, size: number, color: string): { objects: THREE.Mesh[]; apex: Vec } {
  const lift = scale(outward, 0.25 * length(sub(to, from)) + 0.06 * size);
  const points: Vec[] = [];
  for (let i = 0; i <= 12; ++i) {
    const t = i / 12;
    points.push(add(mix(from, to, t), scale(lift, 4 * t * (1 - t))));
  }
  const tip = new THREE.Mesh(
    new THREE.ConeGeometry(0.03 * size, 0.09 * size, 14),
    new THREE.MeshBasicMaterial({ color, depthTest: false }),
  );
  const direction = new THREE.Vector3(...unit(sub(to, points[11]!)));
  tip.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), direction);
  tip.position.set(...sub(to, scale(direction.toArray() as Vec, 0.04 * size)));
  tip.renderOrder = 4;
  return { objects: [tubeObject(points, color, 0.008 * size), tip], apex: points[6]! };
}

const OFFSET = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2 };

/** @param normals  of the vertices; null: each face is flat */
export function surfaceObjects(surface: Surface, normals: Float32Array | null, front: string, back: string): THREE.Mesh[] {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(surface.positions, 3));
  if (normals) {
    const corners = new Float32Array(surface.positions.length);
    surface.corners.forEach((v, i) => {
      for (let axis = 0; axis < 3; ++axis) corners[3 * i + axis] = normals[3 * v + axis]!;
    });
    geometry.setAttribute('normal', new THREE.BufferAttribute(corners, 3));
  } else {
    geometry.computeVertexNormals();
  }
  const sides = [[THREE.FrontSide, front], [THREE.BackSide, back]] as const;
  return sides.map(([side, color]) =>
    new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color, side, ...OFFSET })));
}

/** Each vertex in its colour, without light: a colour means a number. */
export function colouredObject(surface: Surface, colors: (string | null)[], none: string): THREE.Mesh {
  const corners = new Float32Array(surface.positions.length);
  const color = new THREE.Color();
  surface.corners.forEach((v, i) => {
    color.setStyle(colors[v] ?? none);
    corners.set([color.r, color.g, color.b], 3 * i);
  });
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(surface.positions, 3));
  geometry.setAttribute('color', new THREE.BufferAttribute(corners, 3));
  return new THREE.Mesh(geometry,
    new THREE.MeshBasicMaterial({ vertexColors: true, side: THREE.DoubleSide, ...OFFSET }));
}
