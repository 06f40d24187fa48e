// The compiled engine under node, and small helpers of the tests.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
export const root = path.resolve(here, '../../../..');
const folder = process.env.ENGINE_FOLDER ?? path.join(root, 'build/engine');

/** A new engine, with memory of its own. */
export async function loadEngine() {
  const createEngine = createRequire(import.meta.url)(path.join(folder, 'engine.js'));
  return createEngine({ wasmBinary: readFileSync(path.join(folder, 'engine.wasm')) });
}

/** The value of an outcome; throws if there is a problem. */
export function valueOf({ value, problem }) {
  if (problem) throw new Error(`${problem.kind}: ${problem.message}`);
  return value;
}

/** Opens a mesh, given by the name of a file and its bytes or text; an outcome. */
export function open(engine, name, data, { repair = false, fillOpenings = false } = {}) {
  engine.FS.writeFile(name, typeof data === 'string' ? new TextEncoder().encode(data) : data);
  try {
    return engine.openSession(name, repair, fillOpenings);
  } finally {
    engine.FS.unlink(name);
  }
}

/** A session with a mesh of this system's files. */
export function openFile(engine, file, options) {
  return valueOf(open(engine, path.basename(file), readFileSync(file), options));
}

export const goOn = () => true;

export function canonicalState(poles) {
  return { mode: 'canonical', detail: 0.6, poles, loops: [] };
}
