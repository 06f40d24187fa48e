// What can wait: after an edit the picture comes first, and laying out text would delay it.

const LATER = 100; // milliseconds

export class Later {
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly act: () => void) {}

  soon(): void {
    this.timer ??= setTimeout(() => this.now(), LATER);
  }

  now(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.act();
  }
}
