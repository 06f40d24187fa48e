import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { Surface, enclosesBody } from '../../src/view/Surface';
import { tetrahedron } from './Mock_worker';

const { positions, triangles, numberOfEdges } = tetrahedron;
const insideOut = triangles.map((_, i) => triangles[i % 3 === 0 ? i : i % 3 === 1 ? i + 1 : i - 1]);

test('a body is closed and its triangles face outward', () => {
  assert.ok(enclosesBody(positions, triangles, numberOfEdges));
  assert.ok(!enclosesBody(positions, insideOut, numberOfEdges));
  assert.ok(!enclosesBody(positions, triangles.subarray(3), numberOfEdges));
  const farAway = positions.map((x) => x + 1e9);
  assert.ok(enclosesBody(farAway, triangles, numberOfEdges));
  assert.ok(!enclosesBody(farAway, insideOut, numberOfEdges));
});

function sideSeenFrom(surface: Surface, x: number): THREE.Side {
  const camera = new THREE.PerspectiveCamera(30, 1, 0.1, 100);
  camera.position.set(x, 0.2, 0.2);
  const { mesh } = surface;
  const material = mesh.material as THREE.Material;
  const nothing = null as never;
  mesh.onBeforeRender(nothing, nothing, camera, mesh.geometry, material, nothing);
  return material.side;
}

test('a body is drawn without its inner side for those who are well outside', () => {
  const surface = new Surface();
  assert.equal(sideSeenFrom(surface, 5), THREE.DoubleSide);
  surface.setBody(positions, triangles, numberOfEdges);
  assert.equal(sideSeenFrom(surface, 5), THREE.FrontSide);
  assert.equal(sideSeenFrom(surface, 0.2), THREE.DoubleSide);
  assert.equal(sideSeenFrom(surface, 1.15), THREE.DoubleSide); // it may be cut at the near plane
  assert.equal(sideSeenFrom(surface, 5), THREE.FrontSide);
  surface.setBody(positions, triangles.subarray(3), numberOfEdges);
  assert.equal(sideSeenFrom(surface, 5), THREE.DoubleSide);
});
