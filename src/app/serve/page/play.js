// Plays a shot: a ball along its path, in real time or slower.

let running = 0;

/** Where the ball is after t seconds. @param {[number, number, number][]} path */
export function at(path, t) {
  const i = path.findIndex((p) => p[0] > t);
  if (i < 0) return path[path.length - 1].slice(1);
  if (i === 0) return path[0].slice(1);
  const [t0, x0, y0] = path[i - 1], [t1, x1, y1] = path[i], share = (t - t0) / (t1 - t0);
  return [x0 + share * (x1 - x0), y0 + share * (y1 - y0)];
}

/**
 * @param {{element: SVGElement, path: [number, number, number][]}[]} balls
 * @param {number} pace 1 is real time
 * @returns {Promise<void>} when all rest, or another is played
 */
export function play(balls, pace) {
  const mine = ++running, begin = performance.now();
  const end = Math.max(...balls.map(({ path }) => path[path.length - 1][0]));
  return new Promise((done) => {
    const frame = (now) => {
      const t = ((now - begin) / 1000) * pace;
      for (const { element, path } of balls) {
        const [x, y] = at(path, t);
        element.setAttribute('cx', x);
        element.setAttribute('cy', y);
      }
      if (mine !== running || t >= end) return done();
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  });
}
