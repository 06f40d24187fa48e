// What the page says: notices, which go by themselves, and problems, which stay until they are
// closed or a newer one comes.
import { icon, make } from './dom';

const NOTICE_TIME = 6000; // milliseconds

export class Messages {
  private problem: HTMLElement | null = null;

  constructor(private readonly place: HTMLElement) {}

  notice(text: string): void {
    const message = this.add(text, false);
    setTimeout(() => message.remove(), NOTICE_TIME);
  }

  showProblem(text: string, action?: { label: string; act: () => void }): void {
    this.clearProblem();
    this.problem = this.add(text, true, action);
  }

  clearProblem(): void {
    this.problem?.remove();
    this.problem = null;
  }

  private add(
    text: string,
    isProblem: boolean,
    action?: { label: string; act: () => void },
  ): HTMLElement {
    const close = make(
      'button',
      { class: 'icon', 'aria-label': 'Close', title: 'Close' },
      icon('remove'),
    );
    const message = make(
      'div',
      { class: isProblem ? 'message fault' : 'message' },
      make('p', {}, text),
    );
    if (isProblem) message.setAttribute('role', 'alert');
    if (action) {
      const button = make('button', {}, action.label);
      button.addEventListener('click', () => {
        message.remove();
        action.act();
      });
      message.append(button);
    }
    close.addEventListener('click', () => message.remove());
    message.append(close);
    this.place.append(message);
    return message;
  }
}
