// Colors that stay apart for color-blind eyes: those of Okabe and Ito for parts, a map from dark
// blue to yellow, which gets lighter all the way, for numbers. Red, green and blue lie between 0
// and 1.

export type Color = [number, number, number];

export const PART_COLORS: Color[] = [
  '#56b4e9', // sky blue
  '#e69f00', // orange
  '#009e73', // green
  '#f0e442', // yellow
  '#cc79a7', // purple
  '#d55e00', // vermilion
  '#0072b2', // blue
].map(parseColor);

export const PLAIN_COLOR = parseColor('#b9bec6');

const STEPS = ['#2b3a67', '#3f5f8a', '#4f8a8b', '#83b06d', '#c6cc4d', '#fdea5a'].map(parseColor);

export function parseColor(text: string): Color {
  return [1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16) / 255) as Color;
}

export function cssColor(color: Color): string {
  return `rgb(${color.map((channel) => Math.round(255 * channel)).join(' ')})`;
}

/** The color of the k-th class: after seven, the same again, lighter or darker. */
export function classColor(k: number): Color {
  const color = PART_COLORS[k % PART_COLORS.length];
  const round = Math.floor(k / PART_COLORS.length) % 3;
  if (round === 0) return color;
  return round === 1 ? mix(color, [1, 1, 1], 0.45) : mix(color, [0, 0, 0], 0.4);
}

/** The color of a number between 0 and 1. */
export function rampColor(t: number): Color {
  const x = Math.min(1, Math.max(0, t)) * (STEPS.length - 1);
  const i = Math.min(STEPS.length - 2, Math.floor(x));
  return mix(STEPS[i], STEPS[i + 1], x - i);
}

export function mix(a: Color, b: Color, t: number): Color {
  return a.map((channel, i) => channel + t * (b[i] - channel)) as Color;
}

/** A class for each arc: arcs that share a node differ as long as there are colors. */
export function classesApart(arcs: { source: number; target: number }[]): number[] {
  const count = new Array<number>(3 * PART_COLORS.length).fill(0);
  const classes: number[] = [];
  const classesAt = new Map<number, number[]>();
  for (const { source, target } of arcs) {
    const taken = [...(classesAt.get(source) ?? []), ...(classesAt.get(target) ?? [])];
    const best = leastUsedClass(count, taken);
    ++count[best];
    classes.push(best);
    for (const node of [source, target])
      classesAt.set(node, [...(classesAt.get(node) ?? []), best]);
  }
  return classes;
}

/** The pure colors come first, then those that are free, then any. */
function leastUsedClass(count: number[], taken: number[]): number {
  const all = count.map((_, k) => k);
  const free = all.filter((k) => !taken.includes(k));
  const pure = free.filter((k) => k < PART_COLORS.length);
  const candidates = [pure, free, all].find((list) => list.length > 0)!;
  return candidates.reduce((best, k) => (count[k] < count[best] ? k : best));
}
