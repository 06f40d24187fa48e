import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Later } from '../../src/later';

const wait = (milliseconds: number) =>
  new Promise((resolve) => setTimeout(resolve, milliseconds));

test('what can wait is done once, a moment later', async () => {
  let times = 0;
  const later = new Later(() => ++times);
  later.soon();
  later.soon();
  await wait(0);
  assert.equal(times, 0);
  await wait(200);
  assert.equal(times, 1);
  later.soon();
  await wait(200);
  assert.equal(times, 2);
});

test('what is done now is not done again later', async () => {
  let times = 0;
  const later = new Later(() => ++times);
  later.soon();
  later.now();
  assert.equal(times, 1);
  await wait(200);
  assert.equal(times, 1);
});
