import assert from 'node:assert/strict';
import { test } from 'node:test';
import { LinkError, decodeLink, encodeLink, misfit } from '../../src/link';
import type { Link } from '../../src/link';
import type { State } from '../../src/protocol';

const canonical: State = {
  mode: 'canonical',
  detail: 0.71,
  poles: [
    { vertex: 51, height: 1 },
    { vertex: 4711, height: 0.5 },
  ],
  loops: [],
};

const given: State = {
  mode: 'given',
  detail: 0.6,
  poles: canonical.poles,
  loops: [
    { vertices: [1000, 3, 70000], height: 1 },
    { vertices: [5, 6, 7, 2, 1], height: 2.5, found: true },
  ],
};

test('a link of an example comes back as it was', () => {
  const link: Link = { source: { kind: 'example', name: 'homer' }, state: canonical };
  const text = encodeLink(link);
  assert.match(text, /^#[\w=&,.*~;-]+$/);
  assert.deepEqual(decodeLink(text), link);
});

test('a link of a file comes back as it was, with any name', () => {
  const source = {
    kind: 'file' as const,
    name: 'a & b=c #1.off',
    vertices: 12,
    faces: 20,
    options: 'repair',
  };
  const link: Link = { source, state: { ...given, detail: 0.6 } };
  assert.deepEqual(decodeLink(encodeLink(link)), link);
});

test('no poles and no loops come back as such', () => {
  const state: State = { mode: 'star', detail: 0.6, poles: [], loops: [] };
  const link: Link = { source: { kind: 'example', name: 'eight' }, state };
  assert.deepEqual(decodeLink(encodeLink(link)), link);
});

test('a page without fragment, or with another one, has no link', () => {
  assert.equal(decodeLink(''), null);
  assert.equal(decodeLink('#top'), null);
});

for (const damaged of [
  '#example=homer&mode=curved',
  '#example=homer&poles=1,x',
  '#example=homer&poles=-1',
  '#example=homer&poles=1*0',
  '#example=homer&poles=1*-2',
  '#example=homer&poles=1*',
  '#example=homer&detail=many',
  '#example=homer&mode=given&loops=1.!.3',
  '#example=homer&mode=given&loops=1.-9.3',
  '#file=a.off&poles=1',
  '#file=a.off&size=10&poles=1',
])
  test(`a damaged link is refused: ${damaged}`, () => {
    assert.throws(() => decodeLink(damaged), LinkError);
  });

test('a link that names vertices which the mesh does not have is refused', () => {
  assert.equal(misfit(canonical, 4712), null);
  assert.match(misfit(canonical, 4711)!, /vertex 4711/);
  assert.match(misfit(given, 70000)!, /vertex 70000/);
});
