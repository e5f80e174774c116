// Where a view of the scene is taken from, and how it moves.

import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { add, scale, unit, type Vec } from './shapes';

/** What is looked at. */
export interface Ball {
  centre: Vec;
  radius: number;
}

export class Viewpoint {
  readonly camera = new THREE.PerspectiveCamera(38, 1, 0.01, 100);
  ball: Ball = { centre: [0, 0, 0], radius: 1 };
  /** Anything about the camera has changed. */
  onMove: () => void = () => {};
  /** A drag by mouse or finger begins or ends. */
  onDrag: (on: boolean) => void = () => {};

  private readonly controls: OrbitControls;
  private readonly followers: Viewpoint[] = [];
  private hasSize = false;

  /** @param upright  which axis is up: surfaces are modelled with z upright */
  constructor(private readonly canvas: HTMLCanvasElement, private readonly upright: 'y' | 'z' = 'y') {
    // The controls keep what is up from the beginning.
    if (upright === 'z') this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.moved());
    this.controls.addEventListener('start', () => this.onDrag(true));
    this.controls.addEventListener('end', () => this.onDrag(false));
  }

  dispose(): void {
    this.controls.dispose();
  }

  /** The wheel zooms only while the canvas has the focus, so that a long page can be scrolled. */
  zoomOnlyWithFocus(): void {
    this.controls.enableZoom = false;
    this.canvas.addEventListener('focus', () => (this.controls.enableZoom = true));
    this.canvas.addEventListener('blur', () => (this.controls.enableZoom = false));
  }

  /** The others move as this one does. */
  leads(others: Viewpoint[]): void {
    this.followers.push(...others);
  }

  /** @param aspect  width by height of the picture */
  setAspect(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
    if (!this.hasSize) this.reset();
    this.hasSize = true;
  }

  /** Looks at this ball, not at the one around the mesh: that of another mesh beside it. */
  lookAtBall(ball: Ball): void {
    this.ball = ball;
    this.reset();
  }

  /** Angles in degrees: 0, 0 looks from +z. The distance is in radii of the ball. */
  lookFromAngles(azimuth: number, elevation: number, distance: number): void {
    const radians = Math.PI / 180;
    const up = Math.max(-89.9, Math.min(89.9, elevation)) * radians;
    const direction: Vec = [Math.sin(azimuth * radians) * Math.cos(up), Math.sin(up), Math.cos(azimuth * radians) * Math.cos(up)];
    this.lookFrom(direction, this.ball.centre, distance * this.ball.radius);
  }

  reset(): void {
    this.lookFrom(this.upright === 'z' ? [0.55, -0.9, 0.42] : [0.55, 0.42, 0.9], this.ball.centre, this.ball.radius * 3.15);
  }

  lookFrom(direction: Vec, target: Vec, distance: number): void {
    // A narrow view needs to be further away.
    const far = distance * Math.max(1, 1 / (this.camera.aspect || 1));
    this.controls.target.set(...target);
    this.camera.position.set(...add(target, scale(unit(direction), far)));
    this.camera.near = this.ball.radius / 200;
    this.camera.far = this.ball.radius * 60;
    this.camera.updateProjectionMatrix();
    this.update();
  }

  /** Angles in radians. */
  orbit(right: number, up: number): void {
    // Spherical coordinates have y up.
    const turn = new THREE.Quaternion().setFromUnitVectors(this.camera.up, new THREE.Vector3(0, 1, 0));
    const offset = this.camera.position.clone().sub(this.controls.target).applyQuaternion(turn);
    const spherical = new THREE.Spherical().setFromVector3(offset);
    spherical.theta += right;
    spherical.phi = Math.min(Math.PI - 0.01, Math.max(0.01, spherical.phi - up));
    this.camera.position.setFromSpherical(spherical).applyQuaternion(turn.invert()).add(this.controls.target);
    this.update();
  }

  zoom(factor: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    this.camera.position.copy(this.controls.target).add(offset);
    this.update();
  }

  /** By parts of the distance to what is looked at. */
  pan(right: number, up: number): void {
    const reach = this.camera.position.distanceTo(this.controls.target);
    const shift = new THREE.Vector3(right * reach, up * reach, 0).applyQuaternion(this.camera.quaternion);
    this.camera.position.add(shift);
    this.controls.target.add(shift);
    this.update();
  }

  private update(): void {
    this.controls.update();
    this.onMove();
  }

  private moved(): void {
    this.onMove();
    for (const other of this.followers) other.follow(this);
  }

  /** Tells nobody, since all may follow each other. */
  private follow(leader: Viewpoint): void {
    this.camera.position.copy(leader.camera.position);
    this.controls.target.copy(leader.controls.target);
    this.camera.lookAt(this.controls.target);
    this.onMove();
  }
}
