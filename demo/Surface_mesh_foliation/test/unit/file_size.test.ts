import assert from 'node:assert/strict';
import { test } from 'node:test';
import { announcedVertices, tooLarge } from '../../src/file_size';

function bytes(text: string): ArrayBuffer {
  return new TextEncoder().encode(text).buffer as ArrayBuffer;
}

for (const [name, text, vertices] of [
  ['a.off', 'OFF\n1000000 1999996 0\n0 0 0\n', 1000000],
  ['a.off', 'OFF 12 20 30\n', 12],
  ['a.OFF', 'COFF\n# a comment 7 8 9\n\n12 20 0\n', 12],
  ['a.off', 'OFF BINARY\n12 20 0\n', 12],
  ['a.ply', 'ply\nformat ascii 1.0\nelement vertex 42\nproperty float x\n', 42],
  ['a.obj', 'v 0 0 0\n', null],
  ['a.off', 'nonsense', null],
  ['a.stl', 'solid x', null],
] as [string, string, number | null][])
  test(`the vertices that ${name} announces: ${vertices}`, () => {
    assert.equal(announcedVertices(name, bytes(text)), vertices);
  });

test('a binary STL file has half as many vertices as faces', () => {
  const file = new ArrayBuffer(84 + 50 * 8);
  new DataView(file).setUint32(80, 8, true);
  assert.equal(announcedVertices('a.stl', file), 4);
});

test('a mesh of a million vertices is refused with what to do', () => {
  assert.match(
    tooLarge('scan.off', bytes('OFF\n1000000 1999996 0\n'))!,
    /1,000,000 vertices.*Simplify/,
  );
  assert.equal(tooLarge('scan.off', bytes('OFF\n110000 219996 0\n')), null);
});
