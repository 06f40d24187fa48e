// The compiled engine as TypeScript sees it: what bindings.cpp has.
import type {
  HierarchyLoop,
  Leaves,
  Loaded,
  Pole,
  Problem,
  Result,
  Sketch,
  State,
} from '../src/protocol';

/** No function throws: each gives a value or a problem. */
export type Outcome<T> =
  | { value: T; problem?: undefined }
  | { value?: undefined; problem: Problem };

/** One mesh, and what a user does with it. */
export interface Session {
  loaded(): Outcome<Omit<Loaded, 'name' | 'milliseconds'>>;
  findPoles(): Outcome<{ poles: Pole[]; significances: number[] }>;
  /** The function is called within `solve`, with the parts as they are at the start. */
  showSketches(show: (sketch: Sketch) => void): void;
  /** `goOn` is told what is at work, and says whether the result is still wanted. */
  solve(state: State, goOn: (stage: string) => boolean): Outcome<Result>;
  hierarchy(poles: Pole[]): Outcome<HierarchyLoop[]>;
  leaves(perArc: number): Outcome<Leaves>;
  /** Of the state, poles and loops matter. */
  checkLoop(picks: number[], state: State): Outcome<{ path: number[]; problem: Problem | null }>;
  /** Writes what a download has to a file. */
  write(what: string, file: string): Outcome<string>;
  delete(): void;
}

export interface Engine {
  openSession(file: string, repairs: boolean, fillsOpenings: boolean): Outcome<Session>;
  FS: {
    mkdir(path: string): void;
    chdir(path: string): void;
    writeFile(path: string, data: Uint8Array): void;
    readFile(path: string): Uint8Array;
    unlink(path: string): void;
  };
}
