// A click for each contact, synthesized instead of read from a file.

/** @type {AudioContext} created at the first sound */
let audio;

export function click() {
  audio ??= new AudioContext();
  const [now, tone, loudness] = [audio.currentTime, audio.createOscillator(), audio.createGain()];
  tone.frequency.setValueAtTime(900, now);
  tone.frequency.exponentialRampToValueAtTime(200, now + 0.06);
  loudness.gain.setValueAtTime(0.2, now);
  loudness.gain.exponentialRampToValueAtTime(0.001, now + 0.08);
  tone.connect(loudness).connect(audio.destination);
  tone.start(now);
  tone.stop(now + 0.1);
}
