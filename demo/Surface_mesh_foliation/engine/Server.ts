// Answers requests one after another, the way the worker does. It knows nothing of workers, so that
// it can be tested without.
import type { Loaded, Loop, Pole, Problem, Reply, Request, Result, Sketch, State } from '../src/protocol';
import type { Engine, Outcome, Session } from './Engine';

export type Numbered = Request & { id: number };
export type Post = (reply: Reply, transfer: ArrayBuffer[]) => void;

/** Progress is not told more often. */
const MIN_MILLISECONDS = 100;

export class Server {
  private session: Session | null = null;
  private name = '';
  private graph: object | null = null; // of the last result, for downloads
  private loops: Loop[] = []; // of the last result
  private polesOfHierarchy: string | null = null; // those whose hierarchy the session has
  private queue: Numbered[] = [];
  private isScheduled = false;
  private cancelFlag: Int32Array | null = null;
  private sketchedId: number | null = null; // of the request whose sketch is wanted

  constructor(
    private readonly engine: Engine,
    private readonly post: Post,
  ) {
    // file names in messages are those of the user
    engine.FS.mkdir('/work');
    engine.FS.chdir('/work');
  }

  /** Of several solves that wait, the newest is done. */
  receive(request: Numbered): void {
    if (request.op === 'solve') this.dropSolves();
    this.queue.push(request); // (the rest of a previewed solve is in the queue, too)
    this.schedule();
  }

  private dropSolves(): void {
    const isSolve = ({ op }: Numbered) => op === 'solve';
    for (const { id } of this.queue.filter(isSolve))
      this.post({ id, ok: false, superseded: true }, []);
    this.queue = this.queue.filter((request) => !isSolve(request));
  }

  /** What has been sent meanwhile is received before the next request is answered. */
  private schedule(): void {
    if (this.isScheduled || this.queue.length === 0) return;
    this.isScheduled = true;
    setTimeout(() => {
      this.isScheduled = false;
      const request = this.queue.shift();
      try {
        if (request) this.answer(request);
      } finally {
        this.schedule();
      }
    }, 0);
  }

  /** An error of JavaScript, say of a module that ran out of its stack, is thrown: then the worker
   *  has to be started again. */
  private answer(request: Numbered): void {
    const { id } = request;
    if (request.op === 'solve' && request.preview && this.mustFindLoops(request.state)) {
      this.preview(request);
      return;
    }
    const outcome = this.isStopped(id) ? stopped() : this.outcomeOf(request);
    if (outcome.problem === undefined)
      this.post({ id, ok: true, value: outcome.value }, buffersOf(outcome.value));
    else if (outcome.problem.kind === 'stopped') this.post({ id, ok: false, superseded: true }, []);
    else this.post({ id, ok: false, problem: outcome.problem }, []);
  }

  /** Whether the loops of a state are not known, and take long to find. */
  private mustFindLoops({ mode, poles }: State): boolean {
    return (mode === 'canonical' || mode === 'all') && keyOf(poles) !== this.polesOfHierarchy;
  }

  /** The loops of the last result will do for the first picture. What has been sent meanwhile is
   *  received before those of the new poles are found. */
  private preview(request: Extract<Numbered, { op: 'solve' }>): void {
    const { id, state } = request;
    const { session } = this;
    if (session && !this.isStopped(id)) {
      const old: State = { ...state, mode: 'given', loops: this.loops };
      const none: State = { ...state, mode: 'star', loops: [] };
      let { value } = this.solve(session, id, this.graph ? old : none, true);
      value ??= this.solve(session, id, none, true).value;
      if (value) {
        const preview = { ...value, state: { ...value.state, mode: state.mode } };
        this.post({ id, preview }, buffersOf(preview));
      }
    }
    this.queue.unshift({ ...request, preview: false });
  }

  private outcomeOf(request: Numbered): Outcome<unknown> {
    if (request.op === 'load') return this.load(request);
    if (request.op === 'cancelFlag') {
      this.cancelFlag = new Int32Array(request.buffer);
      return { value: null };
    }
    const { session } = this;
    if (!session) return refusal('no_mesh', 'no mesh is loaded');
    switch (request.op) {
      case 'findPoles':
        return session.findPoles();
      case 'solve':
        return this.solve(session, request.id, request.state, request.preview === true);
      case 'solveAhead':
        return session.solve(request.state, () => !this.isStopped(request.id));
      case 'hierarchy': {
        const start = performance.now();
        const { value, problem } = session.hierarchy(request.poles);
        if (problem) return { problem };
        this.polesOfHierarchy = keyOf(request.poles);
        return { value: { loops: value, milliseconds: performance.now() - start } };
      }
      case 'leaves':
        return session.leaves(request.perArc);
      case 'checkLoop': {
        const { vertices, poles, loops } = request;
        return session.checkLoop(vertices, { mode: 'given', detail: 0, poles, loops });
      }
      case 'download':
        return this.download(session, request.what);
    }
  }

  /** The mesh before is kept if the new one cannot be read. */
  private load(request: Extract<Request, { op: 'load' }>): Outcome<Loaded> {
    const start = performance.now();
    const { FS } = this.engine;
    const file = request.name.replace(/[/\\]/g, '_');
    FS.writeFile(file, new Uint8Array(request.bytes));
    const { value: session, problem } = this.engine.openSession(
      file,
      request.repair,
      request.fillOpenings,
    );
    FS.unlink(file);
    if (problem) return { problem };
    const loaded = session.loaded();
    if (loaded.problem) {
      session.delete();
      return loaded;
    }
    this.session?.delete();
    this.session = session;
    session.showSketches((sketch) => this.showSketch(sketch));
    this.name = request.name;
    this.graph = null;
    this.loops = [];
    this.polesOfHierarchy = null;
    return {
      value: { ...loaded.value, name: request.name, milliseconds: performance.now() - start },
    };
  }

  private showSketch(sketch: Sketch): void {
    if (this.sketchedId !== null) this.post({ id: this.sketchedId, sketch }, buffersOf(sketch));
  }

  private solve(
    session: Session,
    id: number,
    state: State,
    isSketched: boolean,
  ): Outcome<Result> {
    let last = performance.now();
    this.sketchedId = isSketched ? id : null;
    const outcome = session.solve(state, (stage) => {
      const now = performance.now();
      if (now - last >= MIN_MILLISECONDS) {
        last = now;
        this.post({ id, progress: { stage, fraction: null } }, []);
      }
      return !this.isStopped(id);
    });
    if (outcome.value) {
      this.graph = graphOf(this.name, outcome.value);
      this.loops = outcome.value.state.loops;
      if (state.mode === 'canonical' || state.mode === 'all')
        this.polesOfHierarchy = keyOf(state.poles);
    }
    this.sketchedId = null;
    return outcome;
  }

  private isStopped(id: number): boolean {
    return this.cancelFlag !== null && Atomics.load(this.cancelFlag, 0) > id;
  }

  private download(
    session: Session,
    what: string,
  ): Outcome<{ name: string; bytes: Uint8Array }> {
    if (what === 'reeb_graph.json' && this.graph) {
      const text = `${JSON.stringify(this.graph, null, 2)}\n`;
      return { value: { name: what, bytes: new TextEncoder().encode(text) } };
    }
    const { problem } = session.write(what, 'download');
    if (problem) return { problem };
    const bytes = this.engine.FS.readFile('download');
    this.engine.FS.unlink('download');
    return { value: { name: what, bytes } };
  }
}

/** The hierarchy of poles does not depend on heights. */
function keyOf(poles: Pole[]): string {
  return poles.map((pole) => pole.vertex).join();
}

function refusal(kind: string, message: string): { problem: Problem } {
  return { problem: { kind, message, vertices: [], faces: [], loops: [] } };
}

function stopped(): { problem: Problem } {
  return refusal('stopped', 'a newer request is there, or the user has canceled this one');
}

/** What reeb_graph.json has: all but the large arrays. */
function graphOf(name: string, result: Result): object {
  const { state, certified, energy, optimality, iterations } = result;
  const { nodes, arcs, singularities } = result;
  const numbers = { certified, energy, optimality, iterations };
  return { mesh: name, state, ...numbers, nodes, arcs, singularities };
}

/** The buffers of all typed arrays: they are transferred, not copied. */
function buffersOf(value: unknown, buffers: ArrayBuffer[] = []): ArrayBuffer[] {
  if (ArrayBuffer.isView(value)) buffers.push(value.buffer as ArrayBuffer);
  else if (Array.isArray(value) && typeof value[0] === 'number') return buffers;
  else if (typeof value === 'object' && value !== null)
    for (const part of Object.values(value)) buffersOf(part, buffers);
  return buffers;
}
