// Animates a shot: balls move along their paths, in real time or slower, and turn. A ring marks a ball that slides.
import { shape, upright } from './table.js';

let running = 0;

/**
 * @typedef {[number, number, number]} Sample time, x, y
 * @typedef {{type: string, time: number, velocity: number[], spin: number[]}} Turn right after an event
 * @typedef {{dot: SVGElement, skin?: SVGElement, path: Sample[], turns: Turn[], radius: number}} Moving
 */

/** Returns the ball's place after t seconds. @param {Sample[]} path @returns {[number, number]} */
export function at(path, t) {
  const i = path.findIndex((p) => p[0] > t);
  if (i <= 0) {
    const [, x, y] = path[i < 0 ? path.length - 1 : 0];
    return [x, y];
  }
  const [t0, x0, y0] = path[i - 1];
  const [t1, x1, y1] = path[i];
  const share = (t - t0) / (t1 - t0);
  return [x0 + share * (x1 - x0), y0 + share * (y1 - y0)];
}

const step = 0.01; // s, over which a path's velocity is taken

/**
 * Returns velocity and spin at a time: linear in time while sliding, taken from the path while rolling.
 * @param {Moving} ball
 */
function turning({ turns, path, radius }, t) {
  const after = turns.findIndex((e) => e.time > t);
  const a = turns[(after < 0 ? turns.length : after) - 1];
  const b = turns[after];
  if (!a) return { velocity: [0, 0], spin: [0, 0, 0] };
  if (a.type === 'slide-to-roll') {
    const [here, there] = [at(path, t), at(path, t + step)];
    const velocity = [0, 1].map((k) => (there[k] - here[k]) / step);
    return {
      velocity,
      spin: [-velocity[1] / radius, velocity[0] / radius, a.spin[2]],
    };
  }
  if (b?.type !== 'slide-to-roll') return a;
  const share = (t - a.time) / (b.time - a.time);
  const between = (/** @type {'velocity' | 'spin'} */ key) => a[key].map((v, k) => v + share * (b[key][k] - v));
  return { velocity: between('velocity'), spin: between('spin') };
}

/** Turns a point of a ball's surface by the angular velocity w for a time dt. */
function turned(p, w, dt) {
  const size = Math.hypot(...w);
  const angle = size * dt;
  if (!(angle > 0)) return p;
  const n = w.map((v) => v / size);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const along = (1 - c) * (n[0] * p[0] + n[1] * p[1] + n[2] * p[2]);
  const cross = [n[1] * p[2] - n[2] * p[1], n[2] * p[0] - n[0] * p[2], n[0] * p[1] - n[1] * p[0]];
  return p.map((v, k) => c * v + s * cross[k] + along * n[k]);
}

const skin = [
  [0, 0, 1],
  [1, 0, 0],
  [0, 1, 0],
  [-1, 0, 0],
  [0, -1, 0],
  [0, 0, -1],
];

/** Adds the spots that show a ball turning. @param {Moving} ball */
function shown(ball) {
  const spots = skin.map((p) => ({
    p,
    dot: shape('circle', { class: 'spot', r: ball.radius / 5 }),
  }));
  (ball.skin ?? ball.dot).after(...spots.map(({ dot }) => dot));
  return {
    draw(t, dt) {
      const [x, y] = at(ball.path, t);
      ball.dot.setAttribute('cx', String(x));
      ball.dot.setAttribute('cy', String(y));
      ball.skin?.setAttribute('transform', upright(ball.dot.ownerSVGElement, [x, y]));
      const { velocity, spin } = turning(ball, t);
      const slip = Math.hypot(velocity[0] - ball.radius * spin[1], velocity[1] + ball.radius * spin[0]);
      ball.dot.classList.toggle('slides', slip > 0.05 && t < ball.path[ball.path.length - 1][0]);
      for (const spot of spots) {
        spot.p = turned(spot.p, spin, dt);
        spot.dot.setAttribute('cx', String(x + 0.8 * ball.radius * spot.p[0]));
        spot.dot.setAttribute('cy', String(y + 0.8 * ball.radius * spot.p[1]));
        spot.dot.setAttribute('opacity', spot.p[2] > 0 ? '1' : '0');
      }
    },
    end() {
      for (const { dot } of spots) dot.remove();
      ball.dot.classList.remove('slides');
    },
  };
}

/**
 * @param {Moving[]} balls
 * @param {number} pace 1 is real time
 * @param {{time: number}[]} sounds times at which something is hit
 * @param {(time: number) => void} sound
 * @returns {Promise<boolean>} true when all balls rest, false when stopped or replaced by another
 */
export function play(balls, pace, sounds, sound) {
  const mine = ++running;
  const begin = performance.now();
  const end = Math.max(...balls.map(({ path }) => path[path.length - 1][0]));
  const all = balls.map(shown);
  const left = sounds.map(({ time }) => time).sort((a, b) => a - b);
  let before = 0;
  return new Promise((done) => {
    const frame = (now) => {
      if (mine !== running) {
        for (const ball of all) ball.end();
        return done(false); // its balls may be gone
      }
      const t = Math.min(((now - begin) / 1000) * pace, end);
      for (const ball of all) ball.draw(t, t - before);
      while (left.length && left[0] <= t) sound(left.shift());
      before = t;
      if (t < end) return requestAnimationFrame(frame);
      for (const ball of all) ball.end();
      done(true);
    };
    requestAnimationFrame(frame);
  });
}

/** Ends the animation. */
export function stop() {
  ++running;
}
