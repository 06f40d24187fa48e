// What the picture shows.
import type { Coloring } from '../coloring';
import { element } from '../dom';
import { Signal } from '../signal';
import { FIRST_LAYERS } from '../view/layers';
import type { Layers } from '../view/layers';

type Switch = { [K in keyof Layers]: Layers[K] extends boolean ? K : never }[keyof Layers];

const NOTES: Partial<Record<Switch, string>> = {
  singularities: 'Blue squares: poles of the foliation. Orange diamonds: saddles.',
  edgeValues: 'Edges that leaves cross more are lighter.',
  radius: 'A tube as thick as the part around it.',
};

export class Show_panel {
  readonly changed = new Signal<Layers>();
  layers: Layers = { ...FIRST_LAYERS };

  private readonly switches = [...document.querySelectorAll<HTMLInputElement>('[data-layer]')];
  private readonly coloring = element<HTMLSelectElement>('coloring');
  private readonly spacing = element<HTMLInputElement>('spacing');

  constructor() {
    for (const input of this.switches)
      input.addEventListener('change', () =>
        this.set({ [input.dataset.layer as Switch]: input.checked }),
      );
    this.coloring.addEventListener('change', () =>
      this.set({ coloring: this.coloring.value as Coloring }),
    );
    this.spacing.addEventListener('input', () =>
      this.set({ leavesPerArc: Number(this.spacing.value), leaves: true }),
    );
    this.fill();
  }

  private set(change: Partial<Layers>): void {
    this.layers = { ...this.layers, ...change };
    this.fill();
    this.changed.emit(this.layers);
  }

  private fill(): void {
    for (const input of this.switches) input.checked = this.layers[input.dataset.layer as Switch];
    this.coloring.value = this.layers.coloring;
    this.spacing.value = String(this.layers.leavesPerArc);
    element('spacing-text').textContent = String(this.layers.leavesPerArc);
    const notes = Object.entries(NOTES).filter(([layer]) => this.layers[layer as Switch]);
    element('show-text').textContent = notes.map(([, note]) => note).join(' ');
  }
}
