// The part under the pointer, or the one that is kept: its numbers, and its color in the picture.
import { arcColors, short } from './coloring';
import type { Coloring } from './coloring';
import { element, make, swatch } from './dom';
import { cssColor } from './palette';
import type { GraphArc, Result } from './protocol';
import { Signal } from './signal';
import type { View } from './view/View';

export class Part_card {
  readonly changed = new Signal<number | null>();
  coloring: Coloring = 'parts';

  private result: Result | null = null;
  private kept: number | null = null;
  private hovered: number | null = null;
  private readonly card = element('part-card');

  constructor(private readonly view: View | null) {}

  setResult(result: Result | null): void {
    this.result = result;
    this.kept = null;
    this.hovered = null;
    this.show();
  }

  hover(arc: number | null): void {
    if (arc === this.hovered) return;
    this.hovered = arc;
    this.show();
  }

  /** Keeps a part until another one, or the same again, is chosen. */
  keep(arc: number | null): void {
    this.kept = arc === this.kept ? null : arc;
    this.hovered = null;
    this.show();
  }

  show(): void {
    const shown = this.hovered ?? this.kept;
    const arc = shown === null ? undefined : this.result?.arcs[shown];
    this.view?.highlight(arc ? shown : null);
    this.changed.emit(arc ? shown : null);
    this.card.hidden = !arc;
    if (!arc || !this.result) return;
    const color = arcColors(this.result, this.coloring)[arc.id];
    const title = make('h2', {}, swatch(cssColor(color)), `Part ${arc.id + 1}: ${arc.component}`);
    const list = make('dl', {});
    for (const [name, value] of numbersOf(arc, this.result))
      list.append(make('dt', {}, name), make('dd', {}, value));
    this.card.replaceChildren(title, list);
  }
}

export function numbersOf(arc: GraphArc, result: Result): [string, string][] {
  const total = result.arcs.reduce((sum, { area }) => sum + area, 0);
  const share = total > 0 ? ` (${Math.round((100 * arc.area) / total)} %)` : '';
  const alike = result.arcs.filter(
    (other) => other.symmetry === arc.symmetry && other.id !== arc.id,
  );
  const numbers: [string, string][] = [
    ['Area', short(arc.area) + share],
    ['Length', short(arc.length)],
    ['Height', short(arc.height)],
    ['Flux', short(arc.flux)],
  ];
  if (arc.modulus !== null) numbers.push(['Modulus', short(arc.modulus)]);
  if (arc.margin !== null) numbers.push(['Margin', short(arc.margin)]);
  if (alike.length > 0) numbers.push(['Like', alike.map(({ id }) => id + 1).join(', ')]);
  return numbers;
}
