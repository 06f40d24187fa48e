import assert from 'node:assert/strict';
import { test } from 'node:test';
import { detailSteps, keptLoops, stepOf } from '../../src/detail_steps';
import type { HierarchyLoop } from '../../src/protocol';

function loopsOf(...moduli: number[]): HierarchyLoop[] {
  return moduli.map((modulus) => ({
    vertices: [],
    height: 1,
    modulus,
    margin: 1,
    separating: true,
    cutsHandle: false,
  }));
}

test('each step keeps more loops, from none to all', () => {
  const loops = loopsOf(2.1, 1.3, 0.7, 0.2);
  const steps = detailSteps(loops);
  assert.deepEqual(
    steps.map(({ kept }) => kept),
    [0, 1, 2, 3, 4],
  );
  for (const { detail, kept } of steps) assert.equal(keptLoops(loops, detail).length, kept);
});

test('loops of nearly equal moduli come together', () => {
  const loops = loopsOf(1.3, 1.3001, 0.7, 0.7);
  assert.deepEqual(
    detailSteps(loops).map(({ kept }) => kept),
    [0, 2, 4],
  );
});

test('any bound has its step', () => {
  const loops = loopsOf(2, 1, 0.5);
  const steps = detailSteps(loops);
  assert.deepEqual(
    [3, 2, 1.5, 1, 0.6, 0.5, 0].map((detail) => stepOf(steps, loops, detail)),
    [0, 1, 1, 2, 2, 3, 3],
  );
});

test('without loops there is one step', () => {
  assert.equal(detailSteps([]).length, 1);
  assert.equal(stepOf(detailSteps([]), [], 0.6), 0);
});

test('loops that handles need are always kept', () => {
  const loops = loopsOf(2, 0.1);
  loops[1].cutsHandle = true;
  assert.equal(keptLoops(loops, 1000).length, 1);
  assert.equal(keptLoops(loops, 1).length, 2);
});
