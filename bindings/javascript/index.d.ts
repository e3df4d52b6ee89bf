// bankshot in JavaScript: documents in, documents out (format.md). Units are metres, seconds and degrees.
import type { Answer, Puzzle, Shot } from './documents.js';

export * from './documents.js';

/** Flags of the command line: `{ all: true, noTiming: true }` is `--all --no-timing`. */
export interface SolveFlags {
  /** The planner; the default is `auto`. */
  planner?: string;
  /** Return every distinct shot, best first. */
  all?: boolean;
  /** Return the first shot found, not the best. */
  first?: boolean;
  /** Maximum number of simulations. */
  budget?: number;
  /** A player whose errors replace the puzzle's. */
  noise?: 'pro' | 'league' | 'beginner';
  /** Number of balls that the plan of a game looks at; the default is 3. */
  depth?: number;
  /** Number of pots after it that a shot of a game is chosen for: 1, the default, or 2, which is slower. */
  plies?: number;
  /** Leave out `time_us`, so that equal input gives equal output. */
  noTiming?: boolean;
  /** Leave out `margin` and `success`, which is faster. */
  noRobustness?: boolean;
  /** Add how far a wrong coefficient of the table moves each arrival. */
  sensitivity?: boolean;
  /** Add the points of each shot's path. */
  path?: boolean;
}

export interface MapFlags {
  /** Number of starts along and across the table, each at most 200; the default is 40 by 20. */
  grid?: [number, number];
  /** Maximum number of simulations per start. */
  budget?: number;
  noRobustness?: boolean;
  /** Return a picture instead of CSV. */
  svg?: boolean;
  /** Estimate how likely the best straight pot is from each start, without a search. */
  value?: boolean;
}

export interface LaunchFlags {
  /** From, to, in degrees. */
  angle: [number, number];
  /** From, to, in m/s. */
  speed: [number, number];
  /** Angles and speeds, each at most 400; the default is 100 by 50. */
  grid?: [number, number];
}

/** The launches that make the shot, and their success. */
export interface LaunchMap {
  angle: [number, number];
  speed: [number, number];
  grid: [number, number];
  /** `1` for a launch that makes the shot, otherwise `0`; all angles of the first speed, then of the next. */
  made: string;
  /** Success for the puzzle's player, in the same order. */
  chance: number[];
}

export interface BallState {
  ball: string;
  at: [number, number];
  velocity: [number, number];
  /** rad/s about x, y, z. */
  spin: [number, number, number];
}

/** An event, with the state right after it. */
export interface Event extends BallState {
  type: 'start' | 'cushion' | 'jaw' | 'ball' | 'slide-to-roll' | 'roll-to-rest' | 'pocket' | 'end';
  time: number;
  cushion?: string;
  pocket?: string;
  /** The ball that is hit. */
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
  /** Energy in joules. */
  energy: { start: number; end: number };
}

/** A pocket of a preset table, with the data to draw it. */
export interface NamedPocket {
  name: string;
  at: [number, number];
  /** Half the width of the mouth. */
  half: number;
  /** Unit vector away from the table. */
  out: [number, number];
  /** Centre of the capture circle; `radius` is its radius. */
  hole: [number, number];
  radius: number;
  /** With jaws: outline from a rail round its tip, along both facings and round the other tip; `tip` is its radius. */
  mouth?: [number, number][];
  tip?: number;
}

/** A preset table, with the data to draw it. */
export interface NamedTable {
  name: string;
  length: number;
  width: number;
  cushions: string[];
  pockets: NamedPocket[];
  /** Radius of its balls. */
  radius: number;
  /** Distance between two diamonds. */
  diamond: number;
}

/** An error in a document or a flag. Every function throws it or rejects with it. */
export class BankshotError extends Error {
  /** JSON pointer to the place in the document, such as `/ball/at/0`; empty if there is no such place. */
  readonly path: string;
  readonly reason: string;
}

/** In a worker, functions return promises that can be aborted: one rejects at once, and the next question runs. */
type Given<InWorker, T> = InWorker extends true ? Promise<T> : T;
type Options<InWorker> = InWorker extends true ? { signal?: AbortSignal } : {};

/** A document is an object or its JSON text. */
interface Functions<InWorker> {
  /** Finds the best shot. If there is none, the answer says so; that is no error. */
  solve(puzzle: Puzzle | string, flags?: SolveFlags & Options<InWorker>): Given<InWorker, Answer>;
  /** Finds every shot, best first. */
  solveAll(
    puzzle: Puzzle | string,
    flags?: Omit<SolveFlags, 'all' | 'first'> & Options<InWorker>,
  ): Given<InWorker, Answer>;
  simulate(shot: Shot | string, options?: Options<InWorker>): Given<InWorker, Trajectory>;
  /** Returns the path as CSV (csv.md), sampled `rate` times a second. */
  simulate(shot: Shot | string, flags: { csv: true; rate?: number } & Options<InWorker>): Given<InWorker, string>;
  /** Maps the starts from which the shot can be made, as CSV (csv.md) or a picture. */
  map(puzzle: Puzzle | string, flags?: MapFlags & Options<InWorker>): Given<InWorker, string>;
  launches(puzzle: Puzzle | string, flags: LaunchFlags & Options<InWorker>): Given<InWorker, LaunchMap>;
  /** Returns the JSON Schema of a document. */
  schema(
    document?: 'puzzle' | 'shot' | 'answer' | 'recording',
    options?: Options<InWorker>,
  ): Given<InWorker, Record<string, unknown>>;
  tables(options?: Options<InWorker>): Given<InWorker, NamedTable[]>;
  version(options?: Options<InWorker>): Given<InWorker, string>;
}

export type Engine = Functions<false>;
export interface EngineInWorker extends Functions<true> {
  /** Ends the worker and rejects all open questions; another question starts a new worker. */
  end(): void;
}

export interface LoadOptions {
  /** Returns the address of `bankshot.wasm` or `worker.js`, if not beside this module. */
  locateFile?: (name: 'bankshot.wasm' | 'worker.js') => string | URL;
  /** A compiled engine; nothing is loaded then. */
  module?: WebAssembly.Module;
}

/** Loads an engine in this thread. Engines share nothing but the compiled module. */
export function load(options?: LoadOptions): Promise<Engine>;
/** Loads an engine in its own worker. */
export function loadWorker(options?: LoadOptions): Promise<EngineInWorker>;
