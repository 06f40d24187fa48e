// The engine in a Web Worker: the page stays responsive while a solve runs.
/// <reference path="../engine/engine.d.ts" />
import createEngine from '../../../build/engine/engine.js';
import type { Engine } from '../engine/Engine';
import { Server } from '../engine/Server';
import type { Numbered } from '../engine/Server';

/** What a page's Worker has on the other side; the types of the page do not know it. */
interface WorkerScope {
  onmessage: ((event: MessageEvent<Numbered>) => void) | null;
  postMessage(message: unknown, transfer: Transferable[]): void;
  location: { href: string };
}

const scope = globalThis as unknown as WorkerScope;

const server = createEngine({
  locateFile: (file: string) => new URL(file, scope.location.href).href, // beside this script
}).then(
  (engine) => new Server(engine as Engine, (reply, transfer) => scope.postMessage(reply, transfer)),
);

server.catch((error: unknown) => {
  setTimeout(() => {
    throw error; // the page is told
  });
});

scope.onmessage = ({ data }) => void server.then((ready) => ready.receive(data));
