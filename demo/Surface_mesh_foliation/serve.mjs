// node serve.mjs FOLDER [PORT]: serves a folder of static files on this machine. With the two
// headers below, a page may share memory with its worker, so that a computation can be canceled
// without losing the mesh; the page also works without them.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.wasm': 'application/wasm',
  '.off': 'text/plain',
  '.txt': 'text/plain; charset=utf-8',
};

const ISOLATED = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
};

/** Resolves to the server; port 0 is any that is free. */
export function serve(folder, port = 0, isIsolated = true) {
  const root = path.resolve(folder);
  const server = http.createServer((request, response) => {
    const name = fileOf(root, request.url);
    fs.readFile(name ?? '', (error, bytes) => {
      if (error) {
        response.writeHead(404).end('There is no such file');
        return;
      }
      const type = TYPES[path.extname(name)] ?? 'application/octet-stream';
      response.writeHead(200, { 'Content-Type': type, ...(isIsolated ? ISOLATED : {}) }).end(bytes);
    });
  });
  return new Promise((resolve, reject) => {
    server.once('error', reject);
    server.listen(port, '127.0.0.1', () => resolve(server));
  });
}

/** The file that an address means, or null if it would lie outside of the folder. */
function fileOf(root, url) {
  let address;
  try {
    address = decodeURIComponent(new URL(url, 'http://localhost').pathname);
  } catch {
    return null;
  }
  const file = path.join(root, address.endsWith('/') ? `${address}index.html` : address);
  return file.startsWith(root + path.sep) ? file : null;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const server = await serve(process.argv[2], Number(process.argv[3] ?? 8000));
  console.log(`The page is at http://127.0.0.1:${server.address().port}/ (Ctrl-C ends it)`);
}
