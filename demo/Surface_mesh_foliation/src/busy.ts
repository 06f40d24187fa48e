// Progress, and the button that cancels, for what takes longer than a moment.
import { element } from './dom';
import type { Progress } from './engine';

const MOMENT = 400; // milliseconds

export class Busy {
  private readonly box = element('busy');
  private readonly stage = element('busy-stage');
  private readonly bar = element<HTMLProgressElement>('busy-bar');
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(onCancel: () => void) {
    element('cancel').addEventListener('click', onCancel);
  }

  get isShown(): boolean {
    return !this.box.hidden;
  }

  set(isBusy: boolean): void {
    document.body.dataset.busy = String(isBusy);
    if (!isBusy) {
      clearTimeout(this.timer);
      this.timer = undefined;
      this.box.hidden = true;
      this.stage.textContent = '';
      this.bar.removeAttribute('value');
      return;
    }
    this.timer ??= setTimeout(() => {
      if (!this.stage.textContent) this.stage.textContent = 'Computing';
      this.box.hidden = false;
    }, MOMENT);
  }

  progress({ stage, fraction }: Progress): void {
    this.stage.textContent = stage.charAt(0).toUpperCase() + stage.slice(1);
    if (fraction === null) this.bar.removeAttribute('value');
    else this.bar.value = fraction;
  }
}
