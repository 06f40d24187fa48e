import assert from 'node:assert/strict';
import { test } from 'node:test';
import { firstHit } from '../../src/picking';
import type { Ray } from '../../src/picking';

// two unit squares, at z = 0 and z = 1, of two triangles each
const positions = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1];
const triangles = new Uint32Array([0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7]);

function down(x: number, y: number, z = 3): Ray {
  return { origin: [x, y, z], direction: [0, 0, -1] };
}

test('the nearest triangle is hit', () => {
  const hit = firstHit(positions, triangles, down(0.8, 0.3))!;
  assert.equal(hit.triangle, 2);
  assert.ok(Math.abs(hit.distance - 2) < 1e-12);
  assert.equal(firstHit(positions, triangles, down(0.8, 0.3, 0.5))!.triangle, 0);
});

test('triangles are hit from behind, too', () => {
  const up: Ray = { origin: [0.2, 0.7, -1], direction: [0, 0, 1] };
  assert.equal(firstHit(positions, triangles, up)!.triangle, 1);
});

test('what lies beside or behind is not hit', () => {
  assert.equal(firstHit(positions, triangles, down(1.2, 0.3)), null);
  assert.equal(firstHit(positions, triangles, down(0.8, 0.3, -1)), null);
  assert.equal(firstHit([], new Uint32Array(0), down(0, 0)), null);
});

test('the corner is the nearest one', () => {
  assert.equal(firstHit(positions, triangles, down(0.1, 0.05))!.corner, 4);
  assert.equal(firstHit(positions, triangles, down(0.9, 0.1))!.corner, 5);
  assert.equal(firstHit(positions, triangles, down(0.9, 0.85))!.corner, 6);
  assert.equal(firstHit(positions, triangles, down(0.1, 0.9))!.corner, 7);
});

test('flat triangles are passed by', () => {
  assert.equal(
    firstHit([0, 0, 0, 1, 0, 0, 2, 0, 0], new Uint32Array([0, 1, 2]), down(0.5, 0)),
    null,
  );
});
