// What the mesh is, and what was done to it.
import { element, make } from '../dom';
import type { Loaded } from '../protocol';
import type { ReadOptions, Session } from '../session';

export class Mesh_panel {
  private readonly repair = element<HTMLInputElement>('repair');
  private readonly fill = element<HTMLInputElement>('fill');

  constructor(session: Session, onOptions: () => void) {
    session.opened.on((loaded) => this.show(loaded));
    for (const input of [this.repair, this.fill]) input.addEventListener('change', onOptions);
  }

  get options(): ReadOptions {
    return { repair: this.repair.checked, fillOpenings: this.fill.checked };
  }

  set options({ repair, fillOpenings }: ReadOptions) {
    this.repair.checked = repair;
    this.fill.checked = fillOpenings;
  }

  private show(loaded: Loaded): void {
    const number = (value: number) => value.toLocaleString('en-US');
    const rows: [string, string][] = [
      ['Name', loaded.name],
      ['Vertices', number(loaded.numberOfVertices)],
      ['Edges', number(loaded.numberOfEdges)],
      ['Faces', number(loaded.numberOfFaces)],
      ['Genus', number(loaded.genus)],
      ['Openings', number(loaded.numberOfOpenings)],
    ];
    element('numbers').replaceChildren(
      ...rows.flatMap(([name, value]) => [make('dt', {}, name), make('dd', {}, value)]),
    );
    const report = element('report');
    report.replaceChildren();
    if (loaded.repair.length === 0) return;
    const sentences = loaded.repair.map((sentence) => make('li', {}, sentence));
    report.append(make('h2', {}, 'What was done to it'), make('ul', {}, ...sentences));
  }
}
