import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PART_COLORS, classColor, classesApart, rampColor } from '../../src/palette';
import type { Color } from '../../src/palette';

// Machado, Oliveira and Fernandes (2009), full deficiency, for linear light
const DEFICIENCIES: Record<string, number[][]> = {
  none: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protan: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deutan: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  tritan: [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};

function linear(channel: number): number {
  return channel <= 0.04045 ? channel / 12.92 : ((channel + 0.055) / 1.055) ** 2.4;
}

/** CIE Lab, of what an eye sees. */
function seen(color: Color, deficiency: number[][]): number[] {
  const light = color.map(linear);
  const rgb = deficiency.map((row) =>
    Math.min(1, Math.max(0, row[0] * light[0] + row[1] * light[1] + row[2] * light[2])),
  );
  const x = (0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.9505;
  const y = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
  const z = (0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.089;
  const f = (t: number) => (t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16 / 116);
  return [116 * f(y) - 16, 500 * (f(x) - f(y)), 200 * (f(y) - f(z))];
}

function difference(a: number[], b: number[]): number {
  return Math.hypot(...a.map((value, i) => value - b[i]));
}

for (const [name, deficiency] of Object.entries(DEFICIENCIES)) {
  test(`the colors of parts stay apart: ${name}`, () => {
    const colors = PART_COLORS.map((color) => seen(color, deficiency));
    colors.forEach((a, i) =>
      colors.slice(0, i).forEach((b, j) => {
        assert.ok(
          difference(a, b) > 10,
          `colors ${j} and ${i} differ by ${difference(a, b).toFixed(1)}`,
        );
      }),
    );
  });

  test(`numbers get lighter all the way: ${name}`, () => {
    const lightness = Array.from({ length: 21 }, (_, i) => seen(rampColor(i / 20), deficiency)[0]);
    lightness.slice(1).forEach((value, i) => assert.ok(value > lightness[i], `step ${i}`));
  });
}

test('the red-green pair that palettes must avoid would be noticed', () => {
  const red = seen([0.75, 0.35, 0.2], DEFICIENCIES.deutan);
  const green = seen([0.5, 0.5, 0.2], DEFICIENCIES.deutan);
  assert.ok(difference(red, green) < 10);
});

test('arcs that share a node have different colors as long as there are colors', () => {
  const star = Array.from({ length: 20 }, (_, i) => ({ source: 0, target: i + 1 }));
  const classes = classesApart(star);
  assert.equal(new Set(classes).size, 20);
  const colors = classes.map((k) =>
    classColor(k)
      .map((x) => x.toFixed(3))
      .join(),
  );
  assert.equal(new Set(colors).size, 20);
});

test('on a tree whose nodes have three arcs, seven colors suffice', () => {
  const arcs = Array.from({ length: 60 }, (_, i) => ({ source: i >> 1, target: i + 1 }));
  const classes = classesApart(arcs);
  arcs.forEach((a, i) =>
    arcs.slice(0, i).forEach((b, j) => {
      const areNeighbors = [a.source, a.target].some(
        (node) => node === b.source || node === b.target,
      );
      if (areNeighbors) assert.notEqual(classes[i], classes[j]);
    }),
  );
  assert.ok(Math.max(...classes) < PART_COLORS.length);
  assert.equal(new Set(classes).size, PART_COLORS.length);
});

test('more arcs at a node than colors are no error', () => {
  const star = Array.from({ length: 100 }, (_, i) => ({ source: 0, target: i + 1 }));
  assert.equal(classesApart(star).length, 100);
});
