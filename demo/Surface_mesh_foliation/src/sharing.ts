// The state as a link: in the address of the page after each edit, and in a dialog to copy.
import { element } from './dom';
import { encodeLink } from './link';
import type { Session } from './session';

export class Sharing {
  private readonly dialog = element<HTMLDialogElement>('share-dialog');
  private readonly input = element<HTMLInputElement>('share-link');

  constructor(private readonly session: Session) {
    session.resultChanged.on((result) => {
      if (result && !session.isPreview && !session.isProvisional) this.updateAddress();
    });
    element('share').addEventListener('click', () => this.open());
    element('share-copy').addEventListener('click', () => void this.copy());
  }

  open(): void {
    const { source } = this.session;
    if (!source || !this.session.state) return;
    this.input.value = this.address();
    element('share-text').textContent =
      source.kind === 'example'
        ? 'The link has poles and loops, and names the example.'
        : 'The link has poles and loops, not the mesh: its reader opens the same file.';
    element('share-copy').textContent = 'Copy';
    this.dialog.showModal();
    this.input.select();
  }

  private address(): string {
    const { source, state } = this.session;
    return new URL(encodeLink({ source: source!, state: state! }), location.href).href;
  }

  private updateAddress(): void {
    if (this.session.source && this.session.state) history.replaceState(null, '', this.address());
  }

  private async copy(): Promise<void> {
    this.input.select();
    try {
      await navigator.clipboard.writeText(this.input.value);
    } catch {
      document.execCommand('copy'); // pages that are not served securely have no clipboard
    }
    element('share-copy').textContent = 'Copied';
  }
}
