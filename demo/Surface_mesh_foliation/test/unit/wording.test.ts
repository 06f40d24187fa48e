import assert from 'node:assert/strict';
import { test } from 'node:test';
import { asSentence, forPeople } from '../../src/wording';

test('loops are counted from 1, and the one that is drawn is this loop', () => {
  assert.equal(forPeople('loop 0 and loop 12 intersect'), 'loop 1 and loop 13 intersect');
  assert.equal(forPeople('loop 0 and loop 2 intersect', 2), 'loop 1 and this loop intersect');
  assert.equal(forPeople('vertex 3 is no vertex'), 'vertex 3 is no vertex');
});

test('messages become sentences', () => {
  assert.equal(asSentence('the loop is no loop'), 'The loop is no loop.');
  assert.equal(asSentence('bad.off, line 3: no number'), 'bad.off, line 3: no number.');
  assert.equal(asSentence('It is done.'), 'It is done.');
});
