// The engine's boundary: every error arrives as a problem, and nothing of a failure stays.
import assert from 'node:assert/strict';
import test from 'node:test';
import { canonicalState, goOn, loadEngine, open, valueOf } from './load_engine.mjs';

const engine = await loadEngine();

const tetrahedron = `OFF
4 4 0
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 1 2 3
3 2 0 3
`;

/** A surface of revolution around the z axis, as OFF: `n` vertices on each circle, and two tips. */
function revolution(profile, n, tips) {
  const points = [];
  const faces = [];
  profile.forEach(([z, radius], i) => {
    for (let j = 0; j < n; ++j) {
      const angle = (2 * Math.PI * j) / n;
      points.push([radius * Math.cos(angle), radius * Math.sin(angle), z]);
      if (i === 0) continue;
      const [a, b] = [(i - 1) * n + j, (i - 1) * n + ((j + 1) % n)];
      faces.push([a, b, b + n], [a, b + n, a + n]);
    }
  });
  const [first, last] = [points.length, points.length - n];
  if (tips) {
    points.push([0, 0, tips[0]], [0, 0, tips[1]]);
    for (let j = 0; j < n; ++j) {
      const k = (j + 1) % n;
      faces.push([first, k, j], [first + 1, last + j, last + k]);
    }
  }
  return off(points, faces);
}

function off(points, faces) {
  const rows = [...points, ...faces.map((face) => [face.length, ...face])];
  const lines = rows.map((row) => row.join(' '));
  return `OFF\n${points.length} ${faces.length} 0\n${lines.join('\n')}\n`;
}

/** The points and faces of an OFF file. */
function parse(text) {
  const [, counts, ...lines] = text.trim().split('\n');
  const number = Number(counts.split(' ')[0]);
  const rows = lines.map((line) => line.split(' ').map(Number));
  return [rows.slice(0, number), rows.slice(number).map((row) => row.slice(1))];
}

const n = 12;
const circles = 9;
const spindle = revolution(
  Array.from({ length: circles }, (_, i) => [i, 2 - Math.cos(i)]),
  n,
  [-2, circles + 1],
);
const tips = [circles * n, circles * n + 1];
const tube = revolution(
  Array.from({ length: circles }, (_, i) => [i, 2]),
  n,
  null,
);

function session(text, options) {
  return valueOf(open(engine, 'mesh.off', text, options));
}

function problemOf(outcome) {
  assert.equal(outcome.value, undefined);
  const { kind, message, vertices, faces, loops } = outcome.problem;
  assert.ok(kind && message && vertices && faces && loops);
  return outcome.problem;
}

function areaOf([p, q, r]) {
  const u = p.map((x, k) => q[k] - x);
  const v = p.map((x, k) => r[k] - x);
  const normal = [0, 1, 2].map((k) => u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]);
  return Math.hypot(...normal) / 2;
}

function polesAt(vertices) {
  return vertices.map((vertex) => ({ vertex, height: 1 }));
}

/** Four picks on circle `i`, a quarter of it apart. */
function picksOnCircle(i) {
  return [0, 3, 6, 9].map((j) => i * n + j);
}

test('files that cannot be read', () => {
  const refuse = (name, data) => problemOf(open(engine, name, data));
  assert.equal(refuse('mesh.xyz', tetrahedron).kind, 'file');
  const unknown = refuse('mesh.xyz', tetrahedron).message;
  assert.match(unknown, /^mesh\.xyz.*\.off, \.obj, \.ply and \.stl/);
  assert.equal(refuse('empty.off', '').kind, 'file');
  const wrong = refuse('wrong.off', tetrahedron.replace('1 0 0', '1 x 0'));
  assert.equal(wrong.kind, 'file');
  assert.match(wrong.message, /^wrong\.off:4: /);
});

test('a mesh that a repair would help', () => {
  const damaged = tetrahedron.replace('3 0 1 3', '3 1 0 3');
  const { kind, message } = problemOf(open(engine, 'mesh.off', damaged));
  assert.equal(kind, 'not_orientable');
  assert.match(message, /switch on repair, which would report: 1 face was turned over/);
  const repaired = session(damaged, { repair: true });
  assert.deepEqual(valueOf(repaired.loaded()).repair, ['1 face was turned over']);
  repaired.delete();
});

test('of several parts the largest is kept', () => {
  const [points, faces] = parse(spindle);
  const [fewPoints, fewFaces] = parse(tetrahedron);
  const both = session(
    off(
      [...points, ...fewPoints.map(([x, y, z]) => [x + 50, y, z])],
      [...fewFaces.map((face) => face.map((v) => v + points.length)), ...faces],
    ),
  );
  const loaded = valueOf(both.loaded());
  assert.equal(loaded.numberOfVertices, points.length);
  assert.deepEqual(loaded.repair, [`of 2 parts the largest was kept, with ${faces.length} faces`]);
  assert.deepEqual([...loaded.triangles], faces.flat());
  both.delete();
});

test('openings are ends, or filled', () => {
  const ends = session(tube);
  assert.equal(valueOf(ends.loaded()).numberOfOpenings, 2);
  assert.equal(valueOf(ends.loaded()).openings[0].length, n);
  assert.equal(valueOf(ends.loaded()).genus, 0);
  const { nodes, arcs } = valueOf(ends.solve(canonicalState([]), goOn));
  for (const { kind, pole } of nodes) assert.deepEqual([kind, pole], ['boundary', -1]);
  assert.equal(nodes.length, 2);
  assert.deepEqual(
    arcs.map((arc) => [arc.pole, arc.loop]),
    [[-1, -1]],
  );
  ends.delete();
  const filled = session(tube, { fillOpenings: true });
  const loaded = valueOf(filled.loaded());
  assert.equal(loaded.numberOfOpenings, 0);
  assert.deepEqual(loaded.repair, ['2 openings were filled']);
  assert.equal(loaded.numberOfVertices - loaded.numberOfEdges + loaded.numberOfFaces, 2);
  filled.delete();
});

test('poles are found, or those that a ball needs', () => {
  const ball = session(tetrahedron);
  const { poles, significances } = valueOf(ball.findPoles());
  assert.equal(poles.length, 2);
  assert.deepEqual(significances, [Infinity, Infinity]);
  const { nodes, arcs, certified, state } = valueOf(ball.solve(canonicalState(poles), goOn));
  assert.ok(certified);
  assert.deepEqual(nodes.map((node) => node.pole).sort(), [0, 1]);
  assert.deepEqual(arcs.map((arc) => arc.component), ['sphere']);
  assert.deepEqual(state.loops, []);
  ball.delete();
});

test('states that make no sense', () => {
  const one = session(spindle);
  const refuse = (state) => problemOf(one.solve(state, goOn));
  const state = canonicalState(polesAt(tips));
  assert.match(refuse({ ...state, mode: 'best' }).message, /no mode 'best'/);
  assert.equal(refuse({ ...state, detail: -1 }).kind, 'invalid_parameter');
  assert.match(refuse({ ...state, poles: [{ vertex: 999, height: 1 }] }).message, /no vertex 999/);
  assert.match(refuse({ ...state, poles: [{ vertex: 1.5, height: 1 }] }).message, /whole number/);
  assert.match(refuse({ ...state, poles: [{ vertex: NaN, height: 1 }] }).message, /whole number/);
  const height = refuse({ ...state, poles: [{ vertex: tips[0], height: -1 }, state.poles[1]] });
  assert.equal(height.kind, 'invalid_height');
  assert.match(height.message, new RegExp(`the loop around the pole at vertex ${tips[0]}`));
  assert.deepEqual(height.loops, []);
  assert.deepEqual(height.vertices, [tips[0]]);
  const kindWith = (poles) => refuse({ ...state, mode: 'given', poles }).kind;
  assert.equal(kindWith([]), 'no_loop');
  assert.equal(kindWith([state.poles[0]]), 'inessential_loop');
  assert.equal(kindWith([state.poles[0], state.poles[0]]), 'invalid_pole');
  problemOf(one.leaves(3)); // there is no result yet
  problemOf(one.write('skeleton.ply', 'file'));
  valueOf(one.solve(state, goOn)); // none of this has done any harm
  assert.match(problemOf(one.write('skeleton.xyz', 'file')).message, /no file skeleton.xyz/);
  one.delete();
});

test('a result of the last state stays when the next one is refused or stopped', () => {
  const one = session(spindle);
  const state = canonicalState(polesAt(tips));
  const before = valueOf(one.solve(state, goOn));
  const leaves = valueOf(one.leaves(4));
  problemOf(one.solve({ ...state, poles: [] }, goOn));
  assert.deepEqual(valueOf(one.leaves(4)), leaves);
  const other = { ...state, poles: [state.poles[0], { vertex: 4 * n, height: 1 }] };
  for (let calls = 0, isStopped = true; isStopped; ++calls) {
    let left = calls; // stopped at the first question, at the second, and so on
    const outcome = one.solve(other, () => left-- > 0);
    isStopped = outcome.problem !== undefined;
    assert.ok(calls < 1000);
    if (isStopped) {
      assert.equal(problemOf(outcome).kind, 'stopped');
      assert.deepEqual(valueOf(one.leaves(4)), leaves);
    } else assert.ok(calls > 2);
  }
  const after = valueOf(one.solve(state, goOn));
  assert.deepEqual(after.partLabels, before.partLabels);
  assert.ok(Math.abs(after.energy - before.energy) <= 1e-12 * before.energy);
  one.delete();
});

test('a sketch has nearly the parts of the result', () => {
  const sizes = [60, 41]; // so that there are coarser meshes
  const text = revolution(
    Array.from({ length: sizes[0] }, (_, i) => [i / 5, 2 - Math.cos(i / 5)]),
    sizes[1],
    [-2, sizes[0] / 5 + 1],
  );
  const one = session(text);
  const [points, faces] = parse(text);
  const { positions, triangles } = valueOf(one.loaded());
  assert.deepEqual([positions.length, triangles.length], [3 * points.length, 3 * faces.length]);
  const last = points.length - 1;
  const state = { ...canonicalState(polesAt([last - 1, last, 700, 1900])), mode: 'star' };
  const sketches = [];
  one.showSketches((sketch) => sketches.push(sketch));
  const { arcs } = valueOf(one.solve(state, goOn));
  assert.equal(sketches.length, 1);
  const [{ partLabels, ends }] = sketches;
  assert.deepEqual(
    [...ends],
    arcs.flatMap(({ source, target }) => [source, target]),
  );
  assert.equal(partLabels.length, faces.length);
  const areas = arcs.map(() => 0);
  partLabels.forEach((part, f) => {
    areas[part] += areaOf([0, 1, 2].map((k) => points[triangles[3 * f + k]]));
  });
  const total = areas.reduce((sum, area) => sum + area, 0);
  const wrong = arcs.reduce((sum, { area }, i) => sum + Math.abs(area - areas[i]), 0) / 2;
  assert.ok(wrong < 0.2 * total, `${wrong} of ${total}`);
  assert.throws(() => one.showSketches(), 'a function is needed');
  one.delete();
});

test('a loop is checked while it is drawn', () => {
  const one = session(spindle);
  const poles = polesAt([...tips, 0, 6 * n]); // two on either side of circle 2
  const check = (picks, loops = []) =>
    valueOf(one.checkLoop(picks, { mode: 'given', detail: 0, poles, loops }));
  const picks = picksOnCircle(2);
  assert.deepEqual(check([]), { path: [], problem: null });
  assert.deepEqual(check([picks[0]]), { path: [picks[0]], problem: null });
  assert.deepEqual(check(picks.slice(0, 2)).path, [24, 25, 26, 27]);
  const whole = check(picks);
  assert.equal(whole.problem, null);
  assert.deepEqual(
    [...whole.path].sort((a, b) => a - b),
    Array.from({ length: n }, (_, j) => 2 * n + j),
  );
  const { problem } = check([6 * n, 6 * n + 3, 6 * n + 6]);
  assert.match(problem.message, /belongs to a pole/);
  assert.deepEqual(problem.vertices, [6 * n]);
  const loops = [{ vertices: picks, height: 1 }];
  const crossing = check([n, 3 * n + 3, n + 6, 3 * n + 9], loops).problem;
  assert.equal(crossing.kind, 'intersecting_loops');
  assert.deepEqual(crossing.loops, [0, 1]);
  assert.match(crossing.message, /^loop 0 and loop 1 meet/);
  const homotopic = check(picksOnCircle(3), loops).problem;
  assert.equal(homotopic.kind, 'homotopic_loops');
  assert.deepEqual(homotopic.loops.sort(), [0, 1]);
  const around = check(picksOnCircle(7)).problem;
  assert.equal(around.kind, 'homotopic_loops');
  assert.match(around.message, new RegExp(`the loop around the pole at vertex ${tips[1]}`));
  assert.deepEqual(around.loops, [0]);
  one.delete();
});

test('picked loops, and loops that were found, given back', () => {
  const one = session(spindle);
  const poles = polesAt([...tips, 0, 6 * n]);
  const drawn = { vertices: picksOnCircle(2), height: 2 };
  const picked = valueOf(
    one.solve({ mode: 'given', detail: 0.6, poles, loops: [drawn] }, goOn),
  );
  assert.deepEqual(picked.arcs.at(-1).loop, 0);
  assert.equal(picked.arcs.at(-1).height, 2);
  assert.deepEqual(picked.state.loops, [drawn]);
  const all = valueOf(one.solve({ ...canonicalState(poles), mode: 'all' }, goOn));
  assert.ok(all.state.loops.length > 0);
  for (const loop of all.state.loops) assert.ok(loop.found && loop.crossings.length > 0);
  const again = valueOf(one.solve({ ...all.state, mode: 'given' }, goOn));
  assert.deepEqual(again.partLabels, all.partLabels);
  assert.deepEqual(
    again.arcs.map((arc) => arc.modulus),
    again.arcs.map(() => null),
  );
  const hierarchy = valueOf(one.hierarchy(poles));
  assert.deepEqual(
    hierarchy.map(({ vertices, modulus }) => ({ vertices, modulus })),
    all.arcs
      .filter((arc) => arc.loop >= 0)
      .map((arc) => ({ vertices: all.state.loops[arc.loop].vertices, modulus: arc.modulus })),
  );
  // along their walks alone, the loops are in the same classes
  const [first] = all.state.loops;
  const walk = { vertices: first.vertices, height: 1, found: true };
  const alone = (loop) =>
    valueOf(one.solve({ mode: 'given', detail: 0.6, poles, loops: [loop] }, goOn)).energy;
  const energy = alone(first);
  assert.ok(Math.abs(alone(walk) - energy) <= 1e-9 * energy);
  one.delete();
});

test('leaves are closed curves', () => {
  const one = session(spindle);
  const { arcs } = valueOf(one.solve(canonicalState(polesAt([...tips, 4 * n])), goOn));
  const { points, first, arc } = valueOf(one.leaves(5));
  assert.equal(first.length, 5 * arcs.length + 1);
  assert.equal(arc.length, 5 * arcs.length);
  assert.equal(first.at(-1), points.length / 3);
  for (let i = 0; i < arc.length; ++i) {
    const [begin, end] = [3 * first[i], 3 * (first[i + 1] - 1)];
    assert.ok(end > begin + 6);
    assert.deepEqual([...points.slice(begin, begin + 3)], [...points.slice(end, end + 3)]);
  }
  one.delete();
});

test('all files are written', () => {
  const one = session(spindle);
  valueOf(one.solve(canonicalState(polesAt([...tips, 4 * n])), goOn));
  const begins = {
    'reeb_graph.graphml': '<?xml',
    'reeb_graph.dot': 'graph',
    'components.ply': 'ply',
    'leaves.ply': 'ply',
    'skeleton.ply': 'ply',
    'skeleton.swc': '#',
    'foliation.ply': 'ply',
    'segments.ply': 'ply',
    'edge_values.csv': 'vertex,vertex,value',
    'components.obj': 'v ',
    'components.vtp': '<?xml',
    'leaves.vtp': '<?xml',
    'skeleton.vtp': '<?xml',
    'foliation.vtp': '<?xml',
    'singularities.vtp': '<?xml',
    'coordinates.vtp': '<?xml',
  };
  for (const [what, begin] of Object.entries(begins)) {
    valueOf(one.write(what, 'file'));
    const text = new TextDecoder().decode(engine.FS.readFile('file'));
    engine.FS.unlink('file');
    assert.ok(text.startsWith(begin), `${what} begins with ${text.slice(0, 20)}`);
    assert.ok(text.length > 100, what);
  }
  one.delete();
});

test('formats', () => {
  const [points, faces] = parse(tetrahedron);
  const files = {
    'mesh.obj': [
      ...points.map((p) => `v ${p.join(' ')}`),
      ...faces.map((face) => `f ${face.map((v) => v + 1).join(' ')}`),
    ],
    'mesh.ply': [
      'ply\nformat ascii 1.0\nelement vertex 4',
      'property double x\nproperty double y\nproperty double z',
      'element face 4\nproperty list uchar int vertex_indices\nend_header',
      ...points.map((p) => p.join(' ')),
      ...faces.map((face) => `3 ${face.join(' ')}`),
    ],
    'mesh.stl': [
      'solid mesh',
      ...faces.map(
        (face) =>
          `facet normal 0 0 0\nouter loop\n${face
            .map((v) => `vertex ${points[v].join(' ')}`)
            .join('\n')}\nendloop\nendfacet`,
      ),
      'endsolid mesh',
    ],
  };
  for (const [name, text] of Object.entries(files)) {
    const one = valueOf(open(engine, name, `${text.join('\n')}\n`));
    assert.equal(valueOf(one.loaded()).numberOfVertices, 4, name);
    assert.equal(valueOf(one.loaded()).numberOfFaces, 4, name);
    one.delete();
  }
});

// ===  The exact test of degenerate faces: WebAssembly cannot change the rounding mode

/** A number times 2^1074, exactly. */
function toInteger(number) {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, number);
  const bits = view.getBigUint64(0);
  const exponent = (bits >> 52n) & 0x7ffn;
  const fraction = bits & 0xfffffffffffffn;
  const value = exponent === 0n ? fraction : (fraction | 0x10000000000000n) << (exponent - 1n);
  return number < 0 ? -value : value;
}

function areCollinear(points) {
  const [a, b, c] = points.map((p) => p.map(toInteger));
  const [u, v] = [b, c].map((p) => p.map((x, i) => x - a[i]));
  return [0, 1, 2].every((i) => {
    const j = (i + 1) % 3;
    return u[i] * v[j] === u[j] * v[i];
  });
}

/** Numbers between 0 and 1, the same in every run. */
function makeRandom(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

test('faces are degenerate if and only if their corners lie on a line, exactly', () => {
  const random = makeRandom(5);
  const point = (make) => [make(), make(), make()];
  let degenerate = 0;
  const number = 3000;
  for (let i = 0; i < number; ++i) {
    const scale = 2 ** Math.floor(40 * random());
    const a = point(() => Math.floor(scale * (random() - 0.5)));
    const d = point(() => Math.floor(scale * (random() - 0.5)));
    const [k, l] = [1 + Math.floor(7 * random()), -1 - Math.floor(7 * random())];
    const along = (factor) => a.map((x, j) => (x + factor * d[j]) / 4096);
    const points = [along(0), along(k), along(l)];
    if (i % 3 === 1) points[2][i % 2] += 1 / 4096; // off the line by the least step
    if (i % 3 === 2) points[2] = points[2].map((x) => x * (1 + Number.EPSILON * (random() < 0.5)));
    const expected = areCollinear(points);
    const outcome = open(engine, 'face.off', off(points, [[0, 1, 2]]));
    const kind = outcome.problem?.kind;
    assert.equal(kind, expected ? 'degenerate_face' : undefined, JSON.stringify(points));
    outcome.value?.delete();
    degenerate += Number(expected);
  }
  assert.ok(degenerate > number / 4 && degenerate < (3 * number) / 4, `${degenerate}`);
});
