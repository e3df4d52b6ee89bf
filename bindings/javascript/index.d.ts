// bankshot in JavaScript: documents in, documents out (format.md). Lengths are metres, times seconds, angles degrees.
import type { Answer, Puzzle, Shot } from './documents.js';

export * from './documents.js';

/** Names of the command line: `{ all: true, noTiming: true }` is `--all --no-timing`. */
export interface SolveFlags {
  /** Which planner; the default is `auto`. */
  planner?: string;
  /** Every distinct shot, best first. */
  all?: boolean;
  /** The first shot found, not the best. */
  first?: boolean;
  /** Simulations to spend at most. */
  budget?: number;
  /** Whose errors, in place of the puzzle's. */
  noise?: 'pro' | 'league' | 'beginner';
  /** Leave out `time_us`: same input, same answer. */
  noTiming?: boolean;
  /** Leave out `margin` and `success`: faster. */
  noRobustness?: boolean;
  /** How far a wrong coefficient of the table moves each arrival. */
  sensitivity?: boolean;
  /** Each shot with the points of its path. */
  path?: boolean;
}

export interface MapFlags {
  /** Places along the table and across it, each at most 200; the default is 40 by 20. */
  grid?: [number, number];
  /** Simulations to spend at most at one place. */
  budget?: number;
  noRobustness?: boolean;
  /** A picture in place of a table. */
  svg?: boolean;
}

export interface LaunchFlags {
  /** From, to, in degrees. */
  angle: [number, number];
  /** From, to, in m/s. */
  speed: [number, number];
  /** Angles and speeds, each at most 400; the default is 100 by 50. */
  grid?: [number, number];
}

/** Which launches make a puzzle, and how surely. */
export interface LaunchMap {
  angle: [number, number];
  speed: [number, number];
  grid: [number, number];
  /** A `1` where the launch makes it, else a `0`; the angles of the first speed, then of the next. */
  made: string;
  /** For the puzzle's player, in the same order. */
  chance: number[];
}

export interface BallState {
  ball: string;
  at: [number, number];
  velocity: [number, number];
  /** rad/s about x, y, z. */
  spin: [number, number, number];
}

/** A state right after what happens. */
export interface Event extends BallState {
  type: 'start' | 'cushion' | 'jaw' | 'ball' | 'slide-to-roll' | 'roll-to-rest' | 'pocket' | 'end';
  time: number;
  cushion?: string;
  pocket?: string;
  /** The ball that is met. */
  other?: BallState;
}

export interface Trajectory {
  id?: string | number;
  events: Event[];
  end: {
    reason: 'rest' | 'until' | 'pocketed' | 'events';
    time: number;
    at: [number, number];
    cushions: number;
    length: number;
  };
  /** In joules. */
  energy: { start: number; end: number };
}

/** A pocket of a table by its name, as it is drawn. */
export interface NamedPocket {
  name: string;
  at: [number, number];
  /** Of the mouth's width. */
  half: number;
  /** Away from the table. */
  out: [number, number];
  /** The middle of the circle in which a ball falls, and that circle's radius. */
  hole: [number, number];
  radius: number;
  /** With jaws: from a rail round its tip, along both facings, round the other tip; and the radius of a tip. */
  mouth?: [number, number][];
  tip?: number;
}

/** A table by its name, as it is drawn. */
export interface NamedTable {
  name: string;
  length: number;
  width: number;
  cushions: string[];
  pockets: NamedPocket[];
  /** Of its balls. */
  radius: number;
  /** From one to the next. */
  diamond: number;
}

/** What is wrong with a document or a flag: every function throws it, or rejects with it. */
export class BankshotError extends Error {
  /** Of the place in the document, such as `/ball/at/0`; empty where it is none of a document. */
  readonly path: string;
  readonly reason: string;
}

/** In a worker everything is promised, and may be given up: the promise rejects at once, and the worker turns to the next. */
type Given<InWorker, T> = InWorker extends true ? Promise<T> : T;
type Options<InWorker> = InWorker extends true ? { signal?: AbortSignal } : {};

/** A document is an object, or the text of one. */
interface Functions<InWorker> {
  /** The best shot. That there is none is an answer too, and no error. */
  solve(puzzle: Puzzle | string, flags?: SolveFlags & Options<InWorker>): Given<InWorker, Answer>;
  /** Every shot, best first. */
  solveAll(
    puzzle: Puzzle | string,
    flags?: Omit<SolveFlags, 'all' | 'first'> & Options<InWorker>,
  ): Given<InWorker, Answer>;
  simulate(shot: Shot | string, options?: Options<InWorker>): Given<InWorker, Trajectory>;
  /** As a table (csv.md), `rate` times a second. */
  simulate(shot: Shot | string, flags: { csv: true; rate?: number } & Options<InWorker>): Given<InWorker, string>;
  /** From where on the table the shot can be made: a table (csv.md), or a picture. */
  map(puzzle: Puzzle | string, flags?: MapFlags & Options<InWorker>): Given<InWorker, string>;
  launches(puzzle: Puzzle | string, flags: LaunchFlags & Options<InWorker>): Given<InWorker, LaunchMap>;
  /** A JSON Schema. */
  schema(
    document?: 'puzzle' | 'shot' | 'answer' | 'recording',
    options?: Options<InWorker>,
  ): Given<InWorker, Record<string, unknown>>;
  tables(options?: Options<InWorker>): Given<InWorker, NamedTable[]>;
  version(options?: Options<InWorker>): Given<InWorker, string>;
}

export type Engine = Functions<false>;
export interface EngineInWorker extends Functions<true> {
  /** Ends the worker and all that was asked; another question begins a new one. */
  end(): void;
}

export interface LoadOptions {
  /** Where `bankshot.wasm` and `worker.js` are, if not beside this module. */
  locateFile?: (name: 'bankshot.wasm' | 'worker.js') => string | URL;
  /** The engine, if it is compiled already: then nothing is loaded. */
  module?: WebAssembly.Module;
}

/** An engine in this thread. Engines share nothing but the compiled module. */
export function load(options?: LoadOptions): Promise<Engine>;
/** An engine in a worker of its own. */
export function loadWorker(options?: LoadOptions): Promise<EngineInWorker>;
