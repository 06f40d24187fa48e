// The engine as the page sees it: requests become promises. At most one solve waits while another
// one runs; of several that wait, only the newest is worth while.
import type {
  Hierarchy,
  Leaves,
  Loaded,
  Loop,
  Pole,
  Problem,
  Reply,
  Request,
  Result,
  Sketch,
  State,
} from './protocol';

/** The part of Worker that is needed. */
export interface WorkerLike {
  postMessage(message: unknown, transfer: Transferable[]): void;
  terminate(): void;
  onmessage: ((event: MessageEvent) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

/** The package, or the page, says what is wrong. */
export class ProblemError extends Error {
  constructor(readonly problem: Problem) {
    super(problem.message);
  }
}

/** A newer edit or the user made the answer useless: nothing to tell anybody. */
export class Abandoned extends Error {}

export interface Progress {
  stage: string;
  fraction: number | null;
}

export interface FileToRead {
  name: string;
  bytes: ArrayBuffer;
  repair: boolean;
  fillOpenings: boolean;
}

/** What comes of a solve before its result. */
export interface Meanwhile {
  onSketch(sketch: Sketch): void;
  /** A first result, with the loops of the one before, while the right loops are looked for. */
  onPreview(result: Result): void;
}

const NOTHING: Meanwhile = { onSketch() {}, onPreview() {} };

interface Waiting {
  op: Request['op'];
  meanwhile: Meanwhile;
  since: number;
  resolve: (value: unknown) => void;
  reject: (error: Error) => void;
}

interface Queued {
  state: State;
  meanwhile: Meanwhile;
  resolve: (result: Result) => void;
  reject: (error: Error) => void;
}

/** A solve that has run for so long is told at once that a newer one is wanted. */
const PATIENCE = 300; // milliseconds

export class Engine {
  onProgress: (progress: Progress) => void = () => {};
  onBusy: (isBusy: boolean) => void = () => {};

  private worker: WorkerLike;
  private waiting = new Map<number, Waiting>();
  private nextId = 0;
  private file: FileToRead | null = null;
  private mustReload = false;
  private queued: Queued | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** Requests with an id below this number stop; only pages that are isolated may share memory. */
  private readonly flag = sharedFlag();

  constructor(private readonly makeWorker: () => WorkerLike) {
    this.worker = this.start();
  }

  /** The mesh of an earlier file is kept until the new one is there. */
  async load(file: FileToRead): Promise<Loaded> {
    if (this.isBusy) this.cancel();
    const previous = this.file;
    const reload = this.mustReload;
    try {
      const loaded = await this.request<Loaded>(loadRequest(file));
      this.file = file;
      this.mustReload = false;
      return loaded;
    } catch (error) {
      this.file = previous;
      this.mustReload = reload || previous !== null;
      throw error;
    }
  }

  findPoles(): Promise<{ poles: Pole[]; significances: number[] }> {
    return this.request({ op: 'findPoles' });
  }

  hierarchy(poles: Pole[]): Promise<Hierarchy> {
    return this.request({ op: 'hierarchy', poles });
  }

  leaves(perArc: number): Promise<Leaves> {
    return this.request({ op: 'leaves', perArc });
  }

  checkLoop(
    vertices: number[],
    poles: Pole[],
    loops: Loop[],
  ): Promise<{ path: number[]; problem: Problem | null }> {
    return this.request({ op: 'checkLoop', vertices, poles, loops });
  }

  download(what: string): Promise<{ name: string; bytes: Uint8Array }> {
    return this.request({ op: 'download', what });
  }

  solve(state: State, meanwhile = NOTHING): Promise<Result> {
    this.abandonQueued();
    if (this.isRunning('hierarchy')) this.stopEarlier(); // it can wait, an edit cannot
    const running = this.runningSolve();
    if (!running) return this.request<Result>({ op: 'solve', state, preview: true }, meanwhile);
    return new Promise((resolve, reject) => {
      this.queued = { state, meanwhile, resolve, reject };
      const wait = Math.max(0, PATIENCE - (Date.now() - running.since));
      this.timer = setTimeout(() => this.sendQueued(), wait);
    });
  }

  /** Solves what may be wanted next, unseen. All that is asked for meanwhile stops it. */
  solveAhead(state: State): Promise<Result> {
    return this.request({ op: 'solveAhead', state });
  }

  /** Ends all that runs. Without shared memory the worker is started again, and reads the mesh
   *  again before its next task. */
  cancel(): void {
    if (!this.flag) {
      this.restart(new Abandoned('canceled'));
      return;
    }
    this.stopEarlier();
    if (this.isRunning('load')) this.mustReload = this.file !== null;
    this.abandonAll(new Abandoned('canceled'));
  }

  /** Whether somebody waits. */
  get isBusy(): boolean {
    return [...this.waiting.values()].some(({ op }) => op !== 'solveAhead');
  }

  private start(): WorkerLike {
    const worker = this.makeWorker();
    worker.onmessage = ({ data }) => this.receive(data as Reply);
    worker.onerror = (event) => {
      event.preventDefault?.();
      this.restart(
        new ProblemError({
          kind: 'internal',
          message: `The engine stopped: ${event.message || 'it could not be loaded'}`,
          vertices: [],
          faces: [],
          loops: [],
        }),
      );
    };
    if (this.flag) {
      worker.postMessage({ id: this.nextId++, op: 'cancelFlag', buffer: this.flag.buffer }, []);
    }
    return worker;
  }

  private restart(reason: Error): void {
    this.worker.terminate();
    this.worker = this.start();
    this.mustReload = this.file !== null;
    this.abandonAll(reason);
  }

  private abandonAll(reason: Error): void {
    const waiting = [...this.waiting.values()];
    this.waiting.clear();
    this.abandonQueued();
    for (const { reject } of waiting) reject(reason);
    this.onBusy(false);
  }

  private stopEarlier(): void {
    if (this.flag) Atomics.store(this.flag, 0, this.nextId);
  }

  private isRunning(op: Request['op']): boolean {
    return [...this.waiting.values()].some((waiting) => waiting.op === op);
  }

  private runningSolve(): Waiting | undefined {
    return [...this.waiting.values()].find(({ op }) => op === 'solve');
  }

  private abandonQueued(): void {
    clearTimeout(this.timer);
    this.queued?.reject(new Abandoned('superseded'));
    this.queued = null;
  }

  private sendQueued(): void {
    clearTimeout(this.timer);
    const queued = this.queued;
    this.queued = null;
    if (!queued) return;
    if (this.runningSolve()) this.stopEarlier();
    const { state, meanwhile, resolve, reject } = queued;
    this.request<Result>({ op: 'solve', state, preview: true }, meanwhile).then(resolve, reject);
  }

  private async request<T>(request: Request, meanwhile = NOTHING): Promise<T> {
    if (this.mustReload && request.op !== 'load') {
      this.mustReload = false;
      await this.post<Loaded>(loadRequest(this.file!));
    }
    return this.post<T>(request, meanwhile);
  }

  private post<T>(request: Request, meanwhile = NOTHING): Promise<T> {
    if (this.isRunning('solveAhead')) this.stopEarlier();
    const id = this.nextId++;
    const transfer = request.op === 'load' ? [request.bytes] : [];
    return new Promise<T>((resolve, reject) => {
      this.waiting.set(id, {
        op: request.op,
        meanwhile,
        since: Date.now(),
        resolve: resolve as (value: unknown) => void,
        reject,
      });
      if (this.isBusy) this.onBusy(true);
      this.worker.postMessage({ id, ...request }, transfer);
    });
  }

  private receive(reply: Reply): void {
    const waiting = this.waiting.get(reply.id);
    if (!waiting) return;
    if ('progress' in reply) {
      this.onProgress(reply.progress);
      return;
    }
    if ('sketch' in reply) {
      waiting.meanwhile.onSketch(reply.sketch);
      return;
    }
    if ('preview' in reply) {
      waiting.meanwhile.onPreview(reply.preview);
      this.sendQueued(); // what is still looked for is worth nothing if there is something newer
      return;
    }
    this.waiting.delete(reply.id);
    if (reply.ok) waiting.resolve(reply.value);
    else if (reply.superseded) waiting.reject(new Abandoned('superseded'));
    else waiting.reject(new ProblemError(reply.problem ?? unknownProblem()));
    if (waiting.op === 'solve') this.sendQueued();
    if (!this.isBusy) this.onBusy(false);
  }
}

function sharedFlag(): Int32Array | null {
  return globalThis.crossOriginIsolated ? new Int32Array(new SharedArrayBuffer(4)) : null;
}

/** The bytes are handed over to the worker, so it gets a copy: they may be needed again. */
function loadRequest(file: FileToRead): Request {
  return { op: 'load', ...file, bytes: file.bytes.slice(0) };
}

function unknownProblem(): Problem {
  return {
    kind: 'internal',
    message: 'The engine gave no reason',
    vertices: [],
    faces: [],
    loops: [],
  };
}
