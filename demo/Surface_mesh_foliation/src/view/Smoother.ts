// Frames with smooth edges where WebGL has none: drawn with more pixels than the canvas has, of
// which each pixel of the canvas is a mean.
import * as THREE from 'three';
import { FullScreenQuad } from 'three/addons/postprocessing/Pass.js';

const vertexShader = `
  varying vec2 place;
  void main() {
    place = uv;
    gl_Position = vec4(position.xy, 0.0, 1.0);
  }`;

const fragmentShader = `
  uniform sampler2D map;
  varying vec2 place;
  void main() {
    gl_FragColor = texture2D(map, place);
  }`;

export class Smoother {
  private readonly target: THREE.WebGLRenderTarget;
  private readonly toCanvas: FullScreenQuad;

  constructor(private readonly renderer: THREE.WebGLRenderer) {
    // numbers in the target are those that a canvas has: there, too, colors are mixed as they are
    this.target = new THREE.WebGLRenderTarget(1, 1, {
      internalFormat: 'RGBA8',
      colorSpace: THREE.SRGBColorSpace,
    });
    Object.assign(this.target, { isXRRenderTarget: true }); // three's name for such targets
    const material = new THREE.ShaderMaterial({
      vertexShader,
      fragmentShader,
      uniforms: { map: { value: this.target.texture } },
      depthTest: false,
      depthWrite: false,
    });
    this.toCanvas = new FullScreenQuad(material);
  }

  /** With `ratio` times as many pixels each way as the canvas has: 2, for a mean of four. */
  render(scene: THREE.Scene, camera: THREE.Camera, ratio: number): void {
    const { renderer, target } = this;
    const size = renderer.getDrawingBufferSize(new THREE.Vector2()).multiplyScalar(ratio);
    target.setSize(size.x, size.y);
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    renderer.setRenderTarget(null);
    this.toCanvas.render(renderer);
  }
}
