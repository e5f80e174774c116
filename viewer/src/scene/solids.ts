// The bodies that mark something in the 3D view. They are seen through the surface.

import * as THREE from 'three';
import { add, length, mix, scale, sub, unit, type Surface, type Vec } from './shapes';

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
function tip(middle: Vec, direction: Vec, size: number, color: string): THREE.Mesh {
  const object = marked(new THREE.ConeGeometry(size, 3 * size, 14), color, 4);
  object.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), new THREE.Vector3(...direction));
  object.position.set(...middle);
  return object;
}

/** An arrow that rises towards `outward` on its way; `size` is half that of the mesh. */
export function arcObjects(
  from: Vec, to: Vec, outward: Vec, size: number, color: string,
): { objects: THREE.Mesh[]; apex: Vec } {
  const lift = scale(outward, 0.25 * length(sub(to, from)) + 0.06 * size);
  const points: Vec[] = [];
  for (let i = 0; i <= 12; ++i) {
    const t = i / 12;
    points.push(add(mix(from, to, t), scale(lift, 4 * t * (1 - t))));
  }
  const direction = unit(sub(to, points[11]!));
  const head = tip(sub(to, scale(direction, 0.04 * size)), direction, 0.03 * size, color);
  return { objects: [tube(points, 0.008 * size, color), head], apex: points[6]! };
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

const BEHIND_LINES = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2 };

/**
 * Front and back in one pass, each in its colour.
 *
 * @param normals  of the vertices; null: each face is flat
 */
export function surfaceObject(
  surface: Surface, positions: THREE.BufferAttribute, normals: Float32Array | null, front: string, back: string,
): THREE.Mesh {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', positions);
  geometry.setIndex(new THREE.BufferAttribute(surface.corners, 1));
  if (normals) geometry.setAttribute('normal', new THREE.BufferAttribute(normals, 3));
  const material = new THREE.MeshLambertMaterial({
    color: front, side: THREE.DoubleSide, flatShading: normals === null, ...BEHIND_LINES,
  });
  material.onBeforeCompile = (shader) => {
    shader.uniforms['backColor'] = { value: new THREE.Color(back) };
    shader.fragmentShader = `uniform vec3 backColor;\n${shader.fragmentShader}`.replace(
      'vec4( diffuse, opacity )', 'vec4( gl_FrontFacing ? diffuse : backColor, opacity )');
  };
  return new THREE.Mesh(geometry, material);
}

/** Each vertex in its colour, without light: a colour means a number. */
export function colouredObject(
  surface: Surface, positions: THREE.BufferAttribute, colors: (string | null)[], none: string,
): THREE.Mesh {
  const values = new Float32Array(positions.array.length);
  const color = new THREE.Color();
  for (let v = 0; v < positions.count; ++v) {
    color.setStyle(colors[v] ?? none);
    values.set([color.r, color.g, color.b], 3 * v);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', positions);
  geometry.setAttribute('color', new THREE.BufferAttribute(values, 3));
  geometry.setIndex(new THREE.BufferAttribute(surface.corners, 1));
  return new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
    vertexColors: true, side: THREE.DoubleSide, ...BEHIND_LINES,
  }));
}
