// The steps of the detail slider: bounds for moduli, each of which keeps some loops more than the
// step before. Loops of nearly equal moduli come together.
import type { HierarchyLoop } from './protocol';

export interface Detail_step {
  detail: number; // a loop is kept if its modulus is at least this
  kept: number; // how many loops are
}

const NEARLY_EQUAL = 1.001;

/** From the fewest loops to all of them; loops come with the largest modulus first. */
export function detailSteps(loops: HierarchyLoop[]): Detail_step[] {
  const moduli = loops.map(({ modulus }) => modulus);
  const steps: Detail_step[] = [{ detail: moduli.length ? rounded(2 * moduli[0]) : 1, kept: 0 }];
  moduli.forEach((modulus, i) => {
    const next = moduli[i + 1];
    if (next === undefined) steps.push({ detail: 0, kept: i + 1 });
    else if (modulus > NEARLY_EQUAL * next)
      steps.push({ detail: rounded(Math.sqrt(modulus * next)), kept: i + 1 });
  });
  return steps;
}

/** The step that keeps the same loops as a bound. */
export function stepOf(steps: Detail_step[], loops: HierarchyLoop[], detail: number): number {
  const kept = loops.filter(({ modulus }) => modulus >= detail).length;
  const step = steps.findIndex((s) => s.kept >= kept);
  return step < 0 ? steps.length - 1 : step;
}

/** Short in a link, and still between two moduli that are not nearly equal. */
function rounded(value: number): number {
  return Number(value.toPrecision(5));
}

/** The loops that a bound leaves: those that are narrow enough, and those that handles need. */
export function keptLoops(loops: HierarchyLoop[], detail: number): HierarchyLoop[] {
  return loops.filter((loop) => loop.modulus >= detail || loop.cutsHandle);
}
