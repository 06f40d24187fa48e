// The surface: each part has vertices of its own, so that colors have sharp borders, with normals
// of the whole surface. Colors are looked up by part, so a new coloring changes a few numbers only.
import * as THREE from 'three';
import type { Color } from '../palette';
import { boxOf } from './frame';

const PALETTE_WIDTH = 256;

export class Surface {
  readonly mesh: THREE.Mesh;
  private readonly geometry = new THREE.BufferGeometry();
  private palette = new THREE.DataTexture(new Float32Array(4 * PALETTE_WIDTH), PALETTE_WIDTH, 1);
  private readonly paletteUniform = { value: this.palette };
  private bodyBox: THREE.Box3 | null = null;

  constructor() {
    const material = new THREE.MeshLambertMaterial({
      side: THREE.DoubleSide,
      polygonOffset: true, // what is drawn on the surface is in front of it
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    material.onBeforeCompile = (shader) => {
      shader.uniforms.palette = this.paletteUniform;
      shader.vertexShader = shader.vertexShader
        .replace(
          '#include <common>',
          `#include <common>
           attribute float part;
           uniform sampler2D palette;
           varying vec3 partColor;`,
        )
        .replace(
          '#include <color_vertex>',
          `#include <color_vertex>
           int index = int(part + 0.5);
           ivec2 place = ivec2(index % ${PALETTE_WIDTH}, index / ${PALETTE_WIDTH});
           partColor = texelFetch(palette, place, 0).rgb;`,
        );
      shader.fragmentShader = shader.fragmentShader
        .replace('#include <common>', '#include <common>\nvarying vec3 partColor;')
        .replace(
          '#include <color_fragment>',
          '#include <color_fragment>\ndiffuseColor.rgb *= partColor;',
        );
    };
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.onBeforeRender = (_renderer, _scene, camera) => {
      material.side = this.isBodyOutsideOf(camera) ? THREE.FrontSide : THREE.DoubleSide;
    };
  }

  /** Of a closed surface, nobody outside sees triangles from behind: they are not drawn, which
   *  saves a third of the time of a frame where WebGL is done by the processor. */
  setBody(positions: Float64Array, triangles: Uint32Array, numberOfEdges: number): void {
    const isBody = enclosesBody(positions, triangles, numberOfEdges);
    this.bodyBox = isBody ? boxOf(positions) : null;
  }

  private isBodyOutsideOf(camera: THREE.Camera): boolean {
    if (!this.bodyBox) return false;
    const { near } = camera as THREE.PerspectiveCamera;
    return this.bodyBox.distanceToPoint(camera.position) > 2 * near; // which cuts nothing open
  }

  show(positions: Float64Array, triangles: Uint32Array, parts: Uint32Array | null): void {
    const normals = vertexNormals(positions, triangles);
    const { index, vertexOf, partOf } = verticesByPart(triangles, parts, positions.length / 3);
    const position = new Float32Array(3 * vertexOf.length);
    const normal = new Float32Array(3 * vertexOf.length);
    vertexOf.forEach((vertex, i) => {
      for (let k = 0; k < 3; ++k) {
        position[3 * i + k] = positions[3 * vertex + k];
        normal[3 * i + k] = normals[3 * vertex + k];
      }
    });
    this.geometry.dispose();
    this.geometry.setIndex(new THREE.BufferAttribute(index, 1));
    this.geometry.setAttribute('position', new THREE.BufferAttribute(position, 3));
    this.geometry.setAttribute('normal', new THREE.BufferAttribute(normal, 3));
    this.geometry.setAttribute('part', new THREE.BufferAttribute(Float32Array.from(partOf), 1));
  }

  setColors(colors: Color[]): void {
    const rows = Math.max(1, Math.ceil(colors.length / PALETTE_WIDTH));
    const data = new Float32Array(4 * PALETTE_WIDTH * rows);
    const linear = new THREE.Color();
    colors.forEach(([r, g, b], i) => {
      linear.setRGB(r, g, b, THREE.SRGBColorSpace).toArray(data, 4 * i);
    });
    this.palette.dispose();
    this.palette = new THREE.DataTexture(
      data,
      PALETTE_WIDTH,
      rows,
      THREE.RGBAFormat,
      THREE.FloatType,
    );
    this.palette.needsUpdate = true;
    this.paletteUniform.value = this.palette;
  }
}

/** Whether a surface is closed and its triangles face outward. */
export function enclosesBody(
  positions: ArrayLike<number>,
  triangles: Uint32Array,
  numberOfEdges: number,
): boolean {
  if (2 * numberOfEdges !== triangles.length) return false;
  const [ox, oy, oz] = [positions[0], positions[1], positions[2]];
  let volume = 0; // six times that of the tetrahedra between the first vertex and the triangles
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t];
    const b = 3 * triangles[t + 1];
    const c = 3 * triangles[t + 2];
    const [ax, ay, az] = [positions[a] - ox, positions[a + 1] - oy, positions[a + 2] - oz];
    const [bx, by, bz] = [positions[b] - ox, positions[b + 1] - oy, positions[b + 2] - oz];
    const [cx, cy, cz] = [positions[c] - ox, positions[c + 1] - oy, positions[c + 2] - oz];
    volume += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return volume > 0;
}

/** A copy of each vertex for each part that meets there: triangles of copies, what they copy. */
export function verticesByPart(
  triangles: Uint32Array,
  parts: Uint32Array | null,
  numberOfVertices: number,
): { index: Uint32Array; vertexOf: number[]; partOf: number[] } {
  const vertexOf: number[] = [];
  const partOf: number[] = [];
  const nextCopy: number[] = []; // of the same vertex, or -1
  const lastCopy = new Int32Array(numberOfVertices).fill(-1);
  const index = triangles.map((vertex, corner) => {
    const part = parts ? parts[Math.floor(corner / 3)] : 0;
    let copy = lastCopy[vertex];
    while (copy >= 0 && partOf[copy] !== part) copy = nextCopy[copy];
    if (copy >= 0) return copy;
    nextCopy.push(lastCopy[vertex]);
    partOf.push(part);
    lastCopy[vertex] = vertexOf.length;
    return vertexOf.push(vertex) - 1;
  });
  return { index, vertexOf, partOf };
}

/** Sums of the normals of faces, weighted by area. */
function vertexNormals(positions: Float64Array, triangles: Uint32Array): Float32Array {
  const normals = new Float32Array(positions.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t];
    const b = 3 * triangles[t + 1];
    const c = 3 * triangles[t + 2];
    const ux = positions[b] - positions[a];
    const uy = positions[b + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a];
    const vy = positions[c + 1] - positions[a + 1];
    const vz = positions[c + 2] - positions[a + 2];
    const nx = uy * vz - uz * vy;
    const ny = uz * vx - ux * vz;
    const nz = ux * vy - uy * vx;
    for (const vertex of [a, b, c]) {
      normals[vertex] += nx;
      normals[vertex + 1] += ny;
      normals[vertex + 2] += nz;
    }
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
    normals[i] /= length;
    normals[i + 1] /= length;
    normals[i + 2] /= length;
  }
  return normals;
}
