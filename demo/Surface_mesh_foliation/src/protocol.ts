// What the page (main thread) and the engine (WebAssembly in a Web Worker) say to each other: plain
// data only, numbers, strings, and typed arrays, which are transferred, not copied.

/** An error: what is wrong, where, and what to do. */
export interface Problem {
  /** The package's name of the kind of problem, or "memory", "no_mesh", "internal". */
  kind: string;
  /** The sentence that the package wrote, with loops by their numbers in the state. */
  message: string;
  vertices: number[]; // of the loaded mesh
  faces: number[];
  loops: number[]; // indices into State.loops
}

/** height > 0, 1 by default */
export interface Pole {
  vertex: number;
  height: number;
}

/** A closed loop. */
export interface Loop {
  /** The picked vertices, which shortest paths join, the last with the first. Of a loop that the
   *  engine found: a closed walk along edges, consecutive ones are neighbors. */
  vertices: number[];
  height: number;
  found?: boolean;
  /** Of a loop that the engine found: where it crosses edges, exactly. Three numbers each: the
   *  source and the target of the edge, and the position between. The target lies to the left. */
  crossings?: number[];
}

/** All that a user can choose: what undo, redo and the link hold. */
export interface State {
  /**
   * canonical: poles as given, and the loops of level `detail` of their hierarchy;
   * star: no loops but those that handles need;
   * all: the whole hierarchy, a decomposition into pairs of pants;
   * given: `loops` as they are.
   */
  mode: 'canonical' | 'star' | 'all' | 'given';
  detail: number; // in mode canonical: the least modulus of a loop; 0.6 by default
  poles: Pole[];
  loops: Loop[]; // in mode given
}

export interface Loaded {
  name: string;
  numberOfVertices: number;
  numberOfFaces: number;
  numberOfEdges: number;
  genus: number;
  numberOfOpenings: number;
  openings: number[][]; // the vertices around each opening that is an end of the graph
  positions: Float64Array; // 3 per vertex, as in the file
  triangles: Uint32Array; // 3 per face
  edges: Uint32Array; // 2 per edge, in the order of edgeValues
  /** What was done to the mesh, one sentence each: repairs, openings filled, parts left out. */
  repair: string[];
  milliseconds: number;
}

export interface GraphNode {
  id: number;
  kind: string; // pole, saddle, regular or boundary (an opening)
  pole: number; // index into State.poles, -1 if none
  degree: number;
  point: [number, number, number];
  symmetry: number; // class: nodes with the same number are alike
}

export interface GraphArc {
  id: number;
  source: number;
  target: number;
  component: string; // disk, cylinder or sphere
  height: number;
  flux: number;
  area: number;
  length: number;
  modulus: number | null; // of a loop of the hierarchy
  margin: number | null;
  symmetry: number;
  pole: number; // index into State.poles if it is the loop around one, otherwise -1
  loop: number; // index into Result.state.loops, or -1
}

export interface Polyline {
  arc: number;
  points: Float64Array;
  radii: Float64Array;
}

export interface Result {
  state: State; // with the loops that were used (those that were found filled in)
  notes: string[]; // what the user should know of it, one sentence each
  certified: boolean;
  energy: number;
  optimality: number;
  iterations: number;
  nodes: GraphNode[];
  /** In the order of their ids: the loops of openings, of poles, and then the others. */
  arcs: GraphArc[];
  // the mesh cut along critical leaves, with the part (id of the arc) of each face
  partPositions: Float64Array;
  partTriangles: Uint32Array;
  partLabels: Uint32Array;
  skeleton: Polyline[];
  edgeValues: Float64Array; // per edge of the loaded mesh
  singularities: { point: [number, number, number]; index: number }[];
  milliseconds: { poles: number; loops: number; solve: number; extract: number; total: number };
}

/** Where the parts will lie, nearly, when less than half of the work is done. */
export interface Sketch {
  partLabels: Uint32Array; // the arc of each face of the loaded mesh
  ends: Uint32Array; // the nodes of each arc, two after two
}

export interface HierarchyLoop extends Loop {
  modulus: number;
  margin: number;
  separating: boolean;
  cutsHandle: boolean;
}

/** All loops of the hierarchy, most significant first, so that the slider needs no engine. */
export interface Hierarchy {
  loops: HierarchyLoop[];
  milliseconds: number;
}

/** Leaf i has the points from first[i] to first[i + 1] - 1, the first one repeated at the end. */
export interface Leaves {
  points: Float64Array;
  first: Uint32Array;
  arc: Uint32Array;
}

export type Request =
  /**
   * -> Loaded. Of a mesh of several parts, the largest is kept. `fillOpenings`: all of them are
   * filled; otherwise, as in the program, those shorter than a twentieth of the diagonal, and the
   * others are ends of the graph. A mesh loaded before stays if this one cannot be read.
   */
  | { op: 'load'; name: string; bytes: ArrayBuffer; repair: boolean; fillOpenings: boolean }
  /** -> { poles: Pole[]; significances: number[] }; infinite for those that are needed anyway */
  | { op: 'findPoles' }
  /**
   * -> Result. With `preview`, replies of their own come first: a sketch and, where loops take long
   * to find (modes canonical and all, after poles have changed), a result with the loops of the last
   * one.
   */
  | { op: 'solve'; state: State; preview?: boolean }
  /** -> Result, of a state that may be wanted next. The session's last result is then this one. */
  | { op: 'solveAhead'; state: State }
  /** -> Hierarchy */
  | { op: 'hierarchy'; poles: Pole[] }
  /** -> Leaves of the last result */
  | { op: 'leaves'; perArc: number }
  /**
   * -> { path: number[]; problem: Problem | null }: the walk through the picked vertices (open
   * while there are fewer than 3), and why it would be refused; there, it is loop number
   * loops.length.
   */
  | { op: 'checkLoop'; vertices: number[]; poles: Pole[]; loops: Loop[] }
  /** -> { name: string; bytes: Uint8Array }, of the last result */
  | { op: 'download'; what: string }
  /** -> null. An Int32: requests with a smaller id stop, and end with superseded: true. */
  | { op: 'cancelFlag'; buffer: SharedArrayBuffer };

/** What `download` knows. */
export const downloads = [
  'reeb_graph.graphml',
  'reeb_graph.dot',
  'reeb_graph.json',
  'components.ply',
  'components.vtp',
  'components.obj', // with texture coordinates
  'coordinates.vtp',
  'segments.ply',
  'foliation.ply',
  'foliation.vtp',
  'leaves.ply',
  'leaves.vtp',
  'skeleton.ply',
  'skeleton.vtp',
  'skeleton.swc',
  'singularities.vtp',
  'edge_values.csv',
] as const;

/**
 * From the worker to the page. Each request has an `id`. Of solves that wait, only the newest is
 * done; the others end with superseded: true. To cancel what is running, the page terminates the
 * worker and starts it again, or sets the flag of `cancelFlag`; the last result stays usable.
 */
export type Reply =
  | { id: number; ok: true; value: unknown }
  | { id: number; ok: false; superseded?: boolean; problem?: Problem }
  | { id: number; preview: Result } // the reply proper follows
  | { id: number; sketch: Sketch } // of a solve, before its preview or reply
  | { id: number; progress: { stage: string; fraction: number | null } };
