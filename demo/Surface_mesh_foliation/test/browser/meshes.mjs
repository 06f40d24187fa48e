// Meshes for the tests, as OFF files.

export function toOff({ points, faces }) {
  const lines = [`OFF`, `${points.length} ${faces.length} 0`];
  for (const point of points) lines.push(point.map((x) => x.toFixed(9)).join(' '));
  for (const face of faces) lines.push(`${face.length} ${face.join(' ')}`);
  return lines.join('\n') + '\n';
}

/** A body with five limbs, of 2 + rings * sectors vertices: vertex 0 is at its top, the last one
 *  at its bottom, and 1 + ring * sectors + sector between them. */
export function body(rings, sectors) {
  const limbs = [
    [0, 0, 1],
    [0.9, 0.3, 0.25],
    [-0.9, 0.3, 0.25],
    [0.45, 0, -0.9],
    [-0.45, 0, -0.9],
  ].map((limb) => scaled(limb, 1 / Math.hypot(...limb)));
  const at = (theta, phi) => {
    const direction = [
      Math.sin(theta) * Math.cos(phi),
      Math.sin(theta) * Math.sin(phi),
      Math.cos(theta),
    ];
    const radius = limbs.reduce(
      (sum, limb) => sum + 1.6 * Math.exp(22 * (dot(direction, limb) - 1)),
      1,
    );
    const [x, y, z] = scaled(direction, radius);
    return [x, z, -y]; // the y axis points upward
  };
  return sphere(rings, sectors, at);
}

/** A grid of rings between two poles. */
function sphere(rings, sectors, at) {
  const points = [at(0, 0)];
  for (let i = 1; i <= rings; ++i)
    for (let j = 0; j < sectors; ++j)
      points.push(at((Math.PI * i) / (rings + 1), (2 * Math.PI * j) / sectors));
  points.push(at(Math.PI, 0));
  const vertex = (i, j) => 1 + i * sectors + (j % sectors);
  const last = points.length - 1;
  const faces = [];
  for (let j = 0; j < sectors; ++j) {
    faces.push([0, vertex(0, j), vertex(0, j + 1)]);
    for (let i = 0; i + 1 < rings; ++i) {
      faces.push([vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)]);
      faces.push([vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)]);
    }
    faces.push([vertex(rings - 1, j), last, vertex(rings - 1, j + 1)]);
  }
  return { points, faces };
}

export function torus(m, n) {
  const points = [];
  const faces = [];
  for (let i = 0; i < m; ++i)
    for (let j = 0; j < n; ++j) {
      const [u, v] = [(2 * Math.PI * i) / m, (2 * Math.PI * j) / n];
      const r = 2 + 0.6 * Math.cos(v);
      points.push([r * Math.cos(u), r * Math.sin(u), 0.6 * Math.sin(v)]);
      const at = (k, l) => ((i + k) % m) * n + ((j + l) % n);
      faces.push([at(0, 0), at(1, 0), at(1, 1)], [at(0, 0), at(1, 1), at(0, 1)]);
    }
  return { points, faces };
}

/** The same mesh, with one face turned over and one given twice. */
export function damaged(mesh) {
  const faces = mesh.faces.map((face, i) => (i === 5 ? [...face].reverse() : face));
  return { points: mesh.points, faces: [...faces, faces[9]] };
}

export function toObj({ points, faces }) {
  const lines = points.map((point) => `v ${point.join(' ')}`);
  return (
    [...lines, ...faces.map((face) => `f ${face.map((v) => v + 1).join(' ')}`)].join('\n') + '\n'
  );
}

export function toPly({ points, faces }) {
  const head = [
    'ply',
    'format ascii 1.0',
    `element vertex ${points.length}`,
    ...['x', 'y', 'z'].map((name) => `property double ${name}`),
    `element face ${faces.length}`,
    'property list uchar int vertex_indices',
    'end_header',
  ];
  const lines = [...points.map((p) => p.join(' ')), ...faces.map((face) => `3 ${face.join(' ')}`)];
  return [...head, ...lines].join('\n') + '\n';
}

export function toStl({ points, faces }) {
  const bytes = Buffer.alloc(84 + 50 * faces.length);
  bytes.writeUInt32LE(faces.length, 80);
  faces.forEach((face, i) =>
    face.forEach((v, k) =>
      points[v].forEach((x, axis) => bytes.writeFloatLE(x, 84 + 50 * i + 12 + 12 * k + 4 * axis)),
    ),
  );
  return bytes;
}

function dot(a, b) {
  return a.reduce((sum, x, i) => sum + x * b[i], 0);
}

function scaled(a, factor) {
  return a.map((x) => factor * x);
}
