// A tube around a polyline, as thick as its radii say.
import * as THREE from 'three';
import type { Polyline } from '../protocol';

const SIDES = 14;

export interface Triangles {
  positions: Float64Array;
  triangles: Uint32Array;
  labels: Uint32Array;
}

export function tubes(skeleton: Polyline[]): Triangles {
  const positions: number[] = [];
  const triangles: number[] = [];
  const labels: number[] = [];
  for (const line of skeleton) {
    const first = positions.length / 3;
    const rings = addRings(line, positions);
    for (let ring = 0; ring + 1 < rings; ++ring)
      for (let side = 0; side < SIDES; ++side) {
        const a = first + ring * SIDES + side;
        const b = first + ring * SIDES + ((side + 1) % SIDES);
        triangles.push(a, b, a + SIDES, b, b + SIDES, a + SIDES);
        labels.push(line.arc, line.arc);
      }
  }
  return {
    positions: Float64Array.from(positions),
    triangles: Uint32Array.from(triangles),
    labels: Uint32Array.from(labels),
  };
}

/** A ring at each point, perpendicular to the line, without twist; returns their number. */
function addRings({ points, radii }: Polyline, positions: number[]): number {
  const count = points.length / 3;
  if (count < 2) return 0;
  const at = (i: number) => new THREE.Vector3(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
  let side: THREE.Vector3 | null = null;
  for (let i = 0; i < count; ++i) {
    const along = at(Math.min(i + 1, count - 1)).sub(at(Math.max(i - 1, 0)));
    if (along.lengthSq() === 0) along.set(0, 0, 1);
    along.normalize();
    side = perpendicular(along, side);
    const other = new THREE.Vector3().crossVectors(along, side);
    for (let k = 0; k < SIDES; ++k) {
      const angle = (2 * Math.PI * k) / SIDES;
      const point = at(i)
        .addScaledVector(side, radii[i] * Math.cos(angle))
        .addScaledVector(other, radii[i] * Math.sin(angle));
      positions.push(point.x, point.y, point.z);
    }
  }
  return count;
}

/** A unit vector perpendicular to `along`, as near to the one before as can be. */
function perpendicular(along: THREE.Vector3, before: THREE.Vector3 | null): THREE.Vector3 {
  const start = before ?? new THREE.Vector3(1, 0, 0);
  const side = start.clone().addScaledVector(along, -start.dot(along));
  if (side.lengthSq() < 1e-6) {
    side.set(0, 1, 0).addScaledVector(along, -along.y);
    if (side.lengthSq() < 1e-6) side.set(0, 0, 1).addScaledVector(along, -along.z);
  }
  return side.normalize();
}
