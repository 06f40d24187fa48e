// Draws a scene on a canvas: when something has changed, and only then. Without a graphics card,
// smooth edges take most of the time of a frame; there, frames are drawn without them, and again
// with them once nothing has changed for a while.
import * as THREE from 'three';

const QUIET = 250; // milliseconds without change
const SOON = 40; // milliseconds

export class Painter {
  /** Pixels of the canvas per pixel of the page have changed. */
  onRatio: (ratio: number) => void = () => {};

  private readonly renderer: THREE.WebGLRenderer;
  private readonly isSoftware = isDrawnBySoftware();
  private isScheduled = false;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private soon: ReturnType<typeof setTimeout> | undefined;

  /** Throws if there is no WebGL. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly scene: THREE.Scene,
    private readonly camera: THREE.PerspectiveCamera,
  ) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: !this.isSoftware });
    this.setRatio(this.quickRatio);
  }

  get ratio(): number {
    return this.renderer.getPixelRatio();
  }

  setSize(width: number, height: number): void {
    this.renderer.setSize(width, height, true);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.drawNow();
  }

  /** Draws with the next frame of the page. */
  draw(): void {
    if (this.isScheduled) return;
    this.isScheduled = true;
    requestAnimationFrame(() => {
      if (this.isScheduled) this.drawNow();
    });
  }

  /** Draws soon, unless there is something else to draw before: where frames take long, what comes
   *  next need not wait for this one. */
  drawSoon(): void {
    if (this.isSoftware) this.soon ??= setTimeout(() => this.draw(), SOON);
    else this.draw();
  }

  /** Something will change soon: the change of the canvas to quick frames takes place now. */
  prepare(): void {
    if (this.ratio !== this.quickRatio) this.drawNow();
  }

  drawNow(): void {
    this.isScheduled = false;
    clearTimeout(this.soon);
    this.soon = undefined;
    clearTimeout(this.timer);
    this.render(this.quickRatio);
    if (this.isSoftware) this.timer = setTimeout(() => this.render(this.smoothRatio), QUIET);
  }

  picture(): Promise<Blob> {
    this.render(this.smoothRatio);
    return new Promise((resolve, reject) =>
      this.canvas.toBlob(
        (blob) => (blob ? resolve(blob) : reject(new Error('no picture'))),
        'image/png',
      ),
    );
  }

  private get quickRatio(): number {
    return this.isSoftware ? 1 : Math.min(window.devicePixelRatio || 1, 2);
  }

  /** Without smooth edges of its own, the picture is scaled down from twice its size. */
  private get smoothRatio(): number {
    return this.isSoftware ? 2 : this.quickRatio;
  }

  private setRatio(ratio: number): void {
    if (ratio === this.ratio) return;
    this.renderer.setPixelRatio(ratio);
    this.onRatio(ratio);
  }

  private render(ratio: number): void {
    this.setRatio(ratio);
    this.renderer.render(this.scene, this.camera);
  }
}

/** Whether WebGL is done by the processor: SwiftShader in Chromium, llvmpipe in Mesa, WARP. */
function isDrawnBySoftware(): boolean {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return false;
  const names = gl.getExtension('WEBGL_debug_renderer_info');
  const name: unknown = gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(String(name));
}
