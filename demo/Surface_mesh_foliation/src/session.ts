// What is open, what is chosen and what is shown. The panels and the picture listen to it.
import { Abandoned, Engine, ProblemError } from './engine';
import { MOST_VERTICES, tooLarge, tooManyVertices } from './file_size';
import { History } from './history';
import { misfit } from './link';
import type { Link, Source } from './link';
import { Signal } from './signal';
import { initialState, setDetail, stateKey } from './state';
import type { Hierarchy, Leaves, Loaded, Problem, Result, Sketch, State } from './protocol';

export interface ReadOptions {
  repair: boolean;
  fillOpenings: boolean;
}

/** Of an edit, in milliseconds. */
export interface Timing {
  untilResult: number; // the first one, which may have the loops of the result before
  inEngine: number;
}

const MOST_CACHED_RESULTS = 16;
const MOST_CACHED_VERTICES = 60_000; // results of larger meshes are not kept
const MOST_LEVELS_AHEAD = 8; // fewer than results are cached
const MOST_VERTICES_AHEAD = 20_000; // an edit waits until a level is solved where memory is not shared

export class Session {
  readonly opened = new Signal<Loaded>();
  readonly stateChanged = new Signal<State>();
  readonly resultChanged = new Signal<Result | null>();
  /** Where the parts of the next result will lie, nearly. */
  readonly sketched = new Signal<Sketch>();
  readonly hierarchyChanged = new Signal<Hierarchy | null>();
  readonly problemMet = new Signal<Problem>();
  readonly noticed = new Signal<string>();

  loaded: Loaded | null = null;
  result: Result | null = null;
  hierarchy: Hierarchy | null = null;
  source: Source | null = null;
  timing: Timing | null = null;
  /** The result that is shown has the loops of the one before; the right ones come soon. */
  isProvisional = false;

  private history: History<State> | null = null;
  private cache = new Map<string, Result>();
  private keyInEngine = ''; // the state that the engine solved last
  private hierarchyKey = '';
  private pendingLink: Link | null = null;
  private opening = 0; // turns, of which only the last one counts
  private solving = 0;
  private running: { key: string; promise: Promise<boolean> } | null = null; // the newest solve
  private shownTurn = 0;
  private shownKey = '';

  constructor(readonly engine: Engine) {}

  get state(): State | null {
    return this.history?.present ?? null;
  }

  get canUndo(): boolean {
    return this.history?.canUndo ?? false;
  }

  get canRedo(): boolean {
    return this.history?.canRedo ?? false;
  }

  get isPreview(): boolean {
    return this.history?.isPreview ?? false;
  }

  /** A link to a mesh that only its owner has waits until that is opened. */
  expect(link: Link): void {
    this.pendingLink = link;
  }

  async open(
    name: string,
    bytes: ArrayBuffer,
    options: ReadOptions,
    example: string | null,
  ): Promise<boolean> {
    const size = tooLarge(name, bytes);
    if (size) return this.refuse('too large', size);
    const turn = ++this.opening;
    try {
      const loaded = await this.engine.load({ name, bytes, ...options });
      if (turn !== this.opening) return false;
      if (loaded.numberOfVertices > MOST_VERTICES)
        return this.refuse('too large', tooManyVertices(name, loaded.numberOfVertices));
      this.take(loaded, sourceOf(loaded, options, example));
      const state = this.linkedState() ?? (await this.stateWithFoundPoles());
      if (turn !== this.opening) return false;
      this.history = new History(state);
      this.stateChanged.emit(state);
      await this.solve(performance.now());
      return true;
    } catch (error) {
      return this.report(error);
    }
  }

  /** A final edit is a step of the history; others are previews, while something is dragged. */
  edit(state: State, isFinal = true): Promise<boolean> {
    const { history } = this;
    if (!history || (stateKey(state) === stateKey(history.present) && !history.isPreview))
      return Promise.resolve(false);
    const began = performance.now();
    if (isFinal) history.commit(state);
    else history.preview(state);
    this.stateChanged.emit(state);
    return this.solve(began);
  }

  /** Ends a drag that came to nothing. */
  revert(): Promise<boolean> {
    if (!this.history?.isPreview) return Promise.resolve(false);
    this.history.revert();
    return this.returned();
  }

  undo(): Promise<boolean> {
    return this.history?.undo() ? this.returned() : Promise.resolve(false);
  }

  redo(): Promise<boolean> {
    return this.history?.redo() ? this.returned() : Promise.resolve(false);
  }

  cancel(): void {
    this.keyInEngine = '';
    this.running = null;
    this.engine.cancel();
    this.noticed.emit('Canceled.');
    const { history } = this;
    if (!history || stateKey(history.present) === this.shownKey || !history.drop()) return;
    void this.returned();
  }

  leaves(perArc: number): Promise<Leaves> {
    return this.afterResult(() => this.engine.leaves(perArc));
  }

  download(what: string): Promise<{ name: string; bytes: Uint8Array }> {
    return this.afterResult(() => this.engine.download(what));
  }

  /** The hierarchy of the present poles; the panel asks for it when it is looked at. */
  async wantHierarchy(): Promise<void> {
    const { state } = this;
    if (!state || this.history?.isPreview) return;
    const key = polesKey(state);
    if (key === this.hierarchyKey) return;
    this.hierarchyKey = key;
    this.setHierarchy(null);
    try {
      const hierarchy = await this.engine.hierarchy(state.poles);
      if (key === this.hierarchyKey) this.setHierarchy(hierarchy);
    } catch (error) {
      this.hierarchyKey = '';
      if (!(error instanceof Abandoned || error instanceof ProblemError)) throw error;
    }
  }

  /** Solves other levels of detail before somebody asks for them, until there is an edit. */
  async solveAhead(details: number[]): Promise<void> {
    const { history, solving } = this;
    if (!history || this.loaded!.numberOfVertices > MOST_VERTICES_AHEAD) return;
    for (const detail of details.slice(0, MOST_LEVELS_AHEAD)) {
      const state = setDetail(history.present, detail);
      const key = stateKey(state);
      if (this.cache.has(key)) continue;
      try {
        const result = await this.engine.solveAhead(state);
        if (history !== this.history) return;
        this.keyInEngine = ''; // what was solved last is not what is shown
        this.keep(key, result);
      } catch (error) {
        if (!(error instanceof Abandoned || error instanceof ProblemError)) throw error;
        return;
      }
      if (solving !== this.solving) return;
    }
  }

  /** Tells what is wrong; returns false, so that callers can return it. */
  report(error: unknown): false {
    if (error instanceof ProblemError) this.problemMet.emit(error.problem);
    else if (!(error instanceof Abandoned)) throw error;
    return false;
  }

  private async stateWithFoundPoles(): Promise<State> {
    try {
      return initialState((await this.engine.findPoles()).poles);
    } catch (error) {
      this.report(error);
      this.noticed.emit(
        'There are no poles yet: choose Poles, and click on the ends of the shape.',
      );
      return initialState([]);
    }
  }

  private take(loaded: Loaded, source: Source): void {
    this.loaded = loaded;
    this.source = source;
    this.history = null;
    this.cache.clear();
    this.running = null;
    this.keyInEngine = '';
    this.hierarchyKey = '';
    this.setHierarchy(null);
    this.opened.emit(loaded);
    this.show(null, '', ++this.solving);
  }

  private linkedState(): State | null {
    const link = this.pendingLink;
    if (!link || !this.loaded || !this.source) return null;
    this.pendingLink = null;
    if (!isSame(link.source, this.source)) {
      this.noticed.emit('This is not the mesh that the link was made for: the link is ignored.');
      return null;
    }
    const wrong = misfit(link.state, this.loaded.numberOfVertices);
    if (wrong) this.noticed.emit(`The link does not suit the mesh and is ignored: ${wrong}.`);
    return wrong ? null : link.state;
  }

  private async returned(): Promise<boolean> {
    this.stateChanged.emit(this.history!.present);
    return this.solve(performance.now());
  }

  /** What is being solved is not solved twice: the end of a drag often brings the same state. */
  private solve(began: number): Promise<boolean> {
    const key = stateKey(this.history!.present);
    if (this.running?.key === key) return this.running.promise;
    const running = { key, promise: this.solveNow(key, began) };
    this.running = running;
    const end = () => {
      if (this.running === running) this.running = null;
    };
    running.promise.then(end, end);
    return running.promise;
  }

  private async solveNow(key: string, began: number): Promise<boolean> {
    const history = this.history!;
    const state = history.present;
    const turn = ++this.solving;
    const cached = this.cache.get(key);
    if (cached) {
      this.show(cached, key, turn);
      return true;
    }
    try {
      const result = await this.engine.solve(state, {
        onSketch: (sketch) => {
          if (history === this.history && turn > this.shownTurn) this.sketched.emit(sketch);
        },
        onPreview: (preview) => {
          if (history === this.history) this.showNew(preview, '', turn, began);
        },
      });
      if (history !== this.history) return false;
      this.keyInEngine = key;
      this.keep(key, result);
      this.showNew(result, key, turn, began);
      return turn === this.solving;
    } catch (error) {
      if (history !== this.history) return false;
      if (turn === this.solving) this.takeBack(error);
      return this.report(error);
    }
  }

  /** A refused step is taken back; a preview stays, since the pointer may move on. */
  private takeBack(error: unknown): void {
    const history = this.history!;
    if (!(error instanceof ProblemError) || history.isPreview || !history.drop()) return;
    void this.returned();
  }

  /** While something is dragged, results come one after another, and each is shown. */
  private showNew(result: Result, key: string, turn: number, began: number): void {
    if (turn < this.shownTurn) return;
    if (turn > this.shownTurn)
      this.timing = { untilResult: performance.now() - began, inEngine: result.milliseconds.total };
    this.show(result, key, turn);
  }

  private show(result: Result | null, key: string, turn: number): void {
    this.result = result;
    this.isProvisional = result !== null && key === '';
    this.shownKey = key;
    this.shownTurn = turn;
    this.resultChanged.emit(result);
  }

  private keep(key: string, result: Result): void {
    if (this.loaded!.numberOfVertices > MOST_CACHED_VERTICES) this.cache.clear();
    this.cache.set(key, result);
    if (this.cache.size > MOST_CACHED_RESULTS) this.cache.delete(this.cache.keys().next().value!);
  }

  /** Leaves and files are those of what is shown, which may have come from the cache. */
  private async afterResult<T>(ask: () => Promise<T>): Promise<T> {
    const { state } = this;
    if (!state || !this.result) throw new Abandoned('nothing is shown');
    const key = stateKey(state);
    if (key !== this.keyInEngine) {
      await this.engine.solve(state);
      this.keyInEngine = key;
    }
    return ask();
  }

  private setHierarchy(hierarchy: Hierarchy | null): void {
    this.hierarchy = hierarchy;
    this.hierarchyChanged.emit(hierarchy);
  }

  private refuse(kind: string, message: string): false {
    this.problemMet.emit({ kind, message, vertices: [], faces: [], loops: [] });
    return false;
  }
}

function polesKey(state: State): string {
  return state.poles.map((pole) => pole.vertex).join();
}

function sourceOf(loaded: Loaded, options: ReadOptions, example: string | null): Source {
  if (example !== null) return { kind: 'example', name: example };
  return {
    kind: 'file',
    name: loaded.name,
    vertices: loaded.numberOfVertices,
    faces: loaded.numberOfFaces,
    options: [options.repair ? 'repair' : '', options.fillOpenings ? 'fill' : '']
      .filter(Boolean)
      .join(','),
  };
}

/** The name of a file may change, its size may not. */
function isSame(a: Source, b: Source): boolean {
  if (a.kind === 'example' || b.kind === 'example') return a.kind === b.kind && a.name === b.name;
  return a.vertices === b.vertices && a.faces === b.faces;
}
