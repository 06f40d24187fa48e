// Bundles the unit tests and runs them under node.
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import * as esbuild from 'esbuild';

const here = path.dirname(fileURLToPath(import.meta.url));
const output = path.join(here, '../../../build/page_test/unit');
fs.rmSync(output, { recursive: true, force: true });
const tests = fs.readdirSync(path.join(here, 'unit')).filter((name) => name.endsWith('.test.ts'));
await esbuild.build({
  entryPoints: tests.map((name) => path.join(here, 'unit', name)),
  bundle: true,
  platform: 'node',
  format: 'esm',
  outExtension: { '.js': '.mjs' },
  outdir: output,
  logLevel: 'warning',
});
const files = tests.map((name) => path.join(output, name.replace(/\.ts$/, '.mjs')));
const run = spawnSync(process.execPath, ['--test', ...files], { stdio: 'inherit' });
process.exit(run.status ?? 1);
