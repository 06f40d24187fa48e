// What the engine computes in WebAssembly is what it computes natively (write_results.cpp): poles,
// graphs, loops and labels exactly, numbers up to rounding.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { canonicalState, goOn, loadEngine, openFile, valueOf } from './load_engine.mjs';

const LEAST_MESHES = 20;
const ENERGY_TOLERANCE = 1e-12;
const TOLERANCE = 1e-9; // of other numbers, relative to the largest of their kind

const resultsFile = process.env.NATIVE_RESULTS;
assert.ok(resultsFile, 'NATIVE_RESULTS names the file that write_results has written');
const natives = JSON.parse(readFileSync(resultsFile, 'utf8'));
const engine = await loadEngine();

/** The same steps as in write_results.cpp. */
function resultsOf(session, poles) {
  const results = [];
  const solve = (state) => {
    const result = valueOf(session.solve(state, goOn));
    results.push(result);
    return result.state;
  };
  const canonical = solve(canonicalState(poles));
  solve({ ...canonicalState(poles), mode: 'all' });
  solve({ ...canonicalState(poles), mode: 'star' });
  const state = {
    ...canonical,
    mode: 'given',
    loops: canonical.loops.map((loop) => ({ ...loop, height: 2 })),
  };
  solve(state);
  if (poles.length > 0)
    solve({ ...state, poles: state.poles.map((p, i) => (i === 0 ? { ...p, height: 3 } : p)) });
  return results;
}

/** The error may be that of the largest number, or of `size`. */
function assertClose(actual, expected, tolerance, what, size = Number.MIN_VALUE) {
  assert.equal(actual.length, expected.length, what);
  const scale = expected.reduce((most, number) => Math.max(most, Math.abs(number ?? 0)), size);
  for (let i = 0; i < expected.length; ++i) {
    if (expected[i] === null) assert.equal(actual[i], null, what);
    else if (!(Math.abs(actual[i] - expected[i]) <= tolerance * scale))
      assert.fail(`${what} ${i}: ${actual[i]} instead of ${expected[i]}`);
  }
}

function split(object, names) {
  return Object.fromEntries(names.map((name) => [name, object[name]]));
}

const exactOfNode = ['id', 'kind', 'pole', 'degree', 'symmetry'];
const exactOfArc = ['id', 'source', 'target', 'pole', 'loop', 'component', 'height', 'symmetry'];
const numbersOfArc = ['flux', 'area', 'modulus', 'margin'];

function verticesOfCrossings(loop) {
  return loop.crossings.filter((_, i) => i % 3 !== 2);
}

function compareLoops(actual, expected) {
  assert.deepEqual(
    actual.map((loop) => loop.vertices),
    expected.map((loop) => loop.vertices),
  );
  assert.deepEqual(actual.map(verticesOfCrossings), expected.map(verticesOfCrossings));
}

function compare(actual, expected, step, size) {
  const of = (what) => `step ${step}: ${what}`;
  assert.ok(actual.certified && expected.certified, of('certified'));
  for (const [part, exact] of [
    ['nodes', exactOfNode],
    ['arcs', exactOfArc],
  ])
    assert.deepEqual(
      actual[part].map((object) => split(object, exact)),
      expected[part].map((object) => split(object, exact)),
      of(part),
    );
  compareLoops(actual.state.loops, expected.loops);
  assert.deepEqual([...actual.partTriangles], expected.partTriangles, of('triangles of parts'));
  assert.deepEqual([...actual.partLabels], expected.partLabels, of('labels of parts'));
  assertClose([actual.energy], [expected.energy], ENERGY_TOLERANCE, of('energy'));
  for (const name of numbersOfArc)
    assertClose(
      actual.arcs.map((arc) => arc[name]),
      expected.arcs.map((arc) => arc[name]),
      TOLERANCE,
      of(name),
    );
  const lengths = ({ arcs, nodes }) => [
    ...arcs.map((arc) => arc.length),
    ...nodes.flatMap((node) => node.point),
  ];
  assertClose(lengths(actual), lengths(expected), TOLERANCE, of('lengths and points'), size);
  assertClose([...actual.edgeValues], expected.edgeValues, TOLERANCE, of('edge values'));
}

for (const native of natives)
  test(native.file.replace(/.*\//, ''), () => {
    if (native.error) {
      assert.throws(
        () => {
          const session = openFile(engine, native.file, { repair: true });
          try {
            resultsOf(session, valueOf(session.findPoles()).poles);
          } finally {
            session.delete();
          }
        },
        'natively there was an error: ' + native.error,
      );
      return;
    }
    const session = openFile(engine, native.file, { repair: true });
    try {
      const loaded = valueOf(session.loaded());
      assert.deepEqual(loaded.repair, native.report);
      assert.equal(loaded.genus, native.genus);
      assert.deepEqual(loaded.openings, native.openings);
      assert.deepEqual([...loaded.triangles], native.triangles);
      assert.deepEqual([...loaded.edges], native.edges);
      const { poles, significances } = valueOf(session.findPoles());
      assert.deepEqual(
        poles.map((pole) => pole.vertex),
        native.poles,
      );
      assertClose(
        significances.map((number) => (Number.isFinite(number) ? number : null)),
        native.significances,
        TOLERANCE,
        'significance',
      );
      const results = resultsOf(session, poles);
      assert.equal(results.length, native.results.length);
      const size = loaded.positions.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
      results.forEach((result, step) => compare(result, native.results[step], step, size));
      assert.deepEqual([...valueOf(session.leaves(3)).first], native.leaves);
    } finally {
      session.delete();
    }
  });

test('there were enough meshes', () => {
  const compared = natives.filter((native) => !native.error).length;
  assert.ok(compared >= LEAST_MESHES, `only ${compared} meshes were compared`);
});
