// Lists of poles and loops, with their heights.
import { short } from '../coloring';
import { element, icon, make } from '../dom';
import type { Pole_editor } from '../poles';
import type { Loop, Result, State } from '../protocol';
import type { Session } from '../session';
import { LARGEST_HEIGHT, LEAST_HEIGHT, removeLoop, setLoopHeight, setPoleHeight } from '../state';

export class Edit_panel {
  private readonly poles = element('poles');
  private readonly loops = element('loops');
  private shownPoles = '';
  private shownLoops = '';

  constructor(
    private readonly session: Session,
    private readonly editor: Pole_editor,
  ) {
    session.stateChanged.on((state) => this.showPoles(state));
    session.resultChanged.on((result) => this.showLoops(result));
    editor.selectionChanged.on((index) => this.markPole(index));
    element('find-poles').addEventListener('click', () => void this.findPoles());
  }

  /** Lists are made anew if items come or go: a slider that is being dragged must stay. */
  private showPoles(state: State): void {
    const key = state.poles.map((pole) => pole.vertex).join();
    if (key !== this.shownPoles) {
      this.shownPoles = key;
      const items = state.poles.map((_, i) => this.poleItem(i));
      replaceItems(this.poles, items.length > 0 ? items : [nothing('There are none.')]);
    }
    state.poles.forEach((pole, i) => {
      const item = this.poles.children[i];
      item.querySelector('.name')!.textContent = `Pole ${i + 1}`;
      item.querySelector('.name')!.setAttribute('title', `Vertex ${pole.vertex}`);
      setSlider(item, pole.height);
    });
    this.markPole(this.editor.selected);
  }

  private showLoops(result: Result | null): void {
    const loops = result?.state.loops ?? [];
    const key = loops.map((loop) => loop.vertices.join()).join(';');
    if (key !== this.shownLoops || loops.length === 0) {
      this.shownLoops = key;
      const items = loops.map((_, i) => this.loopItem(i));
      const none = nothing('There are none. Choose Loop beside the picture to draw one.');
      replaceItems(this.loops, items.length > 0 ? items : [none]);
    }
    loops.forEach((loop, i) => {
      const item = this.loops.children[i];
      item.querySelector('.name')!.textContent = loopName(loop, i);
      setSlider(item, loop.height);
    });
  }

  private poleItem(i: number): HTMLLIElement {
    const name = make('button', { class: 'name', 'aria-pressed': 'false' });
    name.addEventListener('click', () => this.editor.select(this.editor.selected === i ? null : i));
    name.addEventListener('keydown', (event) => {
      if (event.key === 'Delete') this.editor.remove(i);
    });
    const item = makeItem(name, `pole ${i + 1}`, () => this.editor.remove(i));
    onHeight(item, (height, isFinal) => {
      const { state } = this.session;
      if (state) void this.session.edit(setPoleHeight(state, i, height), isFinal);
    });
    return item;
  }

  private loopItem(i: number): HTMLLIElement {
    const used = () => this.session.result?.state.loops ?? [];
    const item = makeItem(make('span', { class: 'name' }), `loop ${i + 1}`, () => {
      const { state } = this.session;
      if (state) void this.session.edit(removeLoop(state, used(), i));
    });
    onHeight(item, (height, isFinal) => {
      const { state } = this.session;
      if (state) void this.session.edit(setLoopHeight(state, used(), i, height), isFinal);
    });
    return item;
  }

  private markPole(index: number | null): void {
    [...this.poles.querySelectorAll('.name')].forEach((name, i) =>
      name.setAttribute('aria-pressed', String(i === index)),
    );
  }

  private async findPoles(): Promise<void> {
    const { state } = this.session;
    if (!state) return;
    try {
      const { poles } = await this.session.engine.findPoles();
      await this.session.edit({ ...state, poles });
    } catch (error) {
      this.session.report(error);
    }
  }
}

function loopName(loop: Loop, i: number): string {
  return `Loop ${i + 1}, ${loop.found ? 'found' : 'drawn'}`;
}

/** The focus stays where it was in the list, or at its end. */
function replaceItems(list: HTMLElement, items: HTMLLIElement[]): void {
  const focused = document.activeElement;
  const i = [...list.children].findIndex((item) => item.contains(focused));
  const place = i < 0 ? -1 : [...list.children[i].children].indexOf(focused!);
  list.replaceChildren(...items);
  if (place >= 0) (items[Math.min(i, items.length - 1)].children[place] as HTMLElement)?.focus();
}

function nothing(text: string): HTMLLIElement {
  return make('li', { class: 'none' }, text);
}

/** A slider of heights is logarithmic. */
function makeItem(name: HTMLElement, what: string, onRemove: () => void): HTMLLIElement {
  const slider = make('input', {
    type: 'range',
    min: String(Math.log10(LEAST_HEIGHT)),
    max: String(Math.log10(LARGEST_HEIGHT)),
    step: '0.05',
    'aria-label': `Height of ${what}`,
    title: 'Height',
  });
  const remove = make(
    'button',
    { class: 'icon', 'aria-label': `Remove ${what}`, title: 'Remove' },
    icon('remove'),
  );
  remove.addEventListener('click', onRemove);
  return make('li', {}, name, slider, make('output'), remove);
}

function onHeight(item: HTMLLIElement, act: (height: number, isFinal: boolean) => void): void {
  const slider = item.querySelector('input')!;
  const height = () => Number((10 ** Number(slider.value)).toPrecision(3));
  slider.addEventListener('input', () => act(height(), false));
  slider.addEventListener('change', () => act(height(), true));
}

function setSlider(item: Element, height: number): void {
  const slider = item.querySelector('input')!;
  if (!slider.matches(':active')) slider.value = String(Math.log10(height));
  item.querySelector('output')!.textContent = short(height);
  slider.setAttribute('aria-valuetext', short(height));
}
