// A state as the fragment of a link, such as
//   #example=homer&mode=canonical&detail=0.6&poles=51,21*0.5&loops=1.2.3;4.5.6*2~
// A fragment is never sent to a server. A pole or loop has its height behind *, unless it is 1; a
// loop that was found, a closed walk along edges, ends in ~. Vertices of walks are written as
// differences in base 36, since walks are long and neighbors often have similar numbers.
import { DEFAULT_DETAIL } from './state';
import type { Loop, Pole, State } from './protocol';

export type Source =
  | { kind: 'example'; name: string }
  | { kind: 'file'; name: string; vertices: number; faces: number; options: string };

export interface Link {
  source: Source;
  state: State;
}

export class LinkError extends Error {}

const MODES: State['mode'][] = ['canonical', 'star', 'all', 'given'];

export function encodeLink({ source, state }: Link): string {
  const parts = new URLSearchParams();
  if (source.kind === 'example') parts.set('example', source.name);
  else {
    parts.set('file', source.name);
    parts.set('size', `${source.vertices},${source.faces}`);
    if (source.options) parts.set('read', source.options);
  }
  parts.set('mode', state.mode);
  if (state.mode === 'canonical') parts.set('detail', String(state.detail));
  parts.set('poles', state.poles.map(encodePole).join(','));
  if (state.mode === 'given') parts.set('loops', state.loops.map(encodeLoop).join(';'));
  // the characters that we use are allowed in a fragment as they are
  return '#' + parts.toString().replace(/%2C/g, ',').replace(/%3B/g, ';').replace(/%7E/g, '~');
}

/** The link in a fragment, or null if there is none. Throws a LinkError if it makes no sense. */
export function decodeLink(fragment: string): Link | null {
  const parts = new URLSearchParams(fragment.replace(/^#/, ''));
  if (!parts.has('example') && !parts.has('file')) return null;
  const mode = (parts.get('mode') ?? 'canonical') as State['mode'];
  if (!MODES.includes(mode)) throw new LinkError(`there is no mode "${mode}"`);
  const state: State = {
    mode,
    detail: parts.has('detail') ? positive(parts.get('detail')!, 'detail', true) : DEFAULT_DETAIL,
    poles: list(parts.get('poles'), ',').map(decodePole),
    loops: mode === 'given' ? list(parts.get('loops'), ';').map(decodeLoop) : [],
  };
  return { source: decodeSource(parts), state };
}

function decodeSource(parts: URLSearchParams): Source {
  const example = parts.get('example');
  if (example !== null) return { kind: 'example', name: example };
  const size = list(parts.get('size'), ',');
  if (size.length !== 2) throw new LinkError('it does not say how large the mesh is');
  const [vertices, faces] = size.map((text) => count(text, 'size'));
  const options = parts.get('read') ?? '';
  return { kind: 'file', name: parts.get('file')!, vertices, faces, options };
}

function encodePole(pole: Pole): string {
  return pole.vertex + encodeHeight(pole.height);
}

function encodeHeight(height: number): string {
  return height === 1 ? '' : `*${height}`;
}

function decodePole(text: string): Pole {
  const [vertex, height] = text.split('*');
  return { vertex: count(vertex, 'poles'), height: decodeHeight(height) };
}

function decodeHeight(text: string | undefined): number {
  return text === undefined ? 1 : positive(text, 'height', false);
}

function encodeLoop(loop: Loop): string {
  let last = 0;
  const steps = loop.vertices.map((vertex) => {
    const step = (vertex - last).toString(36);
    last = vertex;
    return step;
  });
  return steps.join('.') + encodeHeight(loop.height) + (loop.found ? '~' : '');
}

function decodeLoop(text: string): Loop {
  const found = text.endsWith('~');
  const [walk, height] = text.replace(/~$/, '').split('*');
  let last = 0;
  const vertices = walk.split('.').map((step) => {
    if (!/^-?[0-9a-z]{1,8}$/.test(step)) throw new LinkError(`"${step}" is no step of a loop`);
    last += parseInt(step, 36);
    if (last < 0) throw new LinkError('a loop passes a vertex with a negative number');
    return last;
  });
  const loop: Loop = { vertices, height: decodeHeight(height) };
  return found ? { ...loop, found } : loop;
}

function list(text: string | null, separator: string): string[] {
  return text ? text.split(separator) : [];
}

function count(text: string, what: string): number {
  if (!/^\d{1,9}$/.test(text)) throw new LinkError(`"${text}" in ${what} is no whole number`);
  return Number(text);
}

function positive(text: string, what: string, zeroAllowed: boolean): number {
  const value = text === '' ? NaN : Number(text);
  if (!Number.isFinite(value) || value < 0 || (value === 0 && !zeroAllowed))
    throw new LinkError(`"${text}" is no ${what}`);
  return value;
}

/** Why a link does not suit a mesh, or null: vertices that the mesh does not have. */
export function misfit(state: State, numberOfVertices: number): string | null {
  const vertices = [
    ...state.poles.map((pole) => pole.vertex),
    ...state.loops.flatMap((loop) => loop.vertices),
  ];
  const wrong = vertices.find((vertex) => vertex >= numberOfVertices);
  if (wrong === undefined) return null;
  return `it names vertex ${wrong}, and the mesh has ${numberOfVertices} vertices`;
}
