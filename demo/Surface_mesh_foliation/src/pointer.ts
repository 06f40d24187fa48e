// Pointer events of the picture as hovers, clicks and drags. A drag that grabs nothing turns the
// camera.
import type { ScreenPoint } from './view/View';

export interface Pointer_actions {
  hover(point: ScreenPoint | null): void;
  click(point: ScreenPoint, isTouch: boolean): void;
  /** Whether a drag that begins here grabs something. */
  grab(point: ScreenPoint, isTouch: boolean): boolean;
  drag(point: ScreenPoint): void;
  drop(point: ScreenPoint): void;
  abandonDrag(): void;
}

/** Pixels that a pointer may move during a click. */
const STILL = 5;

export function listenToPointer(
  canvas: HTMLCanvasElement,
  actions: Pointer_actions,
  setTurning: (isOn: boolean) => void,
): void {
  let down: ScreenPoint | null = null;
  let hasMoved = false;
  let hasGrabbed = false;
  let fingers = 0;
  let hovered: ScreenPoint | null = null;

  const at = (event: PointerEvent): ScreenPoint => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };

  const hoverLater = (point: ScreenPoint) => {
    const isWaiting = hovered !== null;
    hovered = point;
    if (isWaiting) return;
    requestAnimationFrame(() => {
      if (hovered && !down) actions.hover(hovered);
      hovered = null;
    });
  };

  const end = () => {
    down = null;
    hasGrabbed = false;
    setTurning(true);
  };

  canvas.addEventListener(
    'pointerdown',
    (event) => {
      ++fingers;
      if (fingers > 1) {
        // two fingers zoom: what one finger began is off
        if (hasGrabbed) actions.abandonDrag();
        end();
        return;
      }
      if (event.button !== 0) return;
      down = at(event);
      hasMoved = false;
      hasGrabbed = actions.grab(down, event.pointerType === 'touch');
      setTurning(!hasGrabbed);
      if (hasGrabbed) canvas.setPointerCapture(event.pointerId);
    },
    { capture: true }, // before the controls of the camera
  );

  canvas.addEventListener('pointermove', (event) => {
    const point = at(event);
    if (!down) {
      if (event.pointerType !== 'touch') hoverLater(point);
      return;
    }
    if (Math.hypot(point.x - down.x, point.y - down.y) > STILL) hasMoved = true;
    if (hasGrabbed && hasMoved) actions.drag(point);
  });

  canvas.addEventListener('pointerup', (event) => {
    fingers = Math.max(0, fingers - 1);
    if (!down) return;
    const point = at(event);
    if (hasGrabbed && hasMoved) actions.drop(point);
    else if (!hasMoved) actions.click(point, event.pointerType === 'touch');
    end();
  });

  canvas.addEventListener('pointercancel', () => {
    fingers = Math.max(0, fingers - 1);
    if (hasGrabbed) actions.abandonDrag();
    end();
  });

  canvas.addEventListener('pointerleave', () => {
    hovered = null;
    if (!down) actions.hover(null);
  });
}
