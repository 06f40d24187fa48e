// A worker of which the test says what it answers, and when. It is used in unit tests only.
import type { WorkerLike } from '../../src/engine';
import type { Loaded, Pole, Problem, Reply, Request, Result, State } from '../../src/protocol';

export type Sent = Request & { id: number };

export class Mock_worker implements WorkerLike {
  onmessage: ((event: MessageEvent) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  readonly sent: Sent[] = [];
  isTerminated = false;
  /** Answers at once, where it gives a reply. */
  automatic: (request: Sent) => Reply | null = () => null;

  postMessage(message: unknown): void {
    const request = message as Sent;
    this.sent.push(request);
    const reply = this.automatic(request);
    if (reply) queueMicrotask(() => this.reply(reply));
  }

  terminate(): void {
    this.isTerminated = true;
  }

  reply(reply: Reply): void {
    this.onmessage?.({ data: reply } as MessageEvent);
  }

  fail(message: string): void {
    this.onerror?.({ message } as ErrorEvent);
  }

  ops(): string[] {
    return this.sent.map(({ op }) => op);
  }
}

export function problem(message: string): Problem {
  return { kind: 'INVALID_POLE', message, vertices: [3], faces: [], loops: [] };
}

export const tetrahedron: Loaded = {
  name: 'tetrahedron.off',
  numberOfVertices: 4,
  numberOfFaces: 4,
  numberOfEdges: 6,
  genus: 0,
  numberOfOpenings: 0,
  openings: [],
  positions: new Float64Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]),
  triangles: new Uint32Array([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]),
  edges: new Uint32Array([0, 1, 0, 2, 0, 3, 1, 2, 1, 3, 2, 3]),
  repair: [],
  milliseconds: 1,
};

/** A result that tells the state that it belongs to, and nothing else. */
export function resultOf(state: State): Result {
  return {
    state,
    notes: [],
    certified: true,
    energy: 1,
    optimality: 0,
    iterations: 1,
    nodes: [],
    arcs: [],
    partPositions: new Float64Array(0),
    partTriangles: new Uint32Array(0),
    partLabels: new Uint32Array(0),
    skeleton: [],
    edgeValues: new Float64Array(0),
    singularities: [],
    milliseconds: { poles: 0, loops: 0, solve: 0, extract: 0, total: 1 },
  };
}

/** Answers like an engine that finds these poles and refuses states with the vertex `refused`. */
export function engineWith(poles: Pole[], refused = -1): (request: Sent) => Reply {
  return (request) => {
    const { id } = request;
    switch (request.op) {
      case 'load':
        return { id, ok: true, value: tetrahedron };
      case 'findPoles':
        return { id, ok: true, value: { poles, significances: [] } };
      case 'solve':
      case 'solveAhead':
        return request.state.poles.some(({ vertex }) => vertex === refused)
          ? { id, ok: false, problem: problem(`vertex ${refused} is refused`) }
          : { id, ok: true, value: resultOf(request.state) };
      default:
        return { id, ok: true, value: { loops: [], milliseconds: 0 } };
    }
  };
}
