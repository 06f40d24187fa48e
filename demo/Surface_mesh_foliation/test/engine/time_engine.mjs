// node time_engine.mjs TIME_SESSION REPETITIONS MESH...: how long the engine takes natively (the
// program time_session) and in WebAssembly under node, side by side, in milliseconds of processor
// time, and by the clock for the stages of a solve.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { canonicalState, goOn, loadEngine, open, valueOf } from './load_engine.mjs';

/** The processor time of all threads since a time like that; those of the compiler count, too. */
function processorTime(since) {
  const { user, system } = process.cpuUsage(since);
  return (user + system) / 1000;
}

function timeOf(work) {
  const start = process.cpuUsage();
  const result = work();
  return [processorTime(start), result];
}

function median(values) {
  return values.sort((a, b) => a - b)[Math.floor(values.length / 2)];
}

function neighborOf(vertex, edges) {
  return edges[edges.indexOf(vertex) ^ 1];
}

function timesOfEdits(session, states, repetitions) {
  const times = { total: [], loops: [], solve: [], extract: [] };
  for (let i = 0; i < repetitions; ++i)
    for (const state of states) {
      const [total, { milliseconds }] = timeOf(() => valueOf(session.solve(state, goOn)));
      times.total.push(total);
      for (const stage of ['loops', 'solve', 'extract']) times[stage].push(milliseconds[stage]);
    }
  const [first] = times.total;
  return {
    first,
    ...Object.fromEntries(Object.entries(times).map(([stage, all]) => [stage, median(all)])),
  };
}

/** The same steps as in time_session.cpp. */
async function timesInNode(file, repetitions) {
  const times = {};
  const [start, engine] = [process.cpuUsage(), await loadEngine()];
  times['start of the engine'] = processorTime(start);
  const bytes = readFileSync(file);
  let session;
  [times.load, session] = timeOf(() => valueOf(open(engine, path.basename(file), bytes)));
  const { edges } = valueOf(session.loaded());
  const findPoles = () => valueOf(session.findPoles()).poles;
  let poles;
  [times['poles, first'], poles] = timeOf(findPoles);
  times.poles = median(Array.from({ length: repetitions }, () => timeOf(findPoles)[0]));
  const state = canonicalState(poles);
  const change = (pole) => ({
    ...state,
    poles: poles.map((p, i) => (i === 0 ? { ...p, ...pole } : p)),
  });
  const moved = change({ vertex: neighborOf(poles[0].vertex, edges) });
  const star = (some) => ({ ...some, mode: 'star' });
  times['canonical, moved pole'] = timesOfEdits(session, [state, moved], repetitions);
  times['canonical, height'] = timesOfEdits(session, [state, change({ height: 2 })], repetitions);
  times['star, moved pole'] = timesOfEdits(session, [star(state), star(moved)], repetitions);
  times['leaves, 10 per arc'] = timeOf(() => valueOf(session.leaves(10)))[0];
  session.delete();
  return times;
}

function rowsOf(times) {
  return Object.entries(times).flatMap(([what, time]) =>
    typeof time === 'number'
      ? [[what, time]]
      : Object.entries(time).map(([stage, t]) => [`${what}: ${stage}`, t]),
  );
}

const [program, repetitions, ...files] = process.argv.slice(2);
for (const file of files) {
  const native = JSON.parse(execFileSync(program, [file, repetitions], { encoding: 'utf8' }));
  const { vertices } = native;
  delete native.vertices;
  const nativeTimes = new Map(rowsOf(native));
  console.log(`${path.basename(file)}, ${vertices} vertices (milliseconds)`);
  console.log(`${''.padEnd(34)}${'native'.padStart(10)}${'node'.padStart(10)}`);
  for (const [what, time] of rowsOf(await timesInNode(file, Number(repetitions)))) {
    const here = nativeTimes.get(what);
    console.log(
      `${what.padEnd(34)}${(here?.toFixed(1) ?? '').padStart(10)}${time.toFixed(1).padStart(10)}`,
    );
  }
}
