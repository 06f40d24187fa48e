import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Engine } from '../../src/engine';
import { Session } from '../../src/session';
import { addPole, movePole, removePole, setDetail } from '../../src/state';
import { Mock_worker, engineWith, resultOf } from './Mock_worker';

const POLES = [0, 1, 2].map((vertex) => ({ vertex, height: 1 }));
const AS_IT_IS = { repair: false, fillOpenings: false };

async function opened(
  refused = -1,
): Promise<{ session: Session; worker: Mock_worker; told: string[] }> {
  const worker = new Mock_worker();
  worker.automatic = engineWith(POLES, refused);
  const session = new Session(new Engine(() => worker));
  const told: string[] = [];
  session.problemMet.on(({ message }) => told.push(message));
  session.noticed.on((text) => told.push(text));
  await session.open('tetrahedron.off', new ArrayBuffer(4), AS_IT_IS, null);
  return { session, worker, told };
}

function solves(worker: Mock_worker): number {
  return worker.ops().filter((op) => op === 'solve').length;
}

test('a mesh that is opened gets its poles and its graph', async () => {
  const { session, worker } = await opened();
  assert.deepEqual(worker.ops().slice(0, 3), ['load', 'findPoles', 'solve']);
  assert.deepEqual(session.result!.state.poles, POLES);
  assert.equal(session.state!.mode, 'canonical');
});

test('an edit is solved, undone without the engine, and done again', async () => {
  const { session, worker } = await opened();
  await session.edit(addPole(session.state!, 3));
  assert.equal(session.result!.state.poles.length, 4);
  const before = solves(worker);
  await session.undo();
  assert.equal(session.result!.state.poles.length, 3);
  await session.redo();
  assert.equal(session.result!.state.poles.length, 4);
  assert.equal(solves(worker), before);
});

test('a refused edit is told and taken back', async () => {
  const { session, told } = await opened(3);
  assert.equal(await session.edit(addPole(session.state!, 3)), false);
  assert.deepEqual(told, ['vertex 3 is refused']);
  assert.equal(session.state!.poles.length, 3);
  assert.equal(session.result!.state.poles.length, 3);
  assert.ok(!session.canUndo && !session.canRedo);
});

test('a drag over a refused vertex goes on, and is one step', async () => {
  const { session, told } = await opened(3);
  await session.edit(movePole(session.state!, 0, 3), false);
  assert.deepEqual(told, ['vertex 3 is refused']);
  await session.edit(movePole(session.state!, 0, 7), true);
  assert.equal(session.result!.state.poles[0].vertex, 7);
  await session.undo();
  assert.equal(session.state!.poles[0].vertex, 0);
  assert.ok(!session.canUndo);
});

test('a drag that ends at a refused vertex leads back to where it began', async () => {
  const { session } = await opened(3);
  await session.edit(movePole(session.state!, 0, 7), false);
  await session.edit(movePole(session.state!, 0, 3), true);
  await new Promise(setImmediate);
  assert.equal(session.state!.poles[0].vertex, 0);
  assert.equal(session.result!.state.poles[0].vertex, 0);
});

test('a drag that ends where it was is not solved again', async () => {
  const { session, worker } = await opened();
  const before = solves(worker);
  const preview = session.edit(movePole(session.state!, 0, 7), false);
  const final = session.edit(session.state!, true);
  assert.deepEqual([await preview, await final], [true, true]);
  assert.equal(solves(worker), before + 1);
  assert.ok(session.canUndo);
});

test('an edit that changes nothing is no step', async () => {
  const { session, worker } = await opened();
  const before = solves(worker);
  await session.edit(addPole(session.state!, 0));
  assert.equal(solves(worker), before);
  assert.ok(!session.canUndo);
});

test('a preview is shown until the result is there, and is not kept', async () => {
  const { session, worker } = await opened();
  const provisional: boolean[] = [];
  session.resultChanged.on(() => provisional.push(session.isProvisional));
  const answer = engineWith(POLES);
  worker.automatic = (request) => {
    if (request.op !== 'solve') return answer(request);
    worker.reply({ id: request.id, preview: resultOf(request.state) });
    return answer(request);
  };
  await session.edit(addPole(session.state!, 3));
  await session.undo();
  await session.redo();
  assert.deepEqual(provisional, [true, false, false, false]);
});

test('files are those of what is shown, also after undo', async () => {
  const { session, worker } = await opened();
  await session.edit(removePole(session.state!, 0));
  await session.undo();
  await session.download('reeb_graph.dot');
  const last = worker.sent.slice(-2);
  assert.equal(last[1].op, 'download');
  assert.ok(last[0].op === 'solve' && last[0].state.poles.length === 3);
});

test('levels solved ahead are shown at once, and files are still those of what is shown', async () => {
  const { session, worker } = await opened();
  await session.solveAhead([0.9, 0.3]);
  assert.deepEqual(worker.ops().slice(-2), ['solveAhead', 'solveAhead']);
  assert.equal(session.result!.state.detail, session.state!.detail);
  await session.download('reeb_graph.dot');
  assert.deepEqual(worker.ops().slice(-2), ['solve', 'download']);
  const before = worker.sent.length;
  void session.edit(setDetail(session.state!, 0.3), false);
  assert.equal(session.result!.state.detail, 0.3); // without waiting
  await session.solveAhead([0.9, 0.3]);
  assert.equal(worker.sent.length, before);
});

test('an edit ends the solving ahead', async () => {
  const { session, worker } = await opened();
  const ahead = session.solveAhead([0.9, 0.3, 0.1]);
  await session.edit(addPole(session.state!, 3));
  await ahead;
  assert.equal(worker.ops().filter((op) => op === 'solveAhead').length, 1);
});

test('a huge mesh is refused before the engine gets it', async () => {
  const { session, worker, told } = await opened();
  const bytes = new TextEncoder().encode('OFF\n1000000 1999996 0\n').buffer as ArrayBuffer;
  const before = worker.sent.length;
  assert.equal(await session.open('scan.off', bytes, AS_IT_IS, null), false);
  assert.match(told[0], /1,000,000 vertices/);
  assert.equal(worker.sent.length, before);
  assert.equal(session.result!.state.poles.length, 3);
});

test('a link is applied to its mesh, and to no other', async () => {
  const state = { mode: 'star' as const, detail: 0.6, poles: POLES.slice(0, 2), loops: [] };
  const source = {
    kind: 'file' as const,
    name: 'other name.off',
    vertices: 4,
    faces: 4,
    options: '',
  };
  const { session, told } = await opened();
  session.expect({ source, state });
  await session.open('tetrahedron.off', new ArrayBuffer(4), AS_IT_IS, null);
  assert.deepEqual(session.state, state);
  session.expect({ source: { ...source, vertices: 5 }, state });
  await session.open('tetrahedron.off', new ArrayBuffer(4), AS_IT_IS, null);
  assert.equal(session.state!.mode, 'canonical');
  assert.match(told[told.length - 1], /not the mesh/);
});

test('cancel takes the step back that was being solved', async () => {
  const { session, worker } = await opened();
  worker.automatic = () => null;
  const edit = session.edit(addPole(session.state!, 3));
  session.cancel();
  assert.equal(await edit, false);
  assert.equal(session.state!.poles.length, 3);
});
