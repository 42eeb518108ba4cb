"use strict";
// window.replay: { time, until, seek(time), positions(pane) }.
const data = JSON.parse(document.getElementById("data").textContent);
const element = (id) => document.getElementById(id);
const canvases = [...document.querySelectorAll("figure canvas")];
const motions = data.panes.map((pane) => pane.motion);
// Legs come as numbers, for there may be many.
const leg = ([time, x, y, vx, vy]) => ({ time, position: [x, y], velocity: [vx, vy] });
for (const motion of motions) {
  for (const track of motion.discs) track.legs = track.legs.map(leg);
  for (const mark of motion.impacts) for (const body of mark.bodies) body.leg = leg(body.leg);
}
const until = Math.max(...motions.map((motion) => motion.until));
const times = [...new Set(motions.flatMap((motion) => motion.impacts.map((mark) => mark.time)))]
  .sort((one, other) => one - other);
const colours = ["#4a9bd4", "#d0568a", "#4caf5c", "#9a74d8", "#b5786c", "#1fa8a8"];
let playing = false;
let stamp = 0;

// The last leg that has begun: its index in an order of times.
function search(items, time) {
  let [low, high] = [0, items.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (items[middle].time <= time) low = middle + 1;
    else high = middle;
  }
  return Math.max(low - 1, 0);
}

// p + v t + g t²/2, and under drag k: p + u t + (v - u) (1 - exp(-k t)) / k, u = g / k.
function position(track, time) {
  const leg = track.legs[search(track.legs, time)];
  const t = time - leg.time;
  const { gravity, drag } = track.pull;
  return [0, 1].map((axis) => {
    const [p, v, g] = [leg.position[axis], leg.velocity[axis], gravity[axis]];
    if (drag === 0) return p + v * t + (g * t * t) / 2;
    return p + (g / drag) * t - ((v - g / drag) * Math.expm1(-drag * t)) / drag;
  });
}

const replay = {
  time: 0,
  until,
  positions: (pane = 0) =>
    motions[pane].discs.map((track) => position(track, Math.min(replay.time, motions[pane].until))),
  seek(time) {
    replay.time = Math.min(Math.max(time, 0), until);
    element("time").value = replay.time;
    element("clock").textContent = "t = " + Number(replay.time.toPrecision(8));
    draw();
  },
};
window.replay = replay;

// Where a disc is at the start of its legs, at the end, and on curves in between.
function places(motion, track) {
  const ends = track.legs.map((leg) => leg.time).concat(motion.until);
  const parts = track.pull.gravity.some((part) => part !== 0) ? 8 : 1;
  const between = ends.slice(1).flatMap((end, leg) =>
    Array.from({ length: parts }, (_, part) => ends[leg] + ((end - ends[leg]) * (part + 1)) / parts));
  return [track.legs[0].position, ...between.map((time) => position(track, time))];
}

// One view for all panes.
const view = (() => {
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
})();

function prepare(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
  if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  return [pen, width, height];
}

function drawPane(pane, style) {
  const [pen, width, height] = prepare(canvases[pane]);
  const across = view.right - view.left || 1;
  const up = view.high - view.low || 1;
  const scale = Math.min((width - 20) / across, (height - 20) / up);
  const place = ([x, y]) => [
    width / 2 + (x - (view.left + view.right) / 2) * scale,
    height / 2 - (y - (view.low + view.high) / 2) * scale,
  ];
  const circle = (centre, radius) => {
    pen.beginPath();
    pen.arc(...place(centre), radius * scale, 0, 2 * Math.PI);
  };
  pen.strokeStyle = style.getPropertyValue("--ink");
  pen.lineWidth = 2;
  for (const [from, to] of data.walls) {
    pen.beginPath();
    pen.moveTo(...place(from));
    pen.lineTo(...place(to));
    pen.stroke();
  }
  const motion = motions[pane];
  replay.positions(pane).forEach((centre, disc) => {
    pen.fillStyle = motion.discs[disc].fixed ? style.getPropertyValue("--quiet") : colours[disc % colours.length];
    circle(centre, motion.discs[disc].radius);
    pen.fill();
  });
  const mark = motion.impacts[search(motion.impacts, replay.time)];
  if (!mark || mark.time > replay.time) return;
  pen.strokeStyle = style.getPropertyValue("--hot");
  for (const { disc, leg } of mark.bodies) {
    circle(leg.position, motion.discs[disc].radius);
    pen.stroke();
  }
}

function drawAxis(style) {
  const [pen, width, height] = prepare(element("axis"));
  const line = (time, colour, top, thick) => {
    pen.fillStyle = style.getPropertyValue(colour);
    pen.fillRect(8 + (time / (until || 1)) * (width - 16) - thick / 2, top, thick, height - top);
  };
  for (const time of times) line(time, "--hot", height / 2, 1);
  if (data.difference) line(data.difference.time, "--bad", 0, 3);
}

function draw() {
  const style = getComputedStyle(document.documentElement);
  canvases.forEach((_, pane) => drawPane(pane, style));
  drawAxis(style);
}

// A run takes ten seconds at the usual speed.
function tick(now) {
  if (!playing) return;
  const passed = ((now - stamp) / 1e4) * until * 2 ** Number(element("speed").value);
  stamp = now;
  replay.seek(replay.time + passed);
  if (replay.time >= until) play(false);
  else requestAnimationFrame(tick);
}

function play(on) {
  playing = on;
  element("play").textContent = on ? "Pause" : "Play";
  if (!on) return;
  if (replay.time >= until) replay.seek(0);
  stamp = performance.now();
  requestAnimationFrame(tick);
}

function jump(time) {
  play(false);
  if (time !== undefined) replay.seek(time);
}

const actions = {
  play: () => play(!playing),
  next: () => jump(times.find((time) => time > replay.time)),
  previous: () => jump(times.findLast((time) => time < replay.time)),
  difference: () => jump(data.difference?.time),
};
const keys = { " ": "play", n: "next", p: "previous", d: "difference" };
for (const name of Object.keys(actions)) element(name)?.addEventListener("click", actions[name]);
addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (step && event.target.id !== "speed") jump(replay.time + (step * until) / 200);
  else if (event.key in keys && !(event.key === " " && event.target.tagName === "BUTTON")) actions[keys[event.key]]();
  else return;
  event.preventDefault();
});
element("time").max = until;
element("time").addEventListener("input", (event) => jump(Number(event.target.value)));
addEventListener("resize", draw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
if (data.panes.length > 1)
  element("parting").textContent = data.difference
    ? "The run " + data.difference.text + "."
    : "Both have the same impacts of each disc in the same order.";
replay.seek(0);
