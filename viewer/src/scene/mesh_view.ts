// The 3D view of one mesh.

import * as THREE from 'three';
import { nameOf, sameElement, type Element, type Mesh } from '../model/mesh';
import { palette, type Palette } from './colors';
import { idLabels } from './id_labels';
import { drawLabels, type Label } from './labels';
import { Handles, rayAt } from './handles';
import { hitSurface, pick, type SurfaceHit } from './picking';
import {
  ArrowMaker, add, arrowTriangles, ballOf, length, linesOf, mix, placeOf, scale, sub,
  surfaceOf, unit, usualEdge, type Surface, type Vec,
} from './shapes';
import { arcObjects, ball, colouredObject, flatTriangles, surfaceObject, tube } from './solids';
import { Viewpoint } from './viewpoint';
import { softwareRendered } from './webgl';

/** A pointer that is wrong, or one that it should be. */
export interface Arc {
  element: Element;
  pointer: string;
  /** Where it leads; null: to no element that could be shown. */
  target: Element | null;
  text: string;
}

export interface Marks {
  arcs: Arc[];
  changed: Set<string>;
  /** The vertices that are furthest from where they must be. */
  vertices?: number[];
}

export interface ViewOptions {
  ids: boolean;
  wireframe: boolean;
  smooth: boolean;
  normalLines: boolean;
  arrows: boolean;
  edges: boolean;
  /** Names of edges beside the others. */
  edgeIds: boolean;
  /** Show the colours of the vertices, if there are any. */
  compare: boolean;
}

export interface ViewSetup {
  /** Smooth edges whatever they cost: for a picture that is drawn once. */
  fine?: boolean;
  /** Which axis is up; y if not said. */
  upright?: 'y' | 'z';
}

/** More arcs and callouts than this hide the mesh; the lists beside it name all. */
const MOST_CALLOUTS = 8;
const MOST_ARROWS = 3000;
const HEAVY_TRIANGLES = 20000;
const LEAST_EDGE_PIXELS = 5;

function clear(group: THREE.Group): void {
  group.traverse((object) => {
    if (!(object instanceof THREE.Mesh || object instanceof THREE.LineSegments)) return;
    object.geometry.dispose();
    for (const material of [object.material].flat()) (material as THREE.Material).dispose();
  });
  group.clear();
}

export class MeshView {
  readonly canvas: HTMLCanvasElement;
  readonly eye: Viewpoint;
  readonly options: ViewOptions = {
    ids: true, wireframe: false, smooth: false, normalLines: false, arrows: true, edges: true,
    edgeIds: false, compare: false,
  };
  /** Further lines, as pairs of ends. */
  lines: { points: Float32Array; color: keyof Palette }[] = [];
  /** Curves that are seen through the surface. */
  curves: { points: Vec[]; color: keyof Palette }[] = [];
  onPick: (element: Element | null) => void = () => {};
  /** Where the pointer is on the surface while no button is down. */
  onSurface: ((hit: SurfaceHit | null) => void) | null = null;
  /** The colours have changed: what was drawn from outside must be drawn again. */
  onRestyle: () => void = () => {};

  private readonly renderer: THREE.WebGLRenderer;
  private readonly labelCanvas = document.createElement('canvas');
  private readonly scene = new THREE.Scene();
  private readonly lamp = new THREE.DirectionalLight(0xffffff, 1.6);
  private readonly content = new THREE.Group();
  /** What changes with the selection, so that a click does not make a large mesh anew. */
  private readonly overlay = new THREE.Group();
  private readonly software: boolean;
  private readonly observer: ResizeObserver;
  private colors: Palette;
  private mesh: Mesh | null = null;
  private maker: ArrowMaker | null = null;
  private surface: Surface | null = null;
  private marks: Marks = { arcs: [], changed: new Set() };
  private normals: Float32Array | null = null;
  private vertexColors: (string | null)[] | null = null;
  private selected: Element | null = null;
  /** What was picked before the selection, of two elements. */
  private picked: Element | null = null;
  private labels: Label[] = [];
  private holeLabels: Label[] = [];
  private edgeLength = 0;
  private frame = 0;
  private size: [number, number] = [0, 0];
  private dragging = false;

  /** @throws Error if there is no WebGL */
  constructor(private readonly host: HTMLElement, setup: ViewSetup = {}) {
    this.software = softwareRendered() ?? false;
    this.renderer = new THREE.WebGLRenderer({ antialias: setup.fine || !this.software, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'img');
    this.labelCanvas.className = 'labels';
    this.labelCanvas.setAttribute('aria-hidden', 'true');
    host.replaceChildren(this.canvas, this.labelCanvas);
    this.colors = palette(host);
    this.paintGround();
    this.eye = new Viewpoint(this.canvas, setup.upright);
    this.eye.onMove = () => this.draw();
    this.eye.onDrag = (on) => this.drag(on);
    this.scene.add(this.content, this.overlay, new THREE.HemisphereLight(0xffffff, 0x9a9a9a, 1.9), this.eye.camera);
    this.eye.camera.add(this.lamp);
    this.lamp.position.set(-0.6, 0.9, 1);
    this.listenToPicks();
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(host);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', this.restyle);
  }

  dispose(): void {
    this.observer.disconnect();
    matchMedia('(prefers-color-scheme: dark)').removeEventListener('change', this.restyle);
    cancelAnimationFrame(this.frame);
    clear(this.content);
    clear(this.overlay);
    this.eye.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private readonly restyle = (): void => {
    this.colors = palette(this.host);
    this.paintGround();
    this.rebuild();
    this.onRestyle();
  };

  /** Also before there is a mesh: else the place for it is black. */
  private paintGround(): void {
    if (this.colors.ground !== '') this.scene.background = new THREE.Color(this.colors.ground);
  }

  /** Shows a mesh. The camera stays where it is unless `fit` asks for the whole mesh. */
  show(mesh: Mesh, marks: Marks, fit: boolean, normals: Float32Array | null = null): void {
    this.mesh = mesh;
    this.marks = marks;
    this.normals = normals;
    this.maker = new ArrowMaker(mesh);
    this.surface = surfaceOf(mesh);
    this.eye.ball = ballOf(mesh);
    this.edgeLength = usualEdge(this.surface);
    if (this.selected && !mesh.isLive(this.selected)) this.selected = null;
    if (fit) this.eye.reset();
    this.rebuild();
  }

  select(element: Element | null): void {
    this.selected = element;
    this.rebuildOverlay();
  }

  /** Marks the first of two elements that are picked; null: none. */
  markPicked(element: Element | null): void {
    this.picked = element;
    this.rebuildOverlay();
  }

  setOption(name: keyof ViewOptions, value: boolean): void {
    this.options[name] = value;
    this.rebuild();
  }

  /** Normals of the vertices by number, NaN where there is none; null: flat shading. */
  setNormals(normals: Float32Array | null): void {
    this.normals = normals;
    this.rebuild();
  }

  /** Colours of the vertices by number; null: one colour for all. Shown from the next show(). */
  colorVertices(colors: (string | null)[] | null): void {
    this.vertexColors = colors;
  }

  /** Turns the camera so that an element is in front. */
  turnTo(element: Element): void {
    const place = this.mesh && this.maker && placeOf(this.mesh, this.maker, element);
    if (!place) return;
    const outward = length(place.normal) > 0 ? place.normal : unit(sub(place.centre, this.eye.ball.centre));
    const tilted = unit(add(outward, scale([0.25, 0.35, 0.2], 0.8)));
    this.eye.lookFrom(tilted, mix(this.eye.ball.centre, place.centre, 0.3), this.eye.ball.radius * 3.1);
  }

  /** Takes the size of its place in the page. */
  resize(): void {
    const { clientWidth, clientHeight } = this.host;
    if (clientWidth === 0 || clientHeight === 0) return;
    if (this.size[0] === clientWidth && this.size[1] === clientHeight) return;
    this.size = [clientWidth, clientHeight];
    // Before it is part of the page, it has no colours.
    if (this.colors.ground === '') this.restyle();
    this.renderer.setSize(clientWidth, clientHeight, false);
    const ratio = Math.min(2, window.devicePixelRatio);
    this.labelCanvas.width = clientWidth * ratio;
    this.labelCanvas.height = clientHeight * ratio;
    this.eye.setAspect(clientWidth / clientHeight);
    this.draw();
  }

  private drag(on: boolean): void {
    this.dragging = on;
    if (this.software && this.isHeavy()) this.renderer.setPixelRatio(on ? 0.5 : 1);
    this.draw();
  }

  private isHeavy(): boolean {
    return (this.surface?.faces.length ?? 0) > HEAVY_TRIANGLES;
  }

  /** The lines of a large mesh are left out where they would hide it, and while it is turned. */
  private showDetail(): void {
    const plain = !this.isHeavy() || this.options.wireframe;
    const still = !(this.dragging && this.software);
    const wide = this.edgePixels() >= LEAST_EDGE_PIXELS;
    for (const child of this.content.children) {
      const { detail, edges } = child.userData;
      if (detail) child.visible = plain || (still && (!edges || wide));
    }
  }

  /** The length of a usual edge in the part of the mesh that is near. */
  private edgePixels(): number {
    const { centre, radius } = this.eye.ball;
    const far = Math.max(this.eye.camera.near, length(sub(this.eye.camera.position.toArray(), centre)) - 0.5 * radius);
    const half = Math.tan(THREE.MathUtils.degToRad(this.eye.camera.fov / 2));
    return (this.edgeLength / (2 * far * half)) * this.host.clientHeight;
  }

  draw(): void {
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => this.renderNow());
  }

  renderNow(): void {
    this.showDetail();
    this.renderer.render(this.scene, this.eye.camera);
    this.eye.camera.updateMatrixWorld();
    drawLabels(this.labelCanvas, this.dragging && this.labels.length > 200 ? [] : this.labels,
      this.eye.camera, this.colors);
  }

  /** What is seen, with its names, as one picture. */
  snapshot(): HTMLCanvasElement {
    this.renderNow();
    const both = document.createElement('canvas');
    both.width = this.canvas.width;
    both.height = this.canvas.height;
    const context = both.getContext('2d')!;
    for (const layer of [this.canvas, this.labelCanvas]) context.drawImage(layer, 0, 0, both.width, both.height);
    return both;
  }

  private listenToPicks(): void {
    let down = [0, 0];
    this.canvas.addEventListener('pointerdown', (event) => (down = [event.clientX, event.clientY]));
    this.canvas.addEventListener('pointerup', (event) => {
      if (Math.hypot(event.clientX - down[0]!, event.clientY - down[1]!) > 4) return;
      const ray = rayAt(event, this.canvas, this.eye.camera);
      if (this.mesh && this.surface) this.onPick(pick(this.mesh, this.surface, ray));
    });
    this.canvas.addEventListener('pointermove', (event) => {
      if (!this.onSurface || !this.surface || event.buttons !== 0) return;
      this.onSurface(hitSurface(this.surface, rayAt(event, this.canvas, this.eye.camera)));
    });
  }

  /** Points that can be dragged in this view. */
  addHandles(): Handles {
    const handles = new Handles({ canvas: this.canvas, camera: this.eye.camera, draw: () => this.draw() });
    this.scene.add(handles.group);
    return handles;
  }

  palette(): Palette {
    return this.colors;
  }

  private rebuild(): void {
    if (!this.mesh || !this.surface) return;
    clear(this.content);
    this.holeLabels = [];
    const corners = new THREE.BufferAttribute(this.surface.positions, 3);
    if (!this.options.wireframe) this.addSurface(this.surface, corners);
    if (this.options.edges) this.addLines(corners, this.colors.line, linesOf(this.mesh));
    for (const { points, color } of this.lines) {
      this.addLines(new THREE.BufferAttribute(points, 3), this.colors[color]);
    }
    if (this.options.arrows && !this.vertexColors) this.addArrows();
    this.addNormalLines();
    this.rebuildOverlay();
  }

  private rebuildOverlay(): void {
    if (!this.mesh) return;
    clear(this.overlay);
    this.labels = [...this.holeLabels];
    this.addSelection(this.picked);
    this.addSelection(this.selected);
    this.addArcs();
    this.addWorst();
    for (const { points, color } of this.curves) {
      if (points.length > 1) this.overlay.add(tube(points, 0.006 * this.eye.ball.radius, this.colors[color]));
    }
    if (this.options.ids) this.labels.unshift(...idLabels(this.mesh, this.maker!, this.idKinds(), this.selected));
    this.draw();
  }

  private idKinds(): ('f' | 'h' | 'e' | 'v')[] {
    const { edgeIds } = this.options;
    return ['f', ...(this.vertexColors ? [] : ['h' as const]), ...(edgeIds ? ['e' as const] : []), 'v'];
  }

  private addWorst(): void {
    for (const index of this.marks.vertices ?? []) {
      const at = this.mesh!.position(index);
      this.overlay.add(ball(at, this.eye.ball.radius * 0.02, this.colors.wrong));
      this.labels.push({ text: nameOf({ kind: 'v', index }), at, normal: [0, 0, 0], style: 'wrong' });
    }
  }

  private addSurface(surface: Surface, positions: THREE.BufferAttribute): void {
    if (this.vertexColors) {
      this.content.add(colouredObject(surface, positions, this.vertexColors, this.colors.wrong));
      return;
    }
    const normals = this.options.smooth ? this.normals : null;
    this.content.add(surfaceObject(surface, positions, normals, this.colors.front, this.colors.back));
  }

  /** Lines between each two points, or between those that `ends` numbers. */
  private addLines(points: THREE.BufferAttribute, color: string, ends: Uint32Array | null = null): void {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', points);
    if (ends) geometry.setIndex(new THREE.BufferAttribute(ends, 1));
    const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color }));
    lines.userData = { detail: true, edges: ends !== null };
    this.content.add(lines);
  }

  /** Half-edges that say they lie in a face whose walk does not close: it is open. */
  private addHoles(): Set<number> {
    const rim = new Set<number>();
    for (const walk of this.mesh!.faces()) {
      if (walk.closed) continue;
      const own = walk.halfedges.filter((h) => sameElement(this.mesh!.face(h), walk.face));
      own.forEach((h) => rim.add(h));
      const plane = this.maker!.plane(walk.face);
      if (!plane || this.holeLabels.length >= MOST_CALLOUTS) continue;
      const text = `${nameOf(walk.face)} is open`;
      this.holeLabels.push({ text, at: plane.centre, normal: [0, 0, 0], style: 'wrong' });
    }
    return rim;
  }

  private arrowOf(h: number, grow = 1): Vec[] {
    const arrow = h < 0 ? null : this.maker!.make(h);
    return arrow ? arrowTriangles(arrow, grow) : [];
  }

  /** Each half-edge once: at the rim of an open face, changed by the step, or plain. */
  private addArrows(): void {
    const mesh = this.mesh!;
    const rim = this.addHoles();
    if (mesh.halfedgeCount > MOST_ARROWS) return;
    const plain: Vec[] = [];
    const changed: Vec[] = [];
    const open: Vec[] = [];
    for (let h = 0; h < mesh.halfedgeCount; ++h) {
      const list = rim.has(h) ? open : this.marks.changed.has(`h${h}`) ? changed : plain;
      list.push(...this.arrowOf(h));
    }
    this.addTriangles(plain, this.colors.arrow);
    this.addTriangles(changed, this.colors.changed);
    this.addTriangles(open, this.colors.wrong);
  }

  private addTriangles(points: Vec[], color: string, onTop = false): void {
    if (points.length > 0) (onTop ? this.overlay : this.content).add(flatTriangles(points, color, onTop));
  }

  /** The selected element, with the next and the twin of a half-edge. */
  private addSelection(element: Element | null): void {
    const mesh = this.mesh!;
    if (!element || !mesh.isLive(element)) return;
    const place = placeOf(mesh, this.maker!, element);
    if (place) {
      this.labels.push({ text: nameOf(element), at: place.centre, normal: [0, 0, 0], style: 'selected' });
    }
    const { selected, next, twin } = this.colors;
    if (element.kind === 'h') {
      this.addTriangles(this.arrowOf(mesh.twin(element.index), 1.6), twin, true);
      this.addTriangles(this.arrowOf(mesh.next(element.index), 1.6), next, true);
      this.addTriangles(this.arrowOf(element.index, 1.9), selected, true);
    } else if (element.kind === 'v') {
      this.overlay.add(ball(mesh.position(element.index), this.eye.ball.radius * 0.03, selected));
    } else if (element.kind === 'e') {
      const h = mesh.halfedge(element);
      const [a, b] = [mesh.vertex(h), mesh.end(h)];
      if (a >= 0 && b >= 0) {
        this.overlay.add(tube([mesh.position(a), mesh.position(b)], 0.009 * this.eye.ball.radius, selected));
      }
    } else {
      for (const h of mesh.walk(element).halfedges) {
        this.addTriangles(this.arrowOf(h, 1.6), selected, true);
      }
    }
  }

  /** A wrong pointer is an arc from its element to where it really leads. */
  private addArcs(): void {
    for (const arc of this.marks.arcs.slice(0, MOST_CALLOUTS)) {
      const from = placeOf(this.mesh!, this.maker!, arc.element);
      if (!from) continue;
      if (arc.element.kind === 'h') {
        this.addTriangles(this.arrowOf(arc.element.index, 1.6), this.colors.wrong, true);
      }
      const outward = unit(sub(from.centre, this.eye.ball.centre));
      const to = arc.target && placeOf(this.mesh!, this.maker!, arc.target);
      const end: Vec = to ? to.centre : add(from.centre, scale(outward, 0.5 * this.eye.ball.radius));
      const { objects, apex } = arcObjects(from.centre, end, outward, this.eye.ball.radius, this.colors.wrong);
      this.overlay.add(...objects);
      this.labels.push({ text: arc.text, at: to ? apex : end, normal: [0, 0, 0], style: 'wrong' });
    }
  }

  private addNormalLines(): void {
    if (!this.options.normalLines || !this.normals) return;
    const points: number[] = [];
    for (let v = 0; v < this.mesh!.vertexCount; ++v) {
      if (!this.mesh!.isLive({ kind: 'v', index: v })) continue;
      const at = this.mesh!.position(v);
      const normal = [0, 1, 2].map((axis) => this.normals![3 * v + axis]!) as Vec;
      if (!normal.every(Number.isFinite)) continue;
      points.push(...at, ...add(at, scale(normal, 0.15 * this.eye.ball.radius)));
    }
    this.addLines(new THREE.BufferAttribute(Float32Array.from(points), 3), this.colors.twin);
  }
}
