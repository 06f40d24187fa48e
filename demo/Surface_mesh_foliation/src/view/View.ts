// The picture: what is shown, the camera, and what lies under a point of it.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { arcColors, partColors } from '../coloring';
import { PLAIN_COLOR, mix, parseColor, rampColor } from '../palette';
import type { Color } from '../palette';
import { firstHit } from '../picking';
import type { Hit, Ray } from '../picking';
import type { Leaves, Loaded, Result, Sketch, State } from '../protocol';
import { boxOf, fittingDistance, firstDirection, orbit } from './frame';
import { FIRST_LAYERS } from './layers';
import type { Layers } from './layers';
import { Markers } from './Markers';
import type { Marker } from './Markers';
import { Painter } from './Painter';
import { Segments, segmentsOf } from './Segments';
import { Surface } from './Surface';
import { Thick_lines } from './Thick_lines';
import { tubes } from './tube';

/** Colors of the picture that depend on the theme. */
export interface Ink {
  background: Color;
  line: Color; // of the skeleton
  rim: Color;
  pole: Color;
  accent: Color; // what is selected or being drawn
  fault: Color;
}

export interface ScreenPoint {
  x: number; // pixels from the left and upper border of the picture
  y: number;
}

export class View {
  private readonly painter: Painter;
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
  private controls: OrbitControls;
  private readonly surface = new Surface();
  private readonly tubes = new Surface();
  private readonly leaves = new Segments(0.75);
  private readonly edges = new Segments(1);
  private readonly skeleton: Thick_lines;
  private readonly loops: Thick_lines;
  private readonly draft: Thick_lines;
  private readonly markers: Markers;
  private readonly innerMarkers: Markers;

  private loaded: Loaded | null = null;
  private result: Result | null = null;
  private state: State | null = null;
  private layers: Layers = { ...FIRST_LAYERS };
  private highlighted: number | null = null;
  private selectedPole: number | null = null;
  private draftVertices: number[] = [];
  private faults: number[] = [];
  private readonly reasonsForLoops = new Set<string>();
  private radius = 1;

  /** Throws if there is no WebGL. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private ink: Ink,
  ) {
    this.painter = new Painter(canvas, this.scene, this.camera);
    this.controls = this.newControls();
    const style = { color: ink.line, rim: ink.rim };
    this.skeleton = new Thick_lines({ ...style, width: 3.5, isOnTop: true }, 4);
    this.loops = new Thick_lines({ ...style, width: 3, isOnTop: false }, 2);
    this.draft = new Thick_lines({ ...style, color: ink.accent, width: 4, isOnTop: false }, 3);
    this.markers = new Markers(6, 0.25);
    this.innerMarkers = new Markers(5, 1);
    this.painter.onRatio = (ratio) => {
      for (const markers of [this.markers, this.innerMarkers]) markers.setPixelRatio(ratio);
    };
    this.scene.add(
      this.surface.mesh,
      this.tubes.mesh,
      this.leaves.object,
      this.edges.object,
      this.skeleton.object,
      this.loops.object,
      this.draft.object,
      this.markers.object,
      this.innerMarkers.object,
    );
    this.surface.mesh.visible = false;
    this.tubes.mesh.visible = false;
    this.addLights();
    this.setInk(ink);
    canvas.addEventListener('pointerdown', () => this.painter.prepare());
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement!);
    this.resize();
  }

  setInk(ink: Ink): void {
    this.ink = ink;
    this.scene.background = new THREE.Color().setRGB(...ink.background, THREE.SRGBColorSpace);
    this.skeleton.setColors(ink.line, ink.rim);
    this.loops.setColors(ink.line, ink.rim);
    this.draft.setColors(ink.accent, ink.rim);
    this.showMarkers();
    this.draw();
  }

  showMesh(loaded: Loaded): void {
    this.loaded = loaded;
    this.result = null;
    this.state = null;
    this.clearDraft();
    this.surface.setBody(loaded.positions, loaded.triangles, loaded.numberOfEdges);
    this.surface.show(loaded.positions, loaded.triangles, null);
    this.surface.setColors([PLAIN_COLOR]);
    this.frame();
    this.refresh();
  }

  /** Until the result is there, its parts are shown nearly as they will be; the rest is the old. */
  showSketch({ partLabels, ends }: Sketch): void {
    const { loaded, layers } = this;
    if (!loaded || !this.surface.mesh.visible) return;
    if (layers.coloring !== 'parts' || layers.edgeValues) return;
    const arcs = Array.from({ length: ends.length / 2 }, (_, arc) => ({
      source: ends[2 * arc],
      target: ends[2 * arc + 1],
    }));
    this.surface.show(loaded.positions, loaded.triangles, partLabels);
    this.surface.setColors(partColors(arcs));
    this.draw();
  }

  showResult(result: Result | null): void {
    this.result = result;
    this.highlighted = null;
    if (!result) return;
    this.surface.show(result.partPositions, result.partTriangles, result.partLabels);
    this.showSkeleton(result);
    this.showTubes();
    this.showEdgeValues();
    this.leaves.object.visible = false; // until those of this result are there
    this.refresh();
  }

  showState(state: State): void {
    this.state = state;
    this.showMarkers();
    this.painter.drawSoon(); // a sketch of the parts comes soon, too
  }

  showLeaves(leaves: Leaves): void {
    const { points, line } = segmentsOf(leaves.points, leaves.first);
    const colors = this.result ? arcColors(this.result, this.layers.coloring) : [];
    this.leaves.show(points, (i) =>
      mix(colors[leaves.arc[line[i]]] ?? PLAIN_COLOR, [0, 0, 0], 0.55),
    );
    this.leaves.object.visible = this.layers.leaves;
    this.draw();
  }

  /** Loops are shown in any case while the detail slider moves, or one is drawn. */
  forceLoops(reason: 'slider' | 'drawing', areForced: boolean): void {
    if (areForced) this.reasonsForLoops.add(reason);
    else this.reasonsForLoops.delete(reason);
    this.loops.object.visible = this.areLoopsShown;
    this.draw();
  }

  /** Closed walks along edges. */
  showLoops(walks: number[][]): void {
    this.loops.show(this.walkSegments(walks.map((walk) => [...walk, walk[0]])));
    this.draw();
  }

  /** The loop that is being drawn: its path so far, the picked vertices, and what is in its way. */
  showDraft(path: number[], picked: number[], faults: number[]): void {
    this.draft.show(this.walkSegments([path]));
    this.draft.object.visible = path.length > 1;
    this.draftVertices = picked;
    this.faults = faults;
    this.showMarkers();
    this.draw();
  }

  clearDraft(): void {
    this.showDraft([], [], []);
  }

  showFaults(vertices: number[]): void {
    this.faults = vertices;
    this.showMarkers();
    this.painter.drawSoon();
  }

  setLayers(layers: Layers): void {
    const before = this.layers;
    this.layers = layers;
    if (layers.radius && !before.radius) this.showTubes();
    if (layers.edgeValues && !before.edgeValues) this.showEdgeValues();
    this.refresh();
  }

  highlight(arc: number | null): void {
    if (arc === this.highlighted) return;
    this.highlighted = arc;
    this.color();
    this.draw();
  }

  selectPole(index: number | null): void {
    this.selectedPole = index;
    this.showMarkers();
    this.draw();
  }

  /** The camera is turned by the pointer, unless that drags something. */
  set isTurnedByPointer(isTurned: boolean) {
    this.controls.enabled = isTurned;
  }

  turn(right: number, up: number): void {
    orbit(this.camera, this.controls.target, right, up);
    this.controls.update();
    this.draw();
  }

  zoom(factor: number): void {
    const { target } = this.controls;
    this.camera.position.sub(target).divideScalar(factor).add(target);
    this.controls.update();
    this.draw();
  }

  /** Shows the whole mesh, from where it was seen first. */
  frame(): void {
    if (!this.loaded) return;
    const box = boxOf(this.loaded.positions);
    const center = box.getCenter(new THREE.Vector3());
    this.radius = box.getSize(new THREE.Vector3()).length() / 2 || 1;
    const { direction, up } = firstDirection(box);
    const isSmall = this.canvas.clientHeight < 500; // then buttons cover more of it
    const distance = (isSmall ? 1.15 : 0.92) * fittingDistance(this.radius, this.camera);
    if (isSmall) center.addScaledVector(up, 0.13 * this.radius); // the shape is lower
    this.camera.up.copy(up);
    this.camera.position.copy(center).addScaledVector(direction, distance);
    this.camera.near = this.radius / 100;
    this.camera.far = 100 * this.radius;
    this.camera.updateProjectionMatrix();
    this.resetControls(center);
    this.draw();
  }

  vertexAt(point: ScreenPoint): number | null {
    const { loaded } = this;
    return (loaded && this.hit(loaded.positions, loaded.triangles, point)?.corner) ?? null;
  }

  arcAt(point: ScreenPoint): number | null {
    const { result } = this;
    const hit = result && this.hit(result.partPositions, result.partTriangles, point);
    return hit ? result.partLabels[hit.triangle] : null;
  }

  /** The pole whose marker lies there and is not hidden by the surface, or null. */
  poleAt(point: ScreenPoint, reach: number): number | null {
    let best: number | null = null;
    let least = reach;
    this.state?.poles.forEach((pole, i) => {
      const { x, y } = this.screenPosition(pole.vertex);
      const distance = Math.hypot(x - point.x, y - point.y);
      if (distance < least && this.isVisible(pole.vertex)) {
        least = distance;
        best = i;
      }
    });
    return best;
  }

  screenPosition(vertex: number): ScreenPoint {
    const p = this.position(vertex).project(this.camera);
    return {
      x: ((p.x + 1) / 2) * this.canvas.clientWidth,
      y: ((1 - p.y) / 2) * this.canvas.clientHeight,
    };
  }

  isVisible(vertex: number): boolean {
    const { loaded } = this;
    if (!loaded) return false;
    const position = this.position(vertex);
    const toEye = this.camera.position.clone().sub(position);
    const start = position.addScaledVector(toEye, 1e-3);
    const ray: Ray = { origin: start.toArray(), direction: toEye.toArray() };
    const hit = firstHit(loaded.positions, loaded.triangles, ray);
    return hit === null || hit.distance > 1;
  }

  get center(): ScreenPoint {
    return { x: this.canvas.clientWidth / 2, y: this.canvas.clientHeight / 2 };
  }

  picture(): Promise<Blob> {
    return this.painter.picture();
  }

  private addLights(): void {
    // the lights move with the camera, so that what is looked at is lit
    const sun = new THREE.DirectionalLight(0xffffff, 1.7);
    sun.position.set(-0.6, 0.8, 1);
    this.camera.add(sun, sun.target);
    this.scene.add(this.camera, new THREE.HemisphereLight(0xffffff, 0xb0b0b8, 1.9));
  }

  private newControls(): OrbitControls {
    const controls = new OrbitControls(this.camera, this.canvas);
    controls.addEventListener('change', () => this.draw());
    return controls;
  }

  /** Controls learn the direction upward when they are made. */
  private resetControls(target: THREE.Vector3): void {
    this.controls.dispose();
    this.controls = this.newControls();
    this.controls.target.copy(target);
    this.controls.minDistance = this.radius / 50;
    this.controls.maxDistance = 20 * this.radius;
    this.controls.update();
  }

  private position(vertex: number): THREE.Vector3 {
    return new THREE.Vector3().fromArray(this.loaded!.positions, 3 * vertex);
  }

  private hit(positions: Float64Array, triangles: Uint32Array, point: ScreenPoint): Hit | null {
    const x = (2 * point.x) / this.canvas.clientWidth - 1;
    const y = 1 - (2 * point.y) / this.canvas.clientHeight;
    const origin = this.camera.position;
    const direction = new THREE.Vector3(x, y, 0.5).unproject(this.camera).sub(origin).normalize();
    return firstHit(positions, triangles, {
      origin: origin.toArray(),
      direction: direction.toArray(),
    });
  }

  private walkSegments(walks: number[][]): Float32Array {
    const points: number[] = [];
    const first = [0];
    for (const walk of walks) {
      for (const vertex of walk) points.push(...this.position(vertex).toArray());
      first.push(points.length / 3);
    }
    return segmentsOf(points, first).points;
  }

  private showSkeleton(result: Result): void {
    const points = result.skeleton.flatMap((line) => Array.from(line.points));
    const first = [0];
    for (const line of result.skeleton)
      first.push(first[first.length - 1] + line.points.length / 3);
    this.skeleton.show(segmentsOf(points, first).points);
  }

  private showTubes(): void {
    if (!this.result || !this.layers.radius) return;
    const { positions, triangles, labels } = tubes(this.result.skeleton);
    this.tubes.show(positions, triangles, labels);
  }

  private showEdgeValues(): void {
    const { loaded, result } = this;
    if (!loaded || !result || !this.layers.edgeValues) return;
    const points = new Float32Array(3 * loaded.edges.length);
    loaded.edges.forEach((vertex, i) => {
      for (let k = 0; k < 3; ++k) points[3 * i + k] = loaded.positions[3 * vertex + k];
    });
    const largest = result.edgeValues.reduce((most, value) => Math.max(most, value), 0) || 1;
    this.edges.show(points, (i) => rampColor(Math.sqrt(result.edgeValues[i] / largest)));
  }

  private refresh(): void {
    const { layers, result } = this;
    const isThere = result !== null;
    this.surface.mesh.visible =
      this.loaded !== null && (layers.surface || !isThere) && !(isThere && layers.radius);
    this.tubes.mesh.visible = isThere && layers.radius;
    this.leaves.object.visible = isThere && layers.leaves;
    this.edges.object.visible = isThere && layers.edgeValues;
    this.skeleton.object.visible = isThere && layers.skeleton;
    this.loops.object.visible = this.areLoopsShown;
    this.color();
    this.showMarkers();
    this.draw();
  }

  private get areLoopsShown(): boolean {
    return this.result !== null && (this.layers.loops || this.reasonsForLoops.size > 0);
  }

  private color(): void {
    if (!this.result) return;
    const plain = this.layers.edgeValues ? 'plain' : this.layers.coloring;
    const colors = arcColors(this.result, plain).map((color, arc) => {
      if (this.highlighted === null) return color;
      return arc === this.highlighted ? color : mix(color, this.ink.background, 0.6);
    });
    this.surface.setColors(colors);
    this.tubes.setColors(colors);
  }

  private showMarkers(): void {
    this.markers.show(
      this.loaded ? [...this.poleMarkers(), ...this.singularMarkers(), ...this.draftMarkers()] : [],
    );
    this.innerMarkers.show(this.nodeMarkers());
  }

  private poleMarkers(): Marker[] {
    if (!this.state || !this.layers.poles) return [];
    return this.state.poles.map(({ vertex }, i) => ({
      point: this.position(vertex).toArray(),
      shape: 'disk',
      size: i === this.selectedPole ? 17 : 12,
      color: i === this.selectedPole ? this.ink.accent : this.ink.pole,
      rim: [1, 1, 1],
    }));
  }

  private nodeMarkers(): Marker[] {
    if (!this.result || !this.layers.nodes) return [];
    return this.result.nodes
      .filter((node) => node.kind !== 'pole')
      .map(({ point }) => ({
        point,
        shape: 'disk',
        size: 10,
        color: this.ink.rim,
        rim: this.ink.line,
      }));
  }

  private singularMarkers(): Marker[] {
    if (!this.result || !this.layers.singularities) return [];
    return this.result.singularities.map(({ point, index }) => ({
      point,
      shape: index > 0 ? 'square' : 'diamond',
      size: index > 0 ? 8 : 10,
      color: index > 0 ? parseColor('#0072b2') : parseColor('#d55e00'),
      rim: [1, 1, 1],
    }));
  }

  private draftMarkers(): Marker[] {
    const marker = (vertex: number, color: Color, size: number): Marker => ({
      point: this.position(vertex).toArray(),
      shape: 'disk',
      size,
      color,
      rim: [1, 1, 1],
    });
    return [
      ...this.draftVertices.map((vertex, i) => marker(vertex, this.ink.accent, i === 0 ? 14 : 9)),
      ...this.faults.map((vertex) => marker(vertex, this.ink.fault, 13)),
    ];
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas.parentElement!;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.painter.setSize(clientWidth, clientHeight);
  }

  private draw(): void {
    this.painter.draw();
  }
}
