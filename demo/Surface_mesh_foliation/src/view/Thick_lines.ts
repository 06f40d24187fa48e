// Lines of some pixels' width with a light rim: the skeleton, and loops.
import * as THREE from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Color } from '../palette';
import { liftTowardEye } from './lift';

export interface Thick_line_style {
  width: number; // pixels
  color: Color;
  rim: Color;
  isOnTop: boolean; // drawn over everything
}

export class Thick_lines {
  readonly object = new THREE.Group();
  private readonly materials: LineMaterial[];

  constructor(style: Thick_line_style, order: number) {
    this.object.visible = false;
    this.materials = [style.width + 3, style.width].map(
      (linewidth) =>
        new LineMaterial({
          linewidth,
          depthTest: !style.isOnTop,
          depthWrite: false,
          transparent: true, // drawn after the surface, in the order of the groups
        }),
    );
    for (const material of this.materials) lift(material);
    this.setColors(style.color, style.rim);
    this.object.renderOrder = order;
  }

  setColors(color: Color, rim: Color): void {
    [rim, color].forEach((c, i) => this.materials[i].color.setRGB(...c, THREE.SRGBColorSpace));
  }

  show(segments: Float32Array): void {
    for (const child of this.object.children) (child as LineSegments2).geometry.dispose();
    this.object.clear();
    if (segments.length === 0) return;
    const geometry = plainGeometry(segments);
    this.materials.forEach((material, i) => {
      const lines = new LineSegments2(geometry as LineSegmentsGeometry, material);
      lines.renderOrder = this.object.renderOrder + 0.1 * i;
      lines.frustumCulled = false;
      this.object.add(lines);
    });
  }
}

/** What LineSegmentsGeometry draws as instances of one segment, as one geometry: where WebGL is
 *  done by the processor, each instance costs as much as a whole draw. */
function plainGeometry(segments: Float32Array): THREE.BufferGeometry {
  const one = new LineSegmentsGeometry();
  const { position, uv } = one.attributes;
  const corners = position.count;
  const count = segments.length / 6;
  const geometry = new THREE.BufferGeometry();
  const repeat = (values: ArrayLike<number>) =>
    Float32Array.from({ length: count * values.length }, (_, i) => values[i % values.length]);
  const ends = (first: number) =>
    Float32Array.from(
      { length: 3 * corners * count },
      (_, i) => segments[6 * Math.floor(i / (3 * corners)) + first + (i % 3)],
    );
  const index = one.index!.array;
  geometry.setIndex(
    new THREE.BufferAttribute(
      Uint32Array.from(
        { length: count * index.length },
        (_, i) => corners * Math.floor(i / index.length) + index[i % index.length],
      ),
      1,
    ),
  );
  geometry.setAttribute('position', new THREE.BufferAttribute(repeat(position.array), 3));
  geometry.setAttribute('uv', new THREE.BufferAttribute(repeat(uv.array), 2));
  geometry.setAttribute('instanceStart', new THREE.BufferAttribute(ends(0), 3));
  geometry.setAttribute('instanceEnd', new THREE.BufferAttribute(ends(3), 3));
  return geometry;
}

function lift(material: LineMaterial): void {
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader.replace(
      '#include <logdepthbuf_vertex>',
      `${liftTowardEye(0.002)}\n#include <logdepthbuf_vertex>`,
    );
  };
}
