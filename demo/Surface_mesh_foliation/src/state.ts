// What a user can choose, and the edits of it: each makes a new state and changes none.
import type { Loop, Pole, State } from './protocol';

/** The bound of the canonical loops in the package's main program. */
export const DEFAULT_DETAIL = 0.6;
export const LEAST_HEIGHT = 0.1;
export const LARGEST_HEIGHT = 10;

export function initialState(poles: Pole[]): State {
  return { mode: 'canonical', detail: DEFAULT_DETAIL, poles, loops: [] };
}

export function isPole(state: State, vertex: number): boolean {
  return state.poles.some((pole) => pole.vertex === vertex);
}

export function addPole(state: State, vertex: number): State {
  if (isPole(state, vertex)) return state;
  return { ...state, poles: [...state.poles, { vertex, height: 1 }] };
}

export function movePole(state: State, index: number, vertex: number): State {
  if (isPole(state, vertex)) return state;
  return { ...state, poles: replaced(state.poles, index, { ...state.poles[index], vertex }) };
}

export function removePole(state: State, index: number): State {
  return { ...state, poles: without(state.poles, index) };
}

export function setPoleHeight(state: State, index: number, height: number): State {
  return { ...state, poles: replaced(state.poles, index, { ...state.poles[index], height }) };
}

export function setMode(state: State, mode: State['mode'], used: Loop[]): State {
  return mode === 'given' ? withLoops(state, used) : { ...state, mode, loops: [] };
}

export function setDetail(state: State, detail: number): State {
  return { ...state, mode: 'canonical', detail, loops: [] };
}

/** Edits of loops start at the loops that were used, found ones as well, and keep them. */
export function withLoops(state: State, loops: Loop[]): State {
  return { ...state, mode: 'given', loops };
}

export function addLoop(state: State, used: Loop[], vertices: number[]): State {
  return withLoops(state, [...used, { vertices, height: 1 }]);
}

export function removeLoop(state: State, used: Loop[], index: number): State {
  return withLoops(state, without(used, index));
}

export function setLoopHeight(state: State, used: Loop[], index: number, height: number): State {
  return withLoops(state, replaced(used, index, { ...used[index], height }));
}

/** Equal keys: the same state. In modes that find loops, given ones do not count. */
export function stateKey(state: State): string {
  const loops = state.mode === 'given' ? state.loops : [];
  const detail = state.mode === 'canonical' ? state.detail : 0;
  return JSON.stringify([
    state.mode,
    detail,
    state.poles.map((pole) => [pole.vertex, pole.height]),
    loops.map((loop) => [loop.vertices, loop.height, loop.found ?? false]),
  ]);
}

function replaced<T>(items: T[], index: number, item: T): T[] {
  return items.map((old, i) => (i === index ? item : old));
}

function without<T>(items: T[], index: number): T[] {
  return items.filter((_, i) => i !== index);
}
