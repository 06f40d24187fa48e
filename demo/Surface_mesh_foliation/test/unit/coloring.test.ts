import assert from 'node:assert/strict';
import { test } from 'node:test';
import { arcColors, legendOf, short } from '../../src/coloring';
import type { GraphArc, Result } from '../../src/protocol';
import { resultOf } from './Mock_worker';

function arc(id: number, symmetry: number, modulus: number | null): GraphArc {
  return {
    id,
    source: id,
    target: id + 1,
    component: 'cylinder',
    height: 1,
    flux: id + 1,
    area: 1,
    length: 1,
    modulus,
    margin: null,
    symmetry,
    pole: -1,
    loop: -1,
  };
}

const result: Result = {
  ...resultOf({ mode: 'star', detail: 1, poles: [], loops: [] }),
  arcs: [arc(0, 5, 2), arc(1, 7, null), arc(2, 5, 0.5)],
};

test('arcs that are alike have one color, and the legend names them', () => {
  const colors = arcColors(result, 'symmetry');
  assert.deepEqual(colors[0], colors[2]);
  assert.notDeepEqual(colors[0], colors[1]);
  assert.deepEqual(
    legendOf(result, 'symmetry').entries.map(({ label }) => label),
    ['1, 3', '2'],
  );
});

test('a larger modulus is lighter, and arcs without one are said to have none', () => {
  const sum = (color: number[]) => color.reduce((a, b) => a + b);
  const colors = arcColors(result, 'modulus');
  assert.ok(sum(colors[0]) > sum(colors[2]));
  const legend = legendOf(result, 'modulus');
  assert.deepEqual(legend.range, ['0.5', '2']);
  assert.equal(legend.entries.length, 1);
});

test('where no modulus is known, the legend says so', () => {
  const none = { ...result, arcs: [arc(0, 0, null)] };
  assert.match(legendOf(none, 'modulus').title, /none is known/);
  assert.equal(legendOf(none, 'modulus').range, null);
});

test('numbers for people', () => {
  assert.deepEqual([0, 1, 0.123456, 123456, 1e-5, 42.42].map(short), [
    '0',
    '1',
    '0.123',
    '1.2e+5',
    '1.0e-5',
    '42.4',
  ]);
});
