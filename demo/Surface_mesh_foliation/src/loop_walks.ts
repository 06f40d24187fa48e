// The walks of loops along edges. Those of loops that were drawn are the engine's shortest paths,
// which are asked for once.
import type { Loop } from './protocol';
import type { Session } from './session';

export class Loop_walks {
  private readonly known = new Map<string, number[]>();

  constructor(private readonly session: Session) {
    session.opened.on(() => this.known.clear());
  }

  async of(loops: Loop[]): Promise<number[][]> {
    const walks: number[][] = [];
    for (const loop of loops)
      walks.push(loop.found ? loop.vertices : await this.walk(loop.vertices));
    return walks;
  }

  private async walk(vertices: number[]): Promise<number[]> {
    const key = vertices.join();
    let walk = this.known.get(key);
    if (!walk) {
      walk = (await this.session.engine.checkLoop(vertices, [], [])).path;
      this.known.set(key, walk);
    }
    return walk;
  }
}
