// The bodies that mark something in the 3D view. They are seen through the surface.

import * as THREE from 'three';
import type { Vec } from './shapes';

function marked(geometry: THREE.BufferGeometry, color: string, order: number): THREE.Mesh {
  const object = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ color, depthTest: false }));
  object.renderOrder = order;
  return object;
}

export function ball(at: Vec, radius: number, color: string): THREE.Mesh {
  const object = marked(new THREE.SphereGeometry(radius, 20, 14), color, 3);
  object.position.set(...at);
  return object;
}

/** A round line through points. */
export function tube(points: Vec[], radius: number, color: string): THREE.Mesh {
  const curve = new THREE.CatmullRomCurve3(points.map((p) => new THREE.Vector3(...p)));
  const pieces = points.length > 2 ? Math.max(32, points.length - 1) : 1;
  return marked(new THREE.TubeGeometry(curve, pieces, radius, 8), color, 3);
}

/** The head of an arrow, around `middle`. */
export function tip(middle: Vec, direction: Vec, size: number, color: string): THREE.Mesh {
  const object = marked(new THREE.ConeGeometry(size, 3 * size, 14), color, 4);
  object.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), new THREE.Vector3(...direction));
  object.position.set(...middle);
  return object;
}

/** Triangles in one colour, without light. */
export function flatTriangles(points: Vec[], color: string, onTop: boolean): THREE.Mesh {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(Float32Array.from(points.flat()), 3));
  const material = new THREE.MeshBasicMaterial({ color, side: THREE.DoubleSide, depthTest: !onTop });
  const object = new THREE.Mesh(geometry, material);
  object.renderOrder = onTop ? 2 : 1;
  return object;
}
