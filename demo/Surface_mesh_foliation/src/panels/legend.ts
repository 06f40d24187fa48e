// What the colors mean.
import { legendOf } from '../coloring';
import type { Coloring } from '../coloring';
import { element, make, swatch } from '../dom';
import { cssColor, rampColor } from '../palette';
import type { Result } from '../protocol';

export function showLegend(result: Result | null, coloring: Coloring): void {
  const box = element('legend');
  const legend = result && legendOf(result, coloring);
  box.hidden = !legend || legend.title === '';
  if (!legend) return;
  const children: Node[] = [make('div', {}, legend.title)];
  if (legend.range) {
    const ramp = make('div', { class: 'ramp' });
    const colors = [0, 0.2, 0.4, 0.6, 0.8, 1].map((t) => cssColor(rampColor(t)));
    ramp.style.background = `linear-gradient(to right, ${colors.join(', ')})`;
    const ends = legend.range.map((text) => make('span', {}, text));
    children.push(ramp, make('div', { class: 'ramp-ends' }, ...ends));
  }
  if (legend.entries.length > 0) {
    const items = legend.entries.map(({ color, label }) =>
      make('li', {}, swatch(cssColor(color)), label),
    );
    children.push(make('ul', {}, ...items));
  }
  box.replaceChildren(...children);
}
