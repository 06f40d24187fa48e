import assert from 'node:assert/strict';
import { test } from 'node:test';
import { forPeople } from '../../src/wording';

test('loops are counted from 1, and the one that is drawn is this loop', () => {
  assert.equal(forPeople('loop 0 and loop 12 intersect'), 'loop 1 and loop 13 intersect');
  assert.equal(forPeople('loop 0 and loop 2 intersect', 2), 'loop 1 and this loop intersect');
  assert.equal(forPeople('vertex 3 is no vertex'), 'vertex 3 is no vertex');
});
