// Draws a scene on a canvas: when something has changed, and only then. Without a graphics card,
// smooth edges take most of the time of a frame; there, frames are drawn without them, and again
// with them once nothing has changed for a while. Where a screen has one pixel per pixel of the
// page, the canvas keeps its size meanwhile, since a new one takes longer than a frame.
import * as THREE from 'three';
import { Smoother } from './Smoother';

const QUIET = 250; // milliseconds without change
const SOON = 40; // milliseconds
const SMOOTH_RATIO = 2; // pixels per pixel of the page, each way; nobody sees more

export class Painter {
  /** Pixels of a frame per pixel of the page have changed. */
  onRatio: (ratio: number) => void = () => {};

  private readonly renderer: THREE.WebGLRenderer;
  private readonly isSoftware = isDrawnBySoftware();
  private readonly smoother: Smoother;
  private ratio = 0; // of the last frame
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
    this.smoother = new Smoother(this.renderer);
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

  /** Something will change soon: if the canvas has to change for quick frames, it does now. */
  prepare(): void {
    if (this.renderer.getPixelRatio() !== this.quickRatio) this.drawNow();
  }

  drawNow(): void {
    this.isScheduled = false;
    clearTimeout(this.soon);
    this.soon = undefined;
    clearTimeout(this.timer);
    this.drawFrame(this.quickRatio);
    this.canvas.dataset.edges = this.isSoftware ? 'quick' : 'smooth'; // for tests and consoles
    if (this.isSoftware) this.timer = setTimeout(() => this.drawSmoothFrame(), QUIET);
  }

  /** Without smooth edges of its own, the picture has twice as many pixels. */
  picture(): Promise<Blob> {
    this.drawFrame(this.isSoftware ? SMOOTH_RATIO : this.quickRatio);
    const picture = new Promise<Blob>((resolve, reject) =>
      this.canvas.toBlob(
        (blob) => (blob ? resolve(blob) : reject(new Error('no picture'))),
        'image/png',
      ),
    );
    this.drawNow();
    return picture;
  }

  private get quickRatio(): number {
    return this.isSoftware ? 1 : screenRatio();
  }

  private drawFrame(ratio: number): void {
    if (ratio !== this.renderer.getPixelRatio()) this.renderer.setPixelRatio(ratio);
    this.setRatio(ratio);
    this.renderer.render(this.scene, this.camera);
  }

  private drawSmoothFrame(): void {
    this.canvas.dataset.edges = 'smooth';
    if (screenRatio() > 1) {
      this.drawFrame(SMOOTH_RATIO);
      return;
    }
    this.setRatio(SMOOTH_RATIO);
    this.smoother.render(this.scene, this.camera, SMOOTH_RATIO);
  }

  private setRatio(ratio: number): void {
    if (ratio === this.ratio) return;
    this.ratio = ratio;
    this.onRatio(ratio);
  }
}

function screenRatio(): number {
  return Math.min(window.devicePixelRatio || 1, SMOOTH_RATIO);
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
