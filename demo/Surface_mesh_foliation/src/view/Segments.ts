// Thin lines with a color for each: leaves and edge values.
import * as THREE from 'three';
import type { Color } from '../palette';

export class Segments {
  readonly object: THREE.LineSegments;
  private readonly geometry = new THREE.BufferGeometry();

  constructor(opacity: number) {
    const material = new THREE.LineBasicMaterial({
      vertexColors: true,
      transparent: opacity < 1,
      opacity,
    });
    this.object = new THREE.LineSegments(this.geometry, material);
    this.object.frustumCulled = false;
    this.object.visible = false;
  }

  /** Points: those of segment i are 2i and 2i + 1. */
  show(points: Float32Array, colorOfSegment: (segment: number) => Color): void {
    const colors = new Float32Array(points.length);
    const linear = new THREE.Color();
    for (let segment = 0; 6 * segment < points.length; ++segment) {
      const [r, g, b] = colorOfSegment(segment);
      linear.setRGB(r, g, b, THREE.SRGBColorSpace);
      linear.toArray(colors, 6 * segment);
      linear.toArray(colors, 6 * segment + 3);
    }
    this.geometry.dispose();
    this.geometry.setAttribute('position', new THREE.BufferAttribute(points, 3));
    this.geometry.setAttribute('color', new THREE.BufferAttribute(colors, 3));
  }
}

/** The segments of polylines, whose i-th one has the points first[i] .. first[i + 1]. */
export function segmentsOf(
  points: ArrayLike<number>,
  first: ArrayLike<number>,
): { points: Float32Array; line: Uint32Array } {
  let count = 0;
  for (let i = 0; i + 1 < first.length; ++i) count += Math.max(0, first[i + 1] - first[i] - 1);
  const result = new Float32Array(6 * count);
  const line = new Uint32Array(count);
  let segment = 0;
  for (let i = 0; i + 1 < first.length; ++i)
    for (let j = first[i]; j + 1 < first[i + 1]; ++j, ++segment) {
      line[segment] = i;
      for (let k = 0; k < 6; ++k) result[6 * segment + k] = points[3 * j + k];
    }
  return { points: result, line };
}
