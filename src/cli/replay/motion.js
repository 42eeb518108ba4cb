"use strict";
// The motion of a run: of each disc the legs between its impacts. Legs come as numbers,
// for there may be many.
const leg = ([time, x, y, vx, vy]) => ({ time, position: [x, y], velocity: [vx, vy] });

function readMotion(motion) {
  for (const track of motion.discs) track.legs = track.legs.map(leg);
  return motion;
}

// How many items of an order of times have begun.
function begun(items, time) {
  let [low, high] = [0, items.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (items[middle].time <= time) low = middle + 1;
    else high = middle;
  }
  return low;
}

// p + v t + g t²/2, and under drag k: p + u t + (v - u) (1 - exp(-k t)) / k, u = g / k.
function position(track, time) {
  const leg = track.legs[Math.max(begun(track.legs, time) - 1, 0)];
  const t = time - leg.time;
  const { gravity, drag } = track.pull;
  return [0, 1].map((axis) => {
    const [p, v, g] = [leg.position[axis], leg.velocity[axis], gravity[axis]];
    if (drag === 0) return p + v * t + (g * t * t) / 2;
    return p + (g / drag) * t - ((v - g / drag) * Math.expm1(-drag * t)) / drag;
  });
}

// Where a disc is at the start of its legs, at the end, and on curves in between.
function places(motion, track) {
  const ends = track.legs.map((leg) => leg.time).concat(motion.until);
  const parts = track.pull.gravity.some((part) => part !== 0) ? 8 : 1;
  const between = ends.slice(1).flatMap((end, leg) =>
    Array.from({ length: parts }, (_, part) => ends[leg] + ((end - ends[leg]) * (part + 1)) / parts));
  return [track.legs[0].position, ...between.map((time) => position(track, time))];
}

// What all motions take of the plane.
function bounds(motions) {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const motion of motions)
    for (const track of motion.discs)
      for (const [x, y] of places(motion, track)) {
        left = Math.min(left, x - track.radius);
        right = Math.max(right, x + track.radius);
        low = Math.min(low, y - track.radius);
        high = Math.max(high, y + track.radius);
      }
  return { left, right, low, high };
}
