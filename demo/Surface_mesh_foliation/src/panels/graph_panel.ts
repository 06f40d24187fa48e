// Which loops there are, how many, and the graph that they make.
import { arcColors, short } from '../coloring';
import type { Coloring } from '../coloring';
import { detailSteps, keptLoops, stepOf } from '../detail_steps';
import type { Detail_step } from '../detail_steps';
import { element, make, setText, swatch } from '../dom';
import { cssColor } from '../palette';
import type { Part_card } from '../part_card';
import type { GraphNode, Result, State } from '../protocol';
import type { Session } from '../session';
import { setDetail, setMode } from '../state';
import type { View } from '../view/View';

const MODE_TEXTS: Record<State['mode'], string> = {
  star: 'Poles only, and loops that handles need.',
  canonical: 'Loops around parts that are narrow enough: the shape decides.',
  all: 'All loops, until no node has more than three arcs.',
  given: 'The loops that are listed under Edit, and no others.',
};

export class Graph_panel {
  private readonly modes = [...document.querySelectorAll<HTMLInputElement>('#modes input')];
  private readonly slider = element<HTMLInputElement>('detail');
  private readonly rows = element('arcs').querySelector('tbody')!;
  private steps: Detail_step[] = [];

  constructor(
    private readonly session: Session,
    private readonly view: View | null,
    private readonly card: Part_card,
  ) {
    for (const input of this.modes)
      input.addEventListener('change', () => this.chooseMode(input.value as State['mode']));
    this.slider.addEventListener('input', () => this.slide(false));
    this.slider.addEventListener('change', () => this.slide(true));
    for (const comes of ['pointerenter', 'focus'])
      this.slider.addEventListener(comes, () => this.solveAhead());
    session.stateChanged.on((state) => this.showState(state));
    session.hierarchyChanged.on(() => this.showSteps());
    card.changed.on((arc) => this.markRow(arc));
  }

  showResult(result: Result | null, coloring: Coloring): void {
    this.view?.forceLoops('slider', false);
    element('summary').textContent = result ? summaryOf(result) : '';
    element('arcs').hidden = !result;
    if (result) this.rows.replaceChildren(...this.rowsOf(result, coloring));
    else this.rows.replaceChildren();
  }

  private chooseMode(mode: State['mode']): void {
    const { state, result } = this.session;
    if (state) void this.session.edit(setMode(state, mode, result?.state.loops ?? []));
  }

  private slide(isFinal: boolean): void {
    const { state, hierarchy } = this.session;
    const step = this.steps[Number(this.slider.value)];
    if (!state || !hierarchy || !step) return;
    // the loops are known: they are shown before the parts are there
    this.view?.showLoops(keptLoops(hierarchy.loops, step.detail).map((loop) => loop.vertices));
    this.view?.forceLoops('slider', true);
    void this.session.edit(setDetail(state, step.detail), isFinal).then(() => {
      this.view?.forceLoops('slider', false);
      if (isFinal) this.solveAhead();
    });
  }

  /** Whoever comes near the slider finds the levels solved, the nearest ones first. */
  private solveAhead(): void {
    const here = Number(this.slider.value);
    const distance = (step: Detail_step) => Math.abs(this.steps.indexOf(step) - here);
    const nearest = [...this.steps].sort((a, b) => distance(a) - distance(b));
    void this.session.solveAhead(nearest.map(({ detail }) => detail)).then(() => {
      this.slider.dataset.ahead = 'solved';
    });
  }

  private showState(state: State): void {
    for (const input of this.modes) input.checked = input.value === state.mode;
    setText(element('mode-text'), MODE_TEXTS[state.mode]);
    this.showSteps();
  }

  private showSteps(): void {
    const { hierarchy, state } = this.session;
    const text = element('detail-text');
    this.steps = hierarchy ? detailSteps(hierarchy.loops) : [];
    this.slider.disabled = this.steps.length < 2;
    if (!hierarchy || !state) {
      setText(text, '');
      return;
    }
    this.slider.max = String(Math.max(0, this.steps.length - 1));
    if (state.mode !== 'canonical') {
      setText(
        text,
        this.slider.disabled ? 'There is nothing to choose.' : 'Move it to let the shape decide.',
      );
      return;
    }
    this.slider.value = String(stepOf(this.steps, hierarchy.loops, state.detail));
    const kept = keptLoops(hierarchy.loops, state.detail).length;
    const shown = detailText(kept, hierarchy.loops.length, state.detail);
    setText(text, shown);
    this.slider.setAttribute('aria-valuetext', shown);
  }

  private rowsOf(result: Result, coloring: Coloring): HTMLTableRowElement[] {
    const colors = arcColors(result, coloring);
    const nameOf = (node: number) => nodeName(result.nodes.find(({ id }) => id === node));
    return result.arcs.map((arc) => {
      const button = make('button', { 'aria-label': `Part ${arc.id + 1}` });
      button.append(swatch(cssColor(colors[arc.id])), String(arc.id + 1));
      const cells = [
        button,
        `${nameOf(arc.source)} – ${nameOf(arc.target)}`,
        arc.modulus === null ? '' : short(arc.modulus),
        arc.margin === null ? '' : short(arc.margin),
      ].map((content) => make('td', {}, content));
      const row = make('tr', { 'data-arc': String(arc.id) }, ...cells);
      row.addEventListener('pointerenter', () => this.card.hover(arc.id));
      row.addEventListener('pointerleave', () => this.card.hover(null));
      button.addEventListener('focus', () => this.card.hover(arc.id));
      button.addEventListener('blur', () => this.card.hover(null));
      row.addEventListener('click', () => this.card.keep(arc.id));
      return row;
    });
  }

  private markRow(arc: number | null): void {
    for (const row of this.rows.rows)
      row.classList.toggle('current', row.dataset.arc === String(arc));
  }
}

function detailText(kept: number, all: number, detail: number): string {
  const bound = detail > 0 ? `, modulus at least ${short(detail)}` : '';
  return `${kept} of ${all} loops${bound}`;
}

function nodeName(node: GraphNode | undefined): string {
  if (!node) return '?';
  if (node.kind === 'pole' && node.pole >= 0) return `pole ${node.pole + 1}`;
  return node.kind === 'boundary' ? 'opening' : `node ${node.id + 1}`;
}

function summaryOf(result: Result): string {
  const { nodes, arcs } = result;
  const count = (n: number, word: string) => `${n} ${word}${n === 1 ? '' : 's'}`;
  const cycles = arcs.length - nodes.length + 1;
  const parts = [
    count(nodes.length, 'node'),
    count(arcs.length, 'arc'),
    count(cycles, 'cycle'),
  ].join(', ');
  const proof = result.certified ? 'The graph is certified.' : 'The graph is not certified.';
  return `${parts}. ${proof}`;
}
