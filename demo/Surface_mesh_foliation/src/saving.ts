// The dialog that takes files and the picture home.
import { zipSync } from 'fflate';
import { element, make } from './dom';
import { OUTPUT_FILES, USES } from './files';
import type { Session } from './session';
import type { View } from './view/View';

export class Saving {
  private readonly dialog = element<HTMLDialogElement>('save-dialog');

  constructor(
    private readonly session: Session,
    private readonly view: View | null,
  ) {
    const items = OUTPUT_FILES.map((name) => fileItem(name, USES[name], () => this.saveFile(name)));
    if (view) items.unshift(fileItem('picture.png', 'what is shown', () => this.savePicture()));
    element('files').replaceChildren(...items);
    element('save-all').addEventListener('click', () => void this.attempt(() => this.saveAll()));
  }

  open(): void {
    if (this.session.result) this.dialog.showModal();
  }

  private saveFile(name: string): void {
    void this.attempt(async () => {
      const { bytes } = await this.session.download(name);
      give(name, new Blob([bytes as BlobPart]));
    });
  }

  private savePicture(): void {
    void this.attempt(async () => give('picture.png', await this.view!.picture()));
  }

  private async saveAll(): Promise<void> {
    const files: Record<string, Uint8Array> = {};
    for (const name of OUTPUT_FILES) files[name] = (await this.session.download(name)).bytes;
    if (this.view)
      files['picture.png'] = new Uint8Array(await (await this.view.picture()).arrayBuffer());
    give(`${baseName(this.session.loaded!.name)}.zip`, new Blob([zipSync(files) as BlobPart]));
  }

  private async attempt(act: () => Promise<void>): Promise<void> {
    try {
      await act();
    } catch (error) {
      this.dialog.close();
      this.session.report(error);
    }
  }
}

function fileItem(name: string, use: string, act: () => void): HTMLLIElement {
  const button = make('button', {}, name);
  button.addEventListener('click', act);
  return make('li', {}, button, make('span', {}, use));
}

/** A name without folders and extension. */
export function baseName(name: string): string {
  return name.replace(/^.*[/\\]/, '').replace(/\.[^.]*$/, '') || 'mesh';
}

/** Hands a file to the browser, which saves it. */
function give(name: string, blob: Blob): void {
  const url = URL.createObjectURL(blob);
  const link = make('a', { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
