// The colors of arcs, and so of their parts, and what they mean.
import { PLAIN_COLOR, classColor, classesApart, rampColor } from './palette';
import type { Color } from './palette';
import type { GraphArc, Result } from './protocol';

export type Coloring = 'parts' | 'symmetry' | 'modulus' | 'flux' | 'plain';

export interface Legend {
  title: string;
  entries: { color: Color; label: string }[];
  range: [string, string] | null; // of numbers, from the darkest to the lightest color
}

export function arcColors(result: Result, coloring: Coloring): Color[] {
  const { arcs } = result;
  switch (coloring) {
    case 'plain':
      return arcs.map(() => PLAIN_COLOR);
    case 'symmetry': {
      const order = symmetryOrder(arcs);
      return arcs.map((arc) => classColor(order.indexOf(arc.symmetry)));
    }
    case 'modulus':
    case 'flux':
      return numberColors(arcs.map((arc) => arc[coloring]));
    case 'parts':
      return partColors(arcs);
  }
}

/** Parts that meet differ as long as there are colors. */
export function partColors(arcs: { source: number; target: number }[]): Color[] {
  return classesApart(arcs).map(classColor);
}

export function legendOf(result: Result, coloring: Coloring): Legend {
  const colors = arcColors(result, coloring);
  if (coloring === 'symmetry') {
    const entries = symmetryOrder(result.arcs).map((symmetry) => {
      const alike = result.arcs.filter((arc) => arc.symmetry === symmetry);
      return {
        color: colors[result.arcs.indexOf(alike[0])],
        label: alike.map((arc) => arc.id + 1).join(', '),
      };
    });
    return { title: 'Parts that are alike', entries, range: null };
  }
  if (coloring === 'modulus' || coloring === 'flux') {
    const values = result.arcs.map((arc) => arc[coloring]).filter(isNumber);
    const title = coloring === 'modulus' ? 'Modulus of the loop' : 'Flux';
    if (values.length === 0) return { title: `${title}: none is known`, entries: [], range: null };
    const range: [string, string] = [short(Math.min(...values)), short(Math.max(...values))];
    const unknown = result.arcs.some((arc) => !isNumber(arc[coloring]));
    const entries = unknown ? [{ color: PLAIN_COLOR, label: 'at a pole: none' }] : [];
    return { title, entries, range };
  }
  return { title: '', entries: [], range: null };
}

/** Four digits at most, for people. */
export function short(value: number): string {
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 10000 || size < 0.001) return value.toExponential(1);
  return String(Number(value.toPrecision(3)));
}

function symmetryOrder(arcs: GraphArc[]): number[] {
  return [...new Set(arcs.map((arc) => arc.symmetry))];
}

/** By logarithm, since moduli and fluxes are ratios. */
function numberColors(values: (number | null)[]): Color[] {
  const logs = values.filter(isNumber).map(Math.log);
  const least = Math.min(...logs);
  const span = Math.max(...logs) - least || 1;
  return values.map((value) =>
    isNumber(value) ? rampColor((Math.log(value) - least) / span) : PLAIN_COLOR,
  );
}

function isNumber(value: number | null): value is number {
  return value !== null && Number.isFinite(value) && value > 0;
}
