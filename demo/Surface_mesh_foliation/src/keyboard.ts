// Keys of the whole page, and those of the picture when it has the focus.
import { isTyping } from './dom';

export interface Key_actions {
  undo(): void;
  redo(): void;
  open(): void;
  save(): void;
  help(): void;
  chooseLook(): void;
  choosePoles(): void;
  chooseLoop(): void;
  frame(): void;
  turn(right: number, up: number): void;
  zoom(factor: number): void;
  clickAtCenter(): void;
  moveToCenter(): void;
  remove(): void;
  takeBack(): void;
  finish(): void;
  escape(): void;
}

const STEP = Math.PI / 36;

export function listenToKeys(canvas: HTMLElement, actions: Key_actions): void {
  const everywhere: Record<string, () => void> = {
    o: actions.open,
    d: actions.save,
    '?': actions.help,
    v: actions.chooseLook,
    p: actions.choosePoles,
    l: actions.chooseLoop,
    f: actions.frame,
    Escape: actions.escape,
  };
  const inPicture: Record<string, () => void> = {
    ArrowLeft: () => actions.turn(-STEP, 0),
    ArrowRight: () => actions.turn(STEP, 0),
    ArrowUp: () => actions.turn(0, -STEP),
    ArrowDown: () => actions.turn(0, STEP),
    '+': () => actions.zoom(1.1),
    '=': () => actions.zoom(1.1),
    '-': () => actions.zoom(1 / 1.1),
    ' ': actions.clickAtCenter,
    m: actions.moveToCenter,
    Delete: actions.remove,
    Backspace: actions.takeBack,
    Enter: actions.finish,
  };

  document.addEventListener('keydown', (event) => {
    if (document.querySelector('dialog[open]')) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (event.ctrlKey || event.metaKey) {
      if (key === 'z' && !isTyping(event.target))
        run(event, event.shiftKey ? actions.redo : actions.undo);
      if (key === 'y' && !isTyping(event.target)) run(event, actions.redo);
      return;
    }
    if (event.altKey) return;
    if (event.target === canvas && inPicture[key]) run(event, inPicture[key]);
    else if (everywhere[key] && (!isTyping(event.target) || key === 'Escape'))
      run(event, everywhere[key]);
  });
}

function run(event: KeyboardEvent, act: () => void): void {
  event.preventDefault();
  act();
}
