// Undo and redo. While something is dragged, the present is a preview, which leaves no step behind.

export class History<T> {
  private past: T[] = [];
  private future: T[] = [];
  private base: T | undefined; // what was present before the preview

  constructor(private current: T) {}

  get present(): T {
    return this.current;
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  get isPreview(): boolean {
    return this.base !== undefined;
  }

  preview(state: T): void {
    this.base ??= this.current;
    this.current = state;
  }

  commit(state: T): void {
    this.past.push(this.base ?? this.current);
    this.base = undefined;
    this.current = state;
    this.future = [];
  }

  /** Ends a preview without a step. */
  revert(): void {
    this.current = this.base ?? this.current;
    this.base = undefined;
  }

  undo(): boolean {
    return this.step(this.past, this.future);
  }

  redo(): boolean {
    return this.step(this.future, this.past);
  }

  /** Takes the last step back for good: it was refused. */
  drop(): boolean {
    this.revert();
    const before = this.past.pop();
    if (before === undefined) return false;
    this.current = before;
    return true;
  }

  private step(from: T[], to: T[]): boolean {
    this.revert();
    const next = from.pop();
    if (next === undefined) return false;
    to.push(this.current);
    this.current = next;
    return true;
  }
}
