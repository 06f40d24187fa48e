// Poles in the picture: a click adds one, a drag moves one, keys remove or move the selected one.
import type { Session } from './session';
import { Signal } from './signal';
import { addPole, isPole, movePole, removePole } from './state';
import type { ScreenPoint, View } from './view/View';

export class Pole_editor {
  readonly selectionChanged = new Signal<number | null>();
  selected: number | null = null;
  private dragged: number | null = null;

  constructor(
    private readonly session: Session,
    private readonly view: View | null,
  ) {
    session.opened.on(() => this.select(null));
    session.stateChanged.on((state) => {
      if (this.selected !== null && this.selected >= state.poles.length) this.select(null);
    });
  }

  select(index: number | null): void {
    this.selected = index;
    this.view?.selectPole(index);
    this.selectionChanged.emit(index);
  }

  addAt(vertex: number): void {
    const { state } = this.session;
    if (!state) return;
    const known = state.poles.findIndex((pole) => pole.vertex === vertex);
    if (known >= 0) {
      this.select(known);
      return;
    }
    void this.session.edit(addPole(state, vertex)).then((isDone) => {
      if (isDone)
        this.select(this.session.state!.poles.findIndex((pole) => pole.vertex === vertex));
    });
  }

  remove(index: number): void {
    const { state } = this.session;
    if (!state) return;
    this.select(null);
    void this.session.edit(removePole(state, index));
  }

  moveSelectedTo(vertex: number): void {
    const { state } = this.session;
    if (!state || this.selected === null || isPole(state, vertex)) return;
    void this.session.edit(movePole(state, this.selected, vertex));
  }

  grab(point: ScreenPoint, reach: number): boolean {
    const pole = this.view?.poleAt(point, reach) ?? null;
    if (pole === null) return false;
    this.select(pole);
    this.dragged = pole;
    return true;
  }

  drag(point: ScreenPoint): void {
    this.moveDragged(point, false);
  }

  drop(point: ScreenPoint): void {
    const isMoved = this.moveDragged(point, true);
    this.dragged = null;
    const { state } = this.session;
    // dropped beside the shape: where it was last
    if (!isMoved && state && this.session.isPreview) void this.session.edit(state);
  }

  abandonDrag(): void {
    this.dragged = null;
    void this.session.revert();
  }

  private moveDragged(point: ScreenPoint, isFinal: boolean): boolean {
    const { state } = this.session;
    const vertex = this.view?.vertexAt(point) ?? null;
    if (!state || vertex === null || this.dragged === null || isPole(state, vertex)) return false;
    void this.session.edit(movePole(state, this.dragged, vertex), isFinal);
    return true;
  }
}
