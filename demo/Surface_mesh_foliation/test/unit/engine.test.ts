import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Abandoned, Engine, ProblemError } from '../../src/engine';
import type { Loaded, State } from '../../src/protocol';
import { Mock_worker, problem, resultOf, tetrahedron } from './Mock_worker';

function state(vertex: number): State {
  return { mode: 'star', detail: 1, poles: [{ vertex, height: 1 }], loops: [] };
}

function makeEngine(): { engine: Engine; workers: Mock_worker[] } {
  const workers: Mock_worker[] = [];
  const engine = new Engine(() => {
    workers.push(new Mock_worker());
    return workers[workers.length - 1];
  });
  return { engine, workers };
}

async function loaded(engine: Engine, worker: Mock_worker): Promise<Loaded> {
  const file = { name: 'a.off', bytes: new ArrayBuffer(4), repair: false, fillOpenings: false };
  const answer = engine.load(file);
  worker.reply({ id: worker.sent[worker.sent.length - 1].id, ok: true, value: tetrahedron });
  return answer;
}

test('answers find their questions, in any order', async () => {
  const { engine, workers } = makeEngine();
  const poles = engine.findPoles();
  const leaves = engine.leaves(3);
  workers[0].reply({ id: 1, ok: true, value: 'leaves' });
  workers[0].reply({ id: 0, ok: true, value: 'poles' });
  assert.equal(await poles, 'poles');
  assert.equal(await leaves, 'leaves');
});

test('a problem is told as it is', async () => {
  const { engine, workers } = makeEngine();
  const solve = engine.solve(state(1));
  workers[0].reply({ id: 0, ok: false, problem: problem('pole 1 is no vertex') });
  await assert.rejects(
    solve,
    (error: ProblemError) => error.problem.message === 'pole 1 is no vertex',
  );
});

test('progress is passed on', () => {
  const { engine, workers } = makeEngine();
  const told: unknown[] = [];
  engine.onProgress = (progress) => told.push(progress);
  void engine.solve(state(1));
  workers[0].reply({ id: 0, progress: { stage: 'solving', fraction: 0.5 } });
  assert.deepEqual(told, [{ stage: 'solving', fraction: 0.5 }]);
});

test('of the solves that wait for a running one, only the newest is sent', async () => {
  const { engine, workers } = makeEngine();
  const first = engine.solve(state(1));
  const second = engine.solve(state(2));
  const third = engine.solve(state(3));
  assert.equal(workers[0].sent.length, 1);
  await assert.rejects(second, Abandoned);
  workers[0].reply({ id: 0, ok: true, value: resultOf(state(1)) });
  assert.equal((await first).state.poles[0].vertex, 1);
  assert.equal(workers[0].sent.length, 2);
  workers[0].reply({ id: 1, ok: true, value: resultOf(state(3)) });
  assert.equal((await third).state.poles[0].vertex, 3);
});

test('a solve that takes long is told of the newer one, which supersedes it', async () => {
  const setTimeout = globalThis.setTimeout; // the mock timers of node differ between versions
  let endWaiting = () => {};
  globalThis.setTimeout = ((call: () => void) => {
    endWaiting = call;
  }) as typeof globalThis.setTimeout;
  try {
    const { engine, workers } = makeEngine();
    const slow = engine.solve(state(1));
    const newer = engine.solve(state(2));
    assert.equal(workers[0].sent.length, 1);
    endWaiting();
    assert.equal(workers[0].sent.length, 2);
    workers[0].reply({ id: 0, ok: false, superseded: true });
    await assert.rejects(slow, Abandoned);
    workers[0].reply({ id: 1, ok: true, value: resultOf(state(2)) });
    assert.equal((await newer).state.poles[0].vertex, 2);
  } finally {
    globalThis.setTimeout = setTimeout;
  }
});

test('a sketch and a preview are shown at once, and after the preview what waits is sent', async () => {
  const { engine, workers } = makeEngine();
  const shown: unknown[] = [];
  const first = engine.solve(state(1), {
    onSketch: ({ partLabels }) => shown.push(...partLabels),
    onPreview: (result) => shown.push(result.state.poles[0].vertex),
  });
  const second = engine.solve(state(2));
  const sketch = { partLabels: Uint32Array.of(7, 8), ends: Uint32Array.of(0, 1) };
  workers[0].reply({ id: 0, sketch });
  assert.deepEqual(shown, [7, 8]);
  assert.equal(workers[0].sent.length, 1);
  workers[0].reply({ id: 0, preview: resultOf(state(1)) });
  assert.deepEqual(shown, [7, 8, 1]);
  assert.equal(workers[0].sent.length, 2);
  workers[0].reply({ id: 0, ok: false, superseded: true });
  await assert.rejects(first, Abandoned);
  workers[0].reply({ id: 1, ok: true, value: resultOf(state(2)) });
  assert.equal((await second).state.poles[0].vertex, 2);
});

test('after cancel the worker is a new one, which reads the mesh first', async () => {
  const { engine, workers } = makeEngine();
  await loaded(engine, workers[0]);
  const solve = engine.solve(state(1));
  engine.cancel();
  await assert.rejects(solve, Abandoned);
  assert.ok(workers[0].isTerminated);
  assert.ok(!engine.isBusy);
  const again = engine.solve(state(2));
  assert.deepEqual(workers[1].ops(), ['load']);
  workers[1].reply({ id: workers[1].sent[0].id, ok: true, value: tetrahedron });
  await new Promise(setImmediate);
  assert.deepEqual(workers[1].ops(), ['load', 'solve']);
  workers[1].reply({ id: workers[1].sent[1].id, ok: true, value: resultOf(state(2)) });
  assert.equal((await again).state.poles[0].vertex, 2);
});

test('an answer to what was canceled is ignored', async () => {
  const { engine, workers } = makeEngine();
  const solve = engine.solve(state(1));
  engine.cancel();
  workers[0].reply({ id: 0, ok: true, value: resultOf(state(1)) });
  await assert.rejects(solve, Abandoned);
});

test('a worker that dies is replaced, and the reason is told', async () => {
  const { engine, workers } = makeEngine();
  const solve = engine.solve(state(1));
  workers[0].fail('out of memory');
  await assert.rejects(solve, (error: ProblemError) => /out of memory/.test(error.problem.message));
  assert.equal(workers.length, 2);
});

test('a mesh that cannot be read leaves the one before', async () => {
  const { engine, workers } = makeEngine();
  await loaded(engine, workers[0]);
  const bad = engine.load({
    name: 'bad.off',
    bytes: new ArrayBuffer(4),
    repair: false,
    fillOpenings: false,
  });
  const { id } = workers[0].sent[workers[0].sent.length - 1];
  workers[0].reply({ id, ok: false, problem: problem('bad.off: no vertices') });
  await assert.rejects(bad, ProblemError);
  void engine.findPoles();
  const request = workers[0].sent[workers[0].sent.length - 1];
  assert.ok(request.op === 'load' && request.name === 'a.off');
});

test('the bytes stay with the page: the worker gets copies', async () => {
  const { engine, workers } = makeEngine();
  const bytes = new Uint8Array([1, 2, 3]).buffer;
  void engine.load({ name: 'a.off', bytes, repair: false, fillOpenings: false });
  const request = workers[0].sent[0];
  assert.ok(request.op === 'load' && request.bytes !== bytes);
  assert.equal(bytes.byteLength, 3);
});

test('solving ahead keeps nobody waiting', async () => {
  const { engine, workers } = makeEngine();
  const told: boolean[] = [];
  engine.onBusy = (isBusy) => told.push(isBusy);
  const ahead = engine.solveAhead(state(1));
  assert.ok(!engine.isBusy);
  const solve = engine.solve(state(2));
  assert.deepEqual(workers[0].ops().slice(-2), ['solveAhead', 'solve']); // sent at once
  workers[0].reply({ id: 0, ok: false, superseded: true });
  await assert.rejects(ahead, Abandoned);
  assert.ok(engine.isBusy);
  workers[0].reply({ id: 1, ok: true, value: resultOf(state(2)) });
  assert.equal((await solve).state.poles[0].vertex, 2);
  assert.deepEqual(told, [true, false]);
});
