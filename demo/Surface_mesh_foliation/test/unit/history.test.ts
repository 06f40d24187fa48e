import assert from 'node:assert/strict';
import { test } from 'node:test';
import { History } from '../../src/history';

test('undo and redo walk along the steps', () => {
  const history = new History('a');
  history.commit('b');
  history.commit('c');
  assert.ok(history.undo());
  assert.equal(history.present, 'b');
  assert.ok(history.undo());
  assert.equal(history.present, 'a');
  assert.ok(!history.undo());
  assert.ok(history.redo());
  assert.ok(history.redo());
  assert.equal(history.present, 'c');
  assert.ok(!history.redo());
});

test('a new step forgets what was undone', () => {
  const history = new History('a');
  history.commit('b');
  history.undo();
  history.commit('c');
  assert.ok(!history.canRedo);
  history.undo();
  assert.equal(history.present, 'a');
});

test('a preview leaves one step, however often it changes', () => {
  const history = new History(0);
  for (let i = 1; i < 10; ++i) history.preview(i);
  assert.ok(history.isPreview);
  assert.ok(!history.canUndo);
  history.commit(10);
  assert.ok(history.undo());
  assert.equal(history.present, 0);
  assert.ok(!history.canUndo);
});

test('a preview can be given up, and undo gives it up', () => {
  const history = new History('a');
  history.commit('b');
  history.preview('c');
  history.revert();
  assert.equal(history.present, 'b');
  history.preview('c');
  history.undo();
  assert.equal(history.present, 'a');
  history.redo();
  assert.equal(history.present, 'b');
});

test('a dropped step cannot be redone', () => {
  const history = new History('a');
  history.commit('b');
  assert.ok(history.drop());
  assert.equal(history.present, 'a');
  assert.ok(!history.canRedo);
  assert.ok(!history.drop());
  assert.equal(history.present, 'a');
});
