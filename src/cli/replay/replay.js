const colours = ["#4a9bd4", "#d0568a", "#4caf5c", "#9a74d8", "#b5786c", "#1fa8a8"];
const kinds = Object.keys(looks);

// Times in order; of those that only rounding tells apart, the last.
function moments(times, until) {
  const sorted = [...times].sort((one, other) => one - other);
  return sorted.filter((time, index) => !(sorted[index + 1] - time <= 1e-12 * until));
}

const keys = { " ": "play", n: "next", p: "previous", w: "wrong", d: "difference" };

// A run, or a run and the truth, in an element of the page: `time`, `until`,
// `seek(time)`, `positions(pane)`.
class Replay {
  constructor(root) {
    this.find = (name) => root.querySelector("." + name);
    const data = JSON.parse(this.find("data").textContent);
    const motions = data.panes.map((pane) => readMotion(pane.motion));
    Object.assign(this, { root, data, motions, time: 0, playing: false, stamp: 0 });
    this.canvases = [...root.querySelectorAll("figure canvas")];
    this.until = Math.max(...motions.map((motion) => motion.until));
    this.view = bounds(motions);
    const times = motions.flatMap((motion) => motion.impacts.map((mark) => mark.time));
    this.times = moments(times, this.until);
    this.listen();
    this.seek(0);
  }

  positions(pane = 0) {
    const motion = this.motions[pane];
    return motion.discs.map((track) => position(track, Math.min(this.time, motion.until)));
  }

  seek(time) {
    this.time = Math.min(Math.max(time, 0), this.until);
    this.find("time").value = this.time;
    this.find("clock").textContent = "t = " + Number(this.time.toPrecision(8));
    this.draw();
  }

  draw() {
    const style = getComputedStyle(this.root);
    const colour = (name) => style.getPropertyValue("--" + name);
    this.canvases.forEach((_, pane) => this.drawPane(pane, colour));
    this.drawAxis(colour);
  }

  drawPane(pane, colour) {
    const plane = new Plane(this.canvases[pane], this.view);
    const { pen } = plane;
    const motion = this.motions[pane];
    pen.strokeStyle = colour("ink");
    pen.lineWidth = 2;
    for (const [from, to] of this.data.walls) plane.line(from, to);
    this.positions(pane).forEach((centre, disc) => {
      const { fixed, radius } = motion.discs[disc];
      pen.fillStyle = fixed ? colour("pale") : colours[disc % colours.length];
      plane.circle(centre, radius).fill();
    });
    const mark = motion.impacts[begun(motion.impacts, this.time) - 1];
    pen.strokeStyle = colour("hot");
    for (const [disc, x, y] of mark?.bodies ?? [])
      plane.circle([x, y], motion.discs[disc].radius).stroke();
    this.drawFaults(pane, plane, colour);
  }

  // Those of a little while ago, fading.
  drawFaults(pane, plane, colour) {
    const { faults } = this.data.panes[pane];
    const lasting = Math.max(this.data.frame, this.until / 100);
    for (let last = begun(faults, this.time) - 1; last >= 0; last--) {
      const { time, kind, places } = faults[last];
      const age = (this.time - time) / lasting;
      if (age >= 1) break;
      plane.pen.globalAlpha = 1 - age;
      plane.pen.strokeStyle = colour(kind);
      for (const [disc, x, y] of places)
        looks[kind](plane, [x, y], this.motions[pane].discs[disc].radius);
    }
    plane.pen.globalAlpha = 1;
  }

  // A lane for impacts, and one for each kind of fault; the first difference across all.
  drawAxis(colour) {
    const [pen, width, height] = prepare(this.find("axis"));
    const lane = height / (kinds.length + 1);
    const line = (time, name, top, long, thick) => {
      pen.fillStyle = colour(name);
      const across = 8 + (time / (this.until || 1)) * (width - 16);
      pen.fillRect(across - thick / 2, top, thick, long);
    };
    for (const time of this.times) line(time, "hot", 0, lane - 1, 1);
    for (const { faults } of this.data.panes)
      for (const { time, kind } of faults)
        line(time, kind, lane * (kinds.indexOf(kind) + 1), lane - 1, 2);
    if (this.data.difference) line(this.data.difference.time, "ink", 0, height, 1);
  }

  // A run takes ten seconds at the usual speed.
  tick(now) {
    if (!this.playing) return;
    const speed = 2 ** Number(this.find("speed").value);
    const passed = ((now - this.stamp) / 1e4) * this.until * speed;
    this.stamp = now;
    this.seek(this.time + passed);
    if (this.time >= this.until) this.play(false);
    else requestAnimationFrame((then) => this.tick(then));
  }

  play(on) {
    this.playing = on;
    this.find("play").textContent = on ? "Pause" : "Play";
    if (!on) return;
    if (this.time >= this.until) this.seek(0);
    this.stamp = performance.now();
    requestAnimationFrame((now) => this.tick(now));
  }

  jump(time) {
    this.play(false);
    if (time !== undefined) this.seek(time);
  }

  listen() {
    const after = (times) => times.find((time) => time > this.time);
    const faults = this.data.panes.flatMap((pane) => pane.faults.map((fault) => fault.time));
    const actions = {
      play: () => this.play(!this.playing),
      next: () => this.jump(after(this.times)),
      previous: () => this.jump(this.times.findLast((time) => time < this.time)),
      wrong: () => this.jump(after(faults)),
      difference: () => this.jump(this.data.difference?.time),
    };
    for (const name of Object.keys(actions)) this.find(name)?.addEventListener("click", actions[name]);
    // Where there is no other one, the whole page is the replay's.
    const listener = document.querySelectorAll(".replay").length > 1 ? this.root : window;
    listener.addEventListener("keydown", (event) => this.press(event, actions));
    this.find("time").max = this.until;
    this.find("time").addEventListener("input", (event) => this.jump(Number(event.target.value)));
    addEventListener("resize", () => this.draw());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
  }

  press(event, actions) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    const isOfButton = event.key === " " && ["BUTTON", "SUMMARY"].includes(event.target.tagName);
    if (step && !event.target.classList?.contains("speed"))
      this.jump(this.time + (step * this.until) / 200);
    else if (event.key in keys && !isOfButton) actions[keys[event.key]]();
    else return;
    event.preventDefault();
  }
}

window.replays = [...document.querySelectorAll(".replay")].map((root) => new Replay(root));
