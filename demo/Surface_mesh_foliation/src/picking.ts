// What lies under the pointer: plain loops over arrays, some milliseconds for 200,000 triangles.

export interface Ray {
  origin: [number, number, number];
  direction: [number, number, number];
}

export interface Hit {
  triangle: number;
  distance: number; // in units of the direction
  corner: number; // the vertex of the triangle that is nearest
}

/** The first triangle that a ray meets, from either side. */
export function firstHit(
  positions: ArrayLike<number>,
  triangles: Uint32Array,
  ray: Ray,
): Hit | null {
  const [ox, oy, oz] = ray.origin;
  const [dx, dy, dz] = ray.direction;
  let triangle = -1;
  let distance = Infinity;
  let weights: [number, number] = [0, 0];
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t];
    const b = 3 * triangles[t + 1];
    const c = 3 * triangles[t + 2];
    const ax = positions[a];
    const ay = positions[a + 1];
    const az = positions[a + 2];
    const ux = positions[b] - ax;
    const uy = positions[b + 1] - ay;
    const uz = positions[b + 2] - az;
    const vx = positions[c] - ax;
    const vy = positions[c + 1] - ay;
    const vz = positions[c + 2] - az;
    // Moeller and Trumbore's test
    const px = dy * vz - dz * vy;
    const py = dz * vx - dx * vz;
    const pz = dx * vy - dy * vx;
    const determinant = ux * px + uy * py + uz * pz;
    if (determinant === 0) continue;
    const sx = ox - ax;
    const sy = oy - ay;
    const sz = oz - az;
    const wb = (sx * px + sy * py + sz * pz) / determinant;
    if (wb < 0 || wb > 1) continue;
    const qx = sy * uz - sz * uy;
    const qy = sz * ux - sx * uz;
    const qz = sx * uy - sy * ux;
    const wc = (dx * qx + dy * qy + dz * qz) / determinant;
    if (wc < 0 || wb + wc > 1) continue;
    const d = (vx * qx + vy * qy + vz * qz) / determinant;
    if (d <= 0 || d >= distance) continue;
    distance = d;
    triangle = t / 3;
    weights = [wb, wc];
  }
  if (triangle < 0) return null;
  return { triangle, distance, corner: nearestCorner(positions, triangles, triangle, weights) };
}

function nearestCorner(
  positions: ArrayLike<number>,
  triangles: Uint32Array,
  triangle: number,
  [wb, wc]: [number, number],
): number {
  const corners = [0, 1, 2].map((k) => triangles[3 * triangle + k]);
  const weights = [1 - wb - wc, wb, wc];
  const coordinate = (vertex: number, axis: number) => positions[3 * vertex + axis];
  const distances = corners.map((corner) =>
    [0, 1, 2].reduce((sum, axis) => {
      const point = corners.reduce((x, other, k) => x + weights[k] * coordinate(other, axis), 0);
      return sum + (point - coordinate(corner, axis)) ** 2;
    }, 0),
  );
  return corners[distances.indexOf(Math.min(...distances))];
}
