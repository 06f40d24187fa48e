// The three things that a click on the picture can do, and what the hint says about each.
import { element } from './dom';
import { Signal } from './signal';

export type Tool = 'look' | 'poles' | 'loop';

const HINTS: Record<Tool, string> = {
  look: 'Point at a part to see its numbers.',
  poles: 'Click to add a pole, drag one to move it.',
  loop: 'Click around a part, vertex by vertex.',
};

export class Tools {
  readonly changed = new Signal<Tool>();
  current: Tool = 'look';
  private readonly buttons: HTMLButtonElement[];

  constructor() {
    this.buttons = [...element('tools').querySelectorAll('button')];
    this.buttons.forEach((button, i) => {
      button.addEventListener('click', () => this.choose(button.dataset.tool as Tool));
      button.addEventListener('keydown', (event) => this.step(event, i));
    });
    this.choose('look');
  }

  choose(tool: Tool): void {
    this.current = tool;
    element('stage').dataset.current = tool;
    element('hint').textContent = HINTS[tool];
    for (const button of this.buttons) {
      const isChosen = button.dataset.tool === tool;
      button.setAttribute('aria-checked', String(isChosen));
      button.tabIndex = isChosen ? 0 : -1;
    }
    this.changed.emit(tool);
  }

  /** Arrow keys choose among radio buttons. */
  private step(event: KeyboardEvent, i: number): void {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const next = this.buttons[(i + step + this.buttons.length) % this.buttons.length];
    this.choose(next.dataset.tool as Tool);
    next.focus();
  }
}
