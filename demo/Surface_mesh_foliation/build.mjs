// node build.mjs OUTPUT: bundles the page, and the worker with the engine in it, and puts all
// that the page needs into the folder OUTPUT: static files with relative addresses.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import zlib from 'node:zlib';
import * as esbuild from 'esbuild';

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.join(here, '../..');
const engine = path.join(root, 'build/engine');
const cgalData = '/usr/share/doc/libcgal-dev/data.tar.gz'; // of Debian's package libcgal-demo

const output = path.resolve(process.argv[2] ?? path.join(root, 'build/page'));
fs.rmSync(output, { recursive: true, force: true });
fs.mkdirSync(path.join(output, 'examples'), { recursive: true });

const common = {
  bundle: true,
  minify: true,
  target: 'es2022',
  logLevel: 'warning',
  legalComments: 'none',
};
const source = (name) => path.join(here, 'src', name);
await esbuild.build({
  ...common,
  entryPoints: { page: source('main.ts') },
  format: 'esm',
  outdir: output,
});
await esbuild.build({ ...common, entryPoints: [source('page.css')], outdir: output });
await esbuild.build({
  ...common,
  entryPoints: { worker: source('worker.ts') },
  format: 'iife',
  external: ['fs', 'path', 'crypto', 'worker_threads'], // named in code that only runs under node
  outdir: output,
});
fs.copyFileSync(path.join(here, 'index.html'), path.join(output, 'index.html'));
fs.copyFileSync(path.join(engine, 'engine.wasm'), path.join(output, 'engine.wasm'));
for (const name of await exampleNames()) {
  const mesh = execFileSync('tar', ['-xzOf', cgalData, `data/meshes/${name}.off`], {
    maxBuffer: 1e8,
  });
  fs.writeFileSync(path.join(output, 'examples', `${name}.off`), mesh);
}
fs.writeFileSync(path.join(output, 'licenses.txt'), licenses());
printSizes();

async function exampleNames() {
  const code = await esbuild.transform(fs.readFileSync(source('examples.ts'), 'utf8'), {
    loader: 'ts',
  });
  const module = await import(`data:text/javascript,${encodeURIComponent(code.code)}`);
  return module.EXAMPLES.map(({ name }) => name);
}

function licenses() {
  const parts = [
    'This page is part of Surface_mesh_foliation, GPL 3.0 or later. It contains CGAL (GPL), Eigen',
    '(MPL 2) and Boost (Boost Software License); its examples are meshes of CGAL. It also has:\n',
  ];
  for (const name of ['three', 'fflate']) {
    const license = fs.readFileSync(path.join(here, 'node_modules', name, 'LICENSE'), 'utf8');
    parts.push(`--- ${name}\n\n${license}`);
  }
  return parts.join('\n');
}

function printSizes() {
  console.log('file                      bytes   compressed');
  let total = 0;
  const list = (folder) =>
    fs.readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
      const file = path.join(folder, entry.name);
      return entry.isDirectory() ? list(file) : [file];
    });
  for (const file of list(output)) {
    const bytes = fs.readFileSync(file);
    const compressed = zlib.gzipSync(bytes, { level: 9 }).length;
    const name = path.relative(output, file);
    if (!name.startsWith('examples')) total += compressed;
    console.log(name.padEnd(22), String(bytes.length).padStart(8), String(compressed).padStart(12));
  }
  console.log(`A visitor downloads ${total} bytes, and the example that is looked at.`);
}
