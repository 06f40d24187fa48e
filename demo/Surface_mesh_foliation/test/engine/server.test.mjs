// The server of the worker: the order of replies, what is superseded, and what is left of it.
import assert from 'node:assert/strict';
import test from 'node:test';
import { pathToFileURL } from 'node:url';
import { canonicalState, loadEngine } from './load_engine.mjs';

const file = process.env.SERVER_MODULE;
assert.ok(file, 'SERVER_MODULE names what esbuild makes of Server.ts');
const { Server } = await import(pathToFileURL(file).href);

/** A ball with four bumps, as OFF: a grid of angles, closed by two poles. */
function bumpyBall(rings, segments) {
  const directions = [
    [1, 1, 1],
    [1, -1, -1],
    [-1, 1, -1],
    [-1, -1, 1],
  ];
  const blownUp = (p) => {
    const radius = directions.reduce((sum, d) => {
      const cosine = (p[0] * d[0] + p[1] * d[1] + p[2] * d[2]) / Math.sqrt(3);
      return sum + 2 * Math.exp((cosine - 1) / 0.06);
    }, 1);
    return p.map((x) => x * radius);
  };
  const points = [];
  const faces = [];
  for (let i = 1; i < rings; ++i)
    for (let j = 0; j < segments; ++j) {
      const [u, v] = [(Math.PI * i) / rings, (2 * Math.PI * j) / segments];
      points.push(blownUp([Math.sin(u) * Math.cos(v), Math.sin(u) * Math.sin(v), Math.cos(u)]));
      if (i === 1) continue;
      const [a, b] = [(i - 2) * segments + j, (i - 2) * segments + ((j + 1) % segments)];
      faces.push([a, a + segments, b + segments], [a, b + segments, b]);
    }
  const top = points.length;
  points.push(blownUp([0, 0, 1]), blownUp([0, 0, -1]));
  for (let j = 0; j < segments; ++j) {
    const k = (j + 1) % segments;
    faces.push([top, j, k], [top + 1, top - segments + k, top - segments + j]);
  }
  const lines = [...points, ...faces.map((face) => [3, ...face])].map((row) => row.join(' '));
  return new TextEncoder().encode(
    `OFF\n${points.length} ${faces.length} 0\n${lines.join('\n')}\n`,
  ).buffer;
}

/** A server, with all that it posts, and a promise of the reply to each request. */
async function start() {
  const replies = [];
  const waiting = new Map();
  const server = new Server(await loadEngine(), (reply, transfer) => {
    replies.push({ ...reply, transfer });
    if ('ok' in reply) waiting.get(reply.id)(reply);
  });
  let next = 0;
  const send = (request) => {
    const id = next++;
    const reply = new Promise((resolve) => waiting.set(id, resolve));
    server.receive({ id, ...request });
    return reply;
  };
  return { send, replies };
}

async function startWithMesh() {
  const { send, replies } = await start();
  const load = { op: 'load', name: 'a/ball.off', repair: false, fillOpenings: false };
  const loaded = await send({ ...load, bytes: bumpyBall(24, 24) });
  assert.ok(loaded.ok);
  const found = await send({ op: 'findPoles' });
  assert.equal(found.value.poles.length, 4);
  replies.length = 0;
  return { send, replies, load, loaded: loaded.value, state: canonicalState(found.value.poles) };
}

function withOtherPole(state, vertex) {
  return { ...state, poles: [{ vertex, height: 1 }, ...state.poles.slice(1)] };
}

test('without a mesh there is a problem', async () => {
  const { send } = await start();
  const { ok, problem } = await send({ op: 'findPoles' });
  assert.equal(ok, false);
  assert.equal(problem.kind, 'no_mesh');
});

test('a mesh is loaded, and kept if the next one cannot be', async () => {
  const { send, replies, load, loaded, state } = await startWithMesh();
  assert.equal(loaded.name, 'a/ball.off');
  assert.equal(loaded.positions.length, 3 * loaded.numberOfVertices);
  const bytes = new TextEncoder().encode('OF').buffer;
  const bad = await send({ ...load, name: 'bad.off', bytes });
  assert.match(bad.problem.message, /^bad\.off/);
  const { ok, value } = await send({ op: 'solve', state });
  assert.ok(ok && value.certified);
  const { transfer } = replies.at(-1);
  for (const name of ['partPositions', 'partTriangles', 'partLabels', 'edgeValues'])
    assert.ok(transfer.includes(value[name].buffer), name);
  assert.equal(transfer.length, 4 + 2 * value.skeleton.length);
});

test('of solves that wait, the newest is done', async () => {
  const { send, state } = await startWithMesh();
  const older = [send({ op: 'solve', state }), send({ op: 'solve', state })];
  const newest = send({ op: 'solve', state: { ...state, mode: 'star' } });
  for (const reply of older) {
    const { ok, superseded } = await reply;
    assert.deepEqual([ok, superseded], [false, true]);
  }
  assert.equal((await newest).value.state.mode, 'star');
});

test('a sketch, and a preview come before the loops are found', async () => {
  const { send, replies, state } = await startWithMesh();
  const kindOf = ({ ok, preview, sketch }) =>
    sketch ? 'sketch' : preview ? 'preview' : ok ? 'ok' : 'not ok';
  const kinds = () => replies.filter((reply) => !('progress' in reply)).map(kindOf);
  await send({ op: 'solve', state, preview: true });
  assert.deepEqual(kinds(), ['sketch', 'preview', 'ok']);
  const { sketch, transfer } = replies.find((reply) => reply.sketch);
  assert.deepEqual(transfer, [sketch.partLabels.buffer, sketch.ends.buffer]);
  const { preview } = replies.find((reply) => reply.preview);
  assert.equal(preview.state.mode, 'canonical');
  replies.length = 0;
  const higher = { ...state, poles: state.poles.map((pole) => ({ ...pole, height: 2 })) };
  await send({ op: 'solve', state: higher, preview: true }); // the loops are known
  assert.deepEqual(kinds(), ['sketch', 'ok']);
  replies.length = 0;
  await send({ op: 'solve', state: withOtherPole(state, 100) });
  assert.deepEqual(kinds(), ['ok']); // neither without being asked
});

test('what is behind a preview is superseded, too', async () => {
  const { send, replies, state } = await startWithMesh();
  await send({ op: 'solve', state });
  replies.length = 0;
  const first = send({ op: 'solve', state: withOtherPole(state, 100), preview: true });
  while (!replies.some((reply) => reply.preview))
    await new Promise((resolve) => setImmediate(resolve));
  const second = send({ op: 'solve', state: withOtherPole(state, 101), preview: true });
  assert.equal((await first).superseded, true);
  const { ok, value } = await second;
  assert.ok(ok);
  assert.equal(value.state.poles[0].vertex, 101);
});

test('a flag in shared memory stops what is running', async () => {
  const { send, replies, state } = await startWithMesh();
  const buffer = new SharedArrayBuffer(4);
  await send({ op: 'cancelFlag', buffer });
  const flag = new Int32Array(buffer);
  Atomics.store(flag, 0, 1000);
  assert.equal((await send({ op: 'solve', state })).superseded, true);
  assert.equal((await send({ op: 'solve', state, preview: true })).superseded, true);
  assert.ok(!replies.some((reply) => reply.preview));
  Atomics.store(flag, 0, 0);
  assert.ok((await send({ op: 'solve', state })).ok);
});

test('everything else', async () => {
  const { send, state } = await startWithMesh();
  const { value: result } = await send({ op: 'solve', state: { ...state, mode: 'all' } });
  const { value: hierarchy } = await send({ op: 'hierarchy', poles: state.poles });
  assert.equal(hierarchy.loops.length, result.state.loops.length);
  assert.ok(hierarchy.milliseconds >= 0);
  const { value: leaves } = await send({ op: 'leaves', perArc: 2 });
  assert.equal(leaves.arc.length, 2 * result.arcs.length);
  const check = { op: 'checkLoop', poles: state.poles, loops: result.state.loops };
  const { value: checked } = await send({ ...check, vertices: [300, 301] });
  assert.deepEqual(checked, { path: [300, 301], problem: null });
  const { value: json } = await send({ op: 'download', what: 'reeb_graph.json' });
  const graph = JSON.parse(new TextDecoder().decode(json.bytes));
  assert.equal(graph.mesh, 'a/ball.off');
  assert.deepEqual(graph.nodes, result.nodes);
  const { value: skeleton } = await send({ op: 'download', what: 'skeleton.swc' });
  assert.equal(skeleton.name, 'skeleton.swc');
  assert.match(new TextDecoder().decode(skeleton.bytes), /^#/);
  assert.equal((await send({ op: 'download', what: 'x' })).problem.kind, 'invalid_parameter');
});
