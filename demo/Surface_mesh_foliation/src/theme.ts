// Dark or light: as the system prefers, until the switch is used. The colors of the picture follow.
import { parseColor } from './palette';
import { Signal } from './signal';
import type { Ink } from './view/View';

export type Theme = 'light' | 'dark';

const KEY = 'theme';

export class Theme_switch {
  readonly changed = new Signal<Theme>();
  current: Theme;

  constructor(private readonly root: HTMLElement) {
    const dark = window.matchMedia('(prefers-color-scheme: dark)');
    const chosen = remembered();
    this.current = chosen ?? (dark.matches ? 'dark' : 'light');
    this.apply();
    dark.addEventListener('change', () => {
      if (!remembered()) this.set(dark.matches ? 'dark' : 'light');
    });
  }

  toggle(): void {
    const next = this.current === 'dark' ? 'light' : 'dark';
    remember(next);
    this.set(next);
  }

  private set(theme: Theme): void {
    this.current = theme;
    this.apply();
    this.changed.emit(theme);
  }

  private apply(): void {
    this.root.dataset.theme = this.current;
  }
}

export function inkOf(theme: Theme): Ink {
  const isDark = theme === 'dark';
  return {
    background: parseColor(isDark ? '#1e232c' : '#f4f5f7'),
    line: parseColor(isDark ? '#ffffff' : '#1d2430'),
    rim: parseColor(isDark ? '#1d2430' : '#ffffff'),
    pole: parseColor('#1d2430'),
    accent: parseColor('#b0127b'),
    fault: parseColor('#d40000'),
  };
}

// storage may be forbidden; then the choice lasts as long as the page
function remembered(): Theme | null {
  try {
    const theme = localStorage.getItem(KEY);
    return theme === 'dark' || theme === 'light' ? theme : null;
  } catch {
    return null;
  }
}

function remember(theme: Theme): void {
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    // nothing is lost but the memory of it
  }
}
