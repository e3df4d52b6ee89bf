// What TypeScript says to users of the npm package: tsc must accept all of it, and refuse what is marked.
import { BankshotError, load, loadWorker, type Answer, type Puzzle } from 'bankshot';

const puzzle: Puzzle = { table: 'pool-9ft', ball: { at: [0.6, 0.4] }, target: { pocket: 'any' }, cushions: { max: 2 } };
const engine = await load({ locateFile: (name) => `/assets/${name}` });
const answer: Answer = engine.solve(puzzle, { all: true, noTiming: true });
export const speeds: number[] = answer.shots.map((shot) => shot.speed);
export const margin: number | null | undefined = answer.shots[0]?.margin?.angle[0];
export const csv: string = engine.simulate({ ...puzzle, shot: { speed: 1, angle: 20 } }, { csv: true, rate: 10 });
export const ends: string = engine.simulate('{}').end.reason;

const worker = await loadWorker();
const signal = new AbortController().signal;
export const promised: Promise<Answer> = worker.solveAll(puzzle, { signal });
worker.end();
export const place = (error: unknown): string => (error instanceof BankshotError ? error.path : '');

// @ts-expect-error: a key that is not there
engine.solve({ ...puzzle, colour: 'red' } satisfies Puzzle);
// @ts-expect-error: a table without a ball
engine.solve({ table: 'pool-9ft', target: { pocket: 'any' } });
// @ts-expect-error: no such table
engine.solve({ ...puzzle, table: 'pool-10ft' });
// @ts-expect-error: a place has two numbers
engine.solve({ ...puzzle, ball: { at: [1, 2, 3] } });
// @ts-expect-error: no such flag
engine.solve(puzzle, { every: true });
// @ts-expect-error: only a worker can be told to stop
engine.solve(puzzle, { signal });
// @ts-expect-error: launches are asked for in a window
engine.launches(puzzle, {});
