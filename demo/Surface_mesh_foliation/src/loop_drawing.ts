// A loop that is drawn by clicking vertices: it is checked as it grows.
import { element } from './dom';
import { Abandoned, ProblemError } from './engine';
import type { Loop, Problem } from './protocol';
import type { Session } from './session';
import { addLoop } from './state';
import { forPeople } from './wording';
import type { View } from './view/View';

const FEWEST = 3;

export class Loop_drawing {
  private vertices: number[] = [];
  private problem: Problem | null = null;
  private turn = 0; // of checks, the last one counts

  private readonly box = element('drawing');
  private readonly text = element('drawing-text');
  private readonly finishButton = element<HTMLButtonElement>('drawing-finish');

  constructor(
    private readonly session: Session,
    private readonly view: View | null,
    private readonly onDone: () => void,
  ) {
    this.finishButton.addEventListener('click', () => this.finish());
    element('drawing-back').addEventListener('click', () => this.takeBack());
    element('drawing-cancel').addEventListener('click', () => this.clear());
    session.opened.on(() => this.clear());
  }

  get isEmpty(): boolean {
    return this.vertices.length === 0;
  }

  add(vertex: number): void {
    if (vertex === this.vertices[0] && this.vertices.length >= FEWEST) {
      this.finish();
      return;
    }
    if (this.vertices.includes(vertex)) return;
    this.vertices = [...this.vertices, vertex];
    void this.check();
  }

  takeBack(): void {
    this.vertices = this.vertices.slice(0, -1);
    if (this.isEmpty) this.clear();
    else void this.check();
  }

  finish(): void {
    const { state } = this.session;
    if (!state || this.finishButton.disabled) return;
    const vertices = this.vertices;
    const used = this.usedLoops();
    this.clear();
    void this.session.edit(addLoop(state, used, vertices)).then((isDone) => {
      if (isDone) this.onDone();
    });
  }

  clear(): void {
    ++this.turn;
    this.vertices = [];
    this.problem = null;
    this.box.hidden = true;
    this.view?.clearDraft();
  }

  private usedLoops(): Loop[] {
    return this.session.result?.state.loops ?? [];
  }

  private async check(): Promise<void> {
    const { state } = this.session;
    if (!state) return;
    const turn = ++this.turn;
    this.finishButton.disabled = true;
    this.box.hidden = false;
    this.view?.showDraft(this.vertices, this.vertices, []);
    try {
      const { path, problem } = await this.session.engine.checkLoop(
        this.vertices,
        state.poles,
        this.usedLoops(),
      );
      if (turn !== this.turn) return;
      this.problem = problem;
      const isClosed = this.vertices.length >= FEWEST;
      const walk = isClosed && path.length > 0 ? [...path, path[0]] : path;
      const faults = problem && !isUnfinished(problem) ? problem.vertices : [];
      this.view?.showDraft(walk, this.vertices, faults);
      this.finishButton.disabled = !isClosed || problem !== null;
      this.tell();
    } catch (error) {
      if (error instanceof ProblemError) this.text.textContent = error.message;
      else if (!(error instanceof Abandoned)) throw error;
    }
  }

  private tell(): void {
    const { problem } = this;
    const count = this.vertices.length;
    const missing = FEWEST - count;
    this.text.classList.toggle('fault', problem !== null && !isUnfinished(problem));
    if (problem) {
      const reason = forPeople(problem.message, this.usedLoops().length);
      const state = isUnfinished(problem) ? 'not around a part yet' : 'not so';
      this.text.textContent = `${count} picked, ${state}: ${reason}`;
    } else if (missing > 0) {
      this.text.textContent = `${count} picked; at least ${missing} more, all around the part`;
    } else this.text.textContent = `${count} picked: the loop is fine`;
  }
}

/** What is wrong with most loops that are not yet led all around a part. */
function isUnfinished({ kind }: Problem): boolean {
  return kind === 'inessential_loop' || kind === 'invalid_loop';
}
