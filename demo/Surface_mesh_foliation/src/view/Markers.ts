// Disks, squares and diamonds of some pixels' size, at points of the surface or inside of it.
import * as THREE from 'three';
import type { Color } from '../palette';
import { liftTowardEye } from './lift';

export type Shape = 'disk' | 'square' | 'diamond';

export interface Marker {
  point: ArrayLike<number>;
  shape: Shape;
  size: number; // pixels
  color: Color;
  rim: Color;
}

const SHAPES: Shape[] = ['disk', 'square', 'diamond'];

const vertexShader = `
  attribute float size;
  attribute float shape;
  attribute vec3 fill;
  attribute vec3 rim;
  uniform float pixelRatio;
  varying float vShape;
  varying float vSize;
  varying vec3 vFill;
  varying vec3 vRim;
  void main() {
    vShape = shape;
    vSize = size;
    vFill = fill;
    vRim = rim;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    ${liftTowardEye(0.004)}
    gl_PointSize = (size + 4.0) * pixelRatio;
  }`;

const fragmentShader = `
  uniform float opacity;
  varying float vShape;
  varying float vSize;
  varying vec3 vFill;
  varying vec3 vRim;
  void main() {
    vec2 p = (gl_PointCoord - 0.5) * (vSize + 4.0);
    float d = vShape < 0.5 ? length(p)
            : vShape < 1.5 ? 1.15 * max(abs(p.x), abs(p.y))
            : 0.8 * (abs(p.x) + abs(p.y));
    float radius = 0.5 * vSize;
    float inside = 1.0 - smoothstep(radius + 0.5, radius + 1.5, d);
    float isFill = 1.0 - smoothstep(radius - 2.0, radius - 1.0, d);
    if (inside < 0.01) discard;
    gl_FragColor = vec4(mix(vRim, vFill, isFill), inside * opacity);
    #include <colorspace_fragment>
  }`;

export class Markers {
  readonly object = new THREE.Group();
  private readonly geometry = new THREE.BufferGeometry();
  private readonly pixelRatio = { value: 1 };

  /** A marker behind the surface is drawn with the opacity `behind`. */
  constructor(order: number, behind: number) {
    this.object.renderOrder = order;
    const passes = [
      { depthTest: false, opacity: behind },
      { depthTest: true, opacity: 1 },
    ].filter(({ opacity }) => opacity > 0);
    passes.forEach(({ depthTest, opacity }, i) => {
      const material = new THREE.ShaderMaterial({
        vertexShader,
        fragmentShader,
        transparent: true,
        depthTest,
        depthWrite: false,
        uniforms: {
          opacity: { value: opacity },
          pixelRatio: this.pixelRatio,
        },
      });
      const points = new THREE.Points(this.geometry, material);
      points.renderOrder = order + 0.1 * i;
      points.frustumCulled = false;
      this.object.add(points);
    });
  }

  /** Pixels of the canvas per pixel of the page. */
  setPixelRatio(ratio: number): void {
    this.pixelRatio.value = ratio;
  }

  show(markers: Marker[]): void {
    const attribute = (size: number, values: (marker: Marker) => ArrayLike<number>) =>
      new THREE.BufferAttribute(
        new Float32Array(markers.flatMap((m) => Array.from(values(m)))),
        size,
      );
    const linear = new THREE.Color();
    const color = (c: Color) => linear.setRGB(...c, THREE.SRGBColorSpace).toArray();
    this.geometry.dispose();
    this.geometry.setAttribute(
      'position',
      attribute(3, (m) => m.point),
    );
    this.geometry.setAttribute(
      'size',
      attribute(1, (m) => [m.size]),
    );
    this.geometry.setAttribute(
      'shape',
      attribute(1, (m) => [SHAPES.indexOf(m.shape)]),
    );
    this.geometry.setAttribute(
      'fill',
      attribute(3, (m) => color(m.color)),
    );
    this.geometry.setAttribute(
      'rim',
      attribute(3, (m) => color(m.rim)),
    );
    for (const points of this.object.children) points.visible = markers.length > 0;
  }
}
