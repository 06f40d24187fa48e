// How many vertices a file has, as far as its first lines tell: so that a mesh which is too large
// for a page is refused before it fills the memory.

export const MOST_VERTICES = 400_000;
export const MOST_BYTES = 200_000_000;

/** The number of vertices, about; null if it is not told. */
export function announcedVertices(name: string, bytes: ArrayBuffer): number | null {
  const head = new TextDecoder('latin1').decode(
    new Uint8Array(bytes, 0, Math.min(4096, bytes.byteLength)),
  );
  const extension = name.toLowerCase().split('.').pop();
  if (extension === 'off')
    return numberIn(/^\s*\S*OFF(?:\s+BINARY)?\s*(?:#[^\n]*\s*)*(\d+)\s+\d+/, head);
  if (extension === 'ply') return numberIn(/element\s+vertex\s+(\d+)/, head);
  if (extension === 'stl') return binaryStlVertices(bytes);
  return null;
}

function numberIn(pattern: RegExp, text: string): number | null {
  const match = pattern.exec(text);
  return match ? Number(match[1]) : null;
}

/** A closed surface has about half as many vertices as faces. */
function binaryStlVertices(bytes: ArrayBuffer): number | null {
  if (bytes.byteLength < 84) return null;
  const faces = new DataView(bytes).getUint32(80, true);
  return bytes.byteLength === 84 + 50 * faces ? Math.ceil(faces / 2) : null;
}

/** What to say about a mesh that is too large, or null. */
export function tooLarge(name: string, bytes: ArrayBuffer): string | null {
  const vertices = announcedVertices(name, bytes);
  if (vertices !== null && vertices > MOST_VERTICES) return tooManyVertices(name, vertices);
  if (bytes.byteLength <= MOST_BYTES) return null;
  const size = Math.round(bytes.byteLength / 1e6);
  return `${name} has ${size} MB, which is too large for a page. ${WHAT_TO_DO}`;
}

export function tooManyVertices(name: string, vertices: number): string {
  const number = vertices.toLocaleString('en-US');
  const most = MOST_VERTICES.toLocaleString('en-US');
  return `${name} has ${number} vertices, and a page has memory for ${most}. ${WHAT_TO_DO}`;
}

const WHAT_TO_DO =
  'Simplify it first, or use the program foliation_reeb_graph, which takes millions of vertices.';
