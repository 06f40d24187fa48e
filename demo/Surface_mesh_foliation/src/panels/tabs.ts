// Tabs, as the ARIA practices describe them: arrow keys choose, one panel is shown.
import { element } from '../dom';

export class Tabs {
  private readonly tabs = [...element('tabs').querySelectorAll<HTMLButtonElement>('[role=tab]')];

  constructor() {
    this.tabs.forEach((tab, i) => {
      tab.addEventListener('click', () => this.choose(i));
      tab.addEventListener('keydown', (event) => this.step(event, i));
    });
  }

  open(name: string): void {
    this.choose(this.tabs.findIndex((tab) => tab.id === `tab-${name}`));
  }

  private choose(chosen: number): void {
    this.tabs.forEach((tab, i) => {
      tab.setAttribute('aria-selected', String(i === chosen));
      tab.tabIndex = i === chosen ? 0 : -1;
      element(tab.getAttribute('aria-controls')!).hidden = i !== chosen;
    });
  }

  private step(event: KeyboardEvent, i: number): void {
    const last = this.tabs.length - 1;
    const next = {
      ArrowRight: i === last ? 0 : i + 1,
      ArrowLeft: i === 0 ? last : i - 1,
      Home: 0,
      End: last,
    }[event.key];
    if (next === undefined) return;
    event.preventDefault();
    this.choose(next);
    this.tabs[next].focus();
  }
}
