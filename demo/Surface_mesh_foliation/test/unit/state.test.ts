import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as edits from '../../src/state';

const start = edits.initialState([
  { vertex: 1, height: 1 },
  { vertex: 2, height: 1 },
  { vertex: 3, height: 1 },
]);
const used = [{ vertices: [4, 5, 6], height: 1, found: true }];

test('edits of poles change one pole, and not the state before', () => {
  const before = JSON.stringify(start);
  assert.deepEqual(
    edits.addPole(start, 9).poles.map((p) => p.vertex),
    [1, 2, 3, 9],
  );
  assert.deepEqual(
    edits.movePole(start, 1, 9).poles.map((p) => p.vertex),
    [1, 9, 3],
  );
  assert.deepEqual(
    edits.removePole(start, 0).poles.map((p) => p.vertex),
    [2, 3],
  );
  assert.deepEqual(
    edits.setPoleHeight(start, 2, 0.5).poles.map((p) => p.height),
    [1, 1, 0.5],
  );
  assert.equal(JSON.stringify(start), before);
});

test('no vertex is a pole twice', () => {
  assert.equal(edits.addPole(start, 2), start);
  assert.equal(edits.movePole(start, 0, 2), start);
});

test('a loop that is drawn joins those that were found, which stay', () => {
  const next = edits.addLoop(start, used, [7, 8, 9]);
  assert.equal(next.mode, 'given');
  assert.deepEqual(next.loops, [...used, { vertices: [7, 8, 9], height: 1 }]);
  assert.deepEqual(edits.removeLoop(next, next.loops, 0).loops, [next.loops[1]]);
  assert.deepEqual(edits.setLoopHeight(start, used, 0, 2).loops, [{ ...used[0], height: 2 }]);
});

test('the detail slider leads back to the loops that the shape decides', () => {
  const next = edits.setDetail(edits.addLoop(start, used, [7, 8, 9]), 0.8);
  assert.deepEqual(next, { ...start, detail: 0.8 });
});

test('keys are equal if nothing differs that the engine looks at', () => {
  const key = edits.stateKey;
  assert.equal(key(start), key({ ...start, loops: used }));
  assert.notEqual(key(start), key({ ...start, detail: 0.9 }));
  const star = edits.setMode(start, 'star', used);
  assert.equal(key(star), key({ ...star, detail: 0.9 }));
  assert.notEqual(key(star), key(start));
  assert.notEqual(key(edits.withLoops(start, used)), key(edits.withLoops(start, [])));
  assert.notEqual(key(edits.setPoleHeight(start, 0, 2)), key(start));
});
