// Where meshes come from: the list of examples, a file that is chosen or dropped, or a link.
import { element, make } from './dom';
import { EXAMPLES, fetchExample, isExample } from './examples';
import { LinkError, decodeLink } from './link';
import type { Link } from './link';
import type { Messages } from './messages';
import type { Mesh_panel } from './panels/mesh_panel';
import type { Session } from './session';

/** Faults of meshes that a repair may mend. */
const REPAIRABLE = [
  'not_triangle_mesh',
  'not_manifold',
  'not_orientable',
  'isolated_vertex',
  'not_finite',
  'degenerate_face',
];

const FORMATS = /\.(off|obj|ply|stl)$/i;

interface Opened {
  name: string;
  bytes: ArrayBuffer;
  example: string | null;
}

export class Opening {
  private readonly examples = element<HTMLSelectElement>('examples');
  private readonly file = element<HTMLInputElement>('file');
  private last: Opened | null = null;
  private refused: Opened | null = null; // or being opened

  constructor(
    private readonly session: Session,
    private readonly messages: Messages,
    private readonly panel: () => Mesh_panel,
  ) {
    const none = make('option', { value: '', disabled: true, hidden: true }, 'Examples');
    const options = EXAMPLES.map(({ name, label }) => make('option', { value: name }, label));
    this.examples.append(none, ...options);
    this.examples.addEventListener('change', () => void this.openExample(this.examples.value));
    element('open').addEventListener('click', () => this.choose());
    this.file.addEventListener('change', () => {
      const file = this.file.files?.[0];
      if (file) void this.openFile(file);
      this.file.value = '';
    });
    session.opened.on(() => {
      this.last = this.refused ?? this.last;
      this.refused = null;
    });
    this.listenToDrops();
    window.addEventListener('hashchange', () => void this.start());
  }

  choose(): void {
    this.file.click();
  }

  /** The link in the address, or the first example. */
  async start(): Promise<void> {
    const link = this.linkInAddress();
    if (link?.source.kind === 'file') {
      this.session.expect(link);
      const { name, vertices } = link.source;
      const size = vertices.toLocaleString('en-US');
      this.messages.showProblem(
        `This link needs the mesh ${name}, with ${size} vertices. Open it here.`,
        {
          label: 'Open',
          act: () => this.choose(),
        },
      );
      const words = link.source.options.split(',');
      this.panel().options = {
        repair: words.includes('repair'),
        fillOpenings: words.includes('fill'),
      };
      return;
    }
    if (link) this.session.expect(link);
    await this.openExample(link ? link.source.name : EXAMPLES[0].name);
  }

  async openExample(name: string): Promise<void> {
    try {
      await this.open({ name: `${name}.off`, bytes: await fetchExample(name), example: name });
    } catch (error) {
      this.messages.showProblem(`${(error as Error).message}. Open a mesh of your own.`);
    }
  }

  async openFile(file: File): Promise<void> {
    if (!FORMATS.test(file.name)) {
      this.messages.showProblem(
        `${file.name} is no mesh that can be read. The formats are OFF, OBJ, PLY and STL.`,
      );
      return;
    }
    try {
      await this.open({ name: file.name, bytes: await file.arrayBuffer(), example: null });
    } catch (error) {
      this.messages.showProblem(`${file.name} cannot be read: ${(error as Error).message}`);
    }
  }

  /** What is open, with other options. */
  async openAgain(): Promise<void> {
    const again = this.refused ?? this.last;
    if (again) await this.open(again);
  }

  /** Whether a mesh was refused for faults of this kind, and repair has not been tried yet. */
  canRepair(kind: string): boolean {
    return this.refused !== null && !this.panel().options.repair && REPAIRABLE.includes(kind);
  }

  get isRefused(): boolean {
    return this.refused !== null;
  }

  async repairAndOpen(): Promise<void> {
    this.panel().options = { ...this.panel().options, repair: true };
    await this.openAgain();
  }

  private async open(opened: Opened): Promise<void> {
    this.messages.clearProblem();
    this.refused = opened;
    const { name, bytes, example } = opened;
    await this.session.open(name, bytes, this.panel().options, example);
    this.examples.value = this.last?.example ?? '';
  }

  private linkInAddress(): Link | null {
    try {
      const link = decodeLink(location.hash);
      if (link?.source.kind !== 'example' || isExample(link.source.name)) return link;
      throw new LinkError(`there is no example "${link.source.name}"`);
    } catch (error) {
      if (!(error instanceof LinkError)) throw error;
      this.messages.notice(`The link is damaged and is ignored: ${error.message}.`);
      return null;
    }
  }

  private listenToDrops(): void {
    const target = element('drop');
    let depth = 0;
    const show = (change: number) => {
      depth = Math.max(0, depth + change);
      target.hidden = depth === 0;
    };
    document.addEventListener('dragenter', () => show(1));
    document.addEventListener('dragleave', () => show(-1));
    document.addEventListener('dragover', (event) => event.preventDefault());
    document.addEventListener('drop', (event) => {
      event.preventDefault();
      show(-depth);
      const file = event.dataTransfer?.files[0];
      if (file) void this.openFile(file);
    });
  }
}
