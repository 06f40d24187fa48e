import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { firstDirection, fittingDistance } from '../../src/view/frame';
import { segmentsOf } from '../../src/view/Segments';
import { verticesByPart } from '../../src/view/Surface';
import { tubes } from '../../src/view/tube';

test('polylines become segments', () => {
  const points = [0, 0, 0, 1, 0, 0, 2, 0, 0, 5, 5, 5, 6, 6, 6];
  const { points: segments, line } = segmentsOf(points, [0, 3, 3, 5]);
  assert.deepEqual([...line], [0, 0, 2]);
  assert.deepEqual([...segments.slice(6, 12)], [1, 0, 0, 2, 0, 0]);
  assert.deepEqual([...segments.slice(12)], [5, 5, 5, 6, 6, 6]);
});

test('the points of a tube are as far from its line as the radius says', () => {
  const points = Float64Array.from([0, 0, 0, 0, 0, 1, 0, 0, 2, 1, 0, 3]);
  const radii = Float64Array.from([0.1, 0.2, 0.3, 0]);
  const { positions, triangles, labels } = tubes([{ arc: 4, points, radii }]);
  const perRing = positions.length / 3 / 4;
  for (let i = 0; i < positions.length / 3; ++i) {
    const ring = Math.floor(i / perRing);
    const distance = Math.hypot(
      ...[0, 1, 2].map((k) => positions[3 * i + k] - points[3 * ring + k]),
    );
    assert.ok(Math.abs(distance - radii[ring]) < 1e-12);
  }
  assert.equal(triangles.length / 3, labels.length);
  assert.equal(labels.length, 2 * 3 * perRing);
  assert.ok([...labels].every((label) => label === 4));
  assert.equal(tubes([{ arc: 0, points: points.slice(0, 3), radii }]).labels.length, 0);
});

test('the camera looks along the shortest side, and the shape stands upright', () => {
  const box = (x: number, y: number, z: number) =>
    new THREE.Box3(new THREE.Vector3(), new THREE.Vector3(x, y, z));
  for (const [shape, axis] of [
    [box(2, 5, 1), 'z'],
    [box(1, 5, 2), 'x'],
    [box(2, 1, 5), 'y'],
  ] as const) {
    const { direction, up } = firstDirection(shape);
    assert.ok(Math.abs(direction[axis]) > 0.9);
    assert.ok(Math.abs(direction.dot(up)) < 0.3);
  }
});

test('a sphere fits into wide and narrow pictures', () => {
  for (const aspect of [0.4, 1, 2]) {
    const camera = new THREE.PerspectiveCamera(30, aspect, 0.1, 100);
    camera.position.set(0, 0, fittingDistance(1, camera));
    camera.updateMatrixWorld();
    const { x, y } = new THREE.Vector3(0.9, 0, 0).project(camera);
    assert.ok(Math.abs(x) < 1 && Math.abs(y) < 1);
    const top = new THREE.Vector3(0, 0.9, 0).project(camera);
    assert.ok(Math.abs(top.y) < 1);
  }
});

test('a vertex has a copy for each part that it belongs to', () => {
  const triangles = Uint32Array.from([0, 1, 2, 1, 3, 2, 3, 4, 2]);
  const { index, vertexOf, partOf } = verticesByPart(triangles, Uint32Array.from([5, 5, 7]), 5);
  assert.deepEqual(
    [...index].map((copy) => vertexOf[copy]),
    [...triangles],
  );
  assert.deepEqual(
    [...index].map((copy) => partOf[copy]),
    [5, 5, 5, 5, 5, 5, 7, 7, 7],
  );
  assert.equal(vertexOf.length, 7); // 2 and 3 lie in both parts
  assert.equal(new Set(vertexOf.map((vertex, i) => `${vertex},${partOf[i]}`)).size, 7);
});
