// Points in the 3D view that can be dragged: in the plane through them that faces the camera.

import * as THREE from 'three';
import { followPointer } from '../dom';
import type { Vec } from './shapes';

/** What handles need of the view that they are in. */
export interface HandleStage {
  canvas: HTMLCanvasElement;
  camera: THREE.PerspectiveCamera;
  draw(): void;
}

/** As far from a point as it can be taken, in pixels. */
const REACH = 13;

function dots(size: number): THREE.Points<THREE.BufferGeometry, THREE.ShaderMaterial> {
  const material = new THREE.ShaderMaterial({
    uniforms: { size: { value: size }, fill: { value: new THREE.Color() }, rim: { value: new THREE.Color() } },
    vertexShader: `uniform float size;
      void main() {
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        gl_PointSize = size;
      }`,
    fragmentShader: `uniform vec3 fill;
      uniform vec3 rim;
      void main() {
        float far = length(gl_PointCoord - 0.5);
        if (far > 0.5) discard;
        gl_FragColor = vec4(far > 0.36 ? rim : fill, 1.0);
        #include <colorspace_fragment>
      }`,
    depthTest: false,
  });
  const object = new THREE.Points(new THREE.BufferGeometry(), material);
  object.renderOrder = 5;
  object.frustumCulled = false;
  return object;
}

export class Handles {
  readonly group = new THREE.Group();
  chosen = -1;
  onChoose: (i: number) => void = () => {};
  /** Before the first of a row of moves. */
  onGrab: () => void = () => {};
  onMove: (i: number, to: Vec) => void = () => {};

  private points: Vec[] = [];
  private readonly all = dots(11);
  private readonly one = dots(17);

  constructor(private readonly stage: HandleStage) {
    this.group.add(this.all, this.one);
    // Before the camera's own listeners, so that a drag of a point does not turn the view.
    stage.canvas.addEventListener('pointerdown', (event) => this.down(event), { capture: true });
    stage.canvas.addEventListener('pointermove', (event) => {
      if (event.buttons === 0) stage.canvas.style.cursor = this.near(event) >= 0 ? 'grab' : '';
    });
  }

  show(points: Vec[], chosen: number, colors: { fill: string; chosen: string; rim: string }): void {
    this.points = points;
    this.chosen = chosen < points.length ? chosen : -1;
    const ratio = Math.min(2, window.devicePixelRatio);
    const set = (object: typeof this.all, some: Vec[], fill: string, size: number): void => {
      object.geometry.dispose();
      object.geometry = new THREE.BufferGeometry();
      object.geometry.setAttribute('position', new THREE.BufferAttribute(Float32Array.from(some.flat()), 3));
      object.material.uniforms['fill']!.value = new THREE.Color(fill);
      object.material.uniforms['rim']!.value = new THREE.Color(colors.rim);
      object.material.uniforms['size']!.value = size * ratio;
    };
    set(this.all, points, colors.fill, 11);
    set(this.one, this.chosen >= 0 ? [points[this.chosen]!] : [], colors.chosen, 17);
    this.stage.draw();
  }

  /** Moves the chosen point as the camera sees it; `away` is into the picture. */
  step(right: number, up: number, away: number): void {
    const at = this.points[this.chosen];
    if (!at) return;
    const { camera } = this.stage;
    const reach = camera.position.distanceTo(new THREE.Vector3(...at));
    const shift = new THREE.Vector3(right, up, -away).multiplyScalar(reach).applyQuaternion(camera.quaternion);
    this.onMove(this.chosen, shift.add(new THREE.Vector3(...at)).toArray());
  }

  /** The point under the pointer; -1: none. */
  private near(event: PointerEvent): number {
    const box = this.stage.canvas.getBoundingClientRect();
    let best = -1;
    let least = REACH;
    const p = new THREE.Vector3();
    this.points.forEach((at, i) => {
      p.set(...at).project(this.stage.camera);
      const x = box.left + ((p.x + 1) / 2) * box.width;
      const y = box.top + ((1 - p.y) / 2) * box.height;
      const far = Math.hypot(event.clientX - x, event.clientY - y);
      if (Math.abs(p.z) > 1 || far >= least) return;
      [best, least] = [i, far];
    });
    return best;
  }

  private down(event: PointerEvent): void {
    const i = event.button === 0 ? this.near(event) : -1;
    if (i < 0) return;
    event.stopImmediatePropagation();
    const { camera, canvas } = this.stage;
    const normal = camera.getWorldDirection(new THREE.Vector3());
    const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(normal, new THREE.Vector3(...this.points[i]!));
    this.onChoose(i);
    canvas.focus();
    let grabbed = false;
    followPointer((now) => {
      const to = rayAt(now, canvas, camera).intersectPlane(plane, new THREE.Vector3());
      if (!to) return;
      if (!grabbed) this.onGrab();
      grabbed = true;
      this.onMove(i, to.toArray());
    });
  }
}

/** From the camera through the pointer. */
export function rayAt(event: PointerEvent, canvas: HTMLCanvasElement, camera: THREE.Camera): THREE.Ray {
  const box = canvas.getBoundingClientRect();
  const caster = new THREE.Raycaster();
  caster.setFromCamera(new THREE.Vector2(
    (2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height), camera);
  return caster.ray;
}
