#!/usr/bin/env python3
"""Replays the logs of scenes.json in 80 digits: `replay.py [DIR]`; ends with 1 if one is wrong.

Each impact must be the next one of all pairs, or one of those at the same time, at a time
between its bounds; and after the last one nothing may happen up to the end of the scene."""
import decimal, json, pathlib, sys
from decimal import Decimal as D
from fractions import Fraction as F

decimal.getcontext().prec = 80
SAME = D(10)**-18  # times that differ by less are ties or nearly so: their order is not looked at
NOISE = D(10)**-28  # beyond the digits of the bounds, and well before those of the replay
TANGENT = D(10)**-45  # discriminants below this are those of tangents

def number(text):
    exact = F(float.fromhex(text)) if "x" in text else F(text)
    return D(exact.numerator) / D(exact.denominator)
def vector(texts): return tuple(map(number, texts))
def dot(a, b): return a[0] * b[0] + a[1] * b[1]
def moved(a, b, t): return (a[0] + b[0] * t, a[1] + b[1] * t)

class Disc:
    def __init__(self, disc):
        self.x, self.v, self.r = vector(disc["position"]), vector(disc["velocity"]), number(disc["radius"])
        mass = disc.get("mass", "1")
        self.lightness = D(0) if mass == "infinite" else 1 / number(mass)

class Wall:
    def __init__(self, wall):
        self.start, self.lightness = vector(wall["from"]), D(0)
        self.w = moved(vector(wall["to"]), self.start, -1)
    def part(self, x): return min(D(1), max(D(0), dot(moved(x, self.start, -1), self.w) / dot(self.w, self.w)))
    def nearest(self, x): return moved(self.start, self.w, self.part(x))

def to_circle(x, v, reach):
    """When a point comes within a distance of the origin."""
    a, b, c = dot(v, v), dot(x, v), dot(x, x) - reach**2
    if b >= 0 or b * b - a * c <= TANGENT * b * b: return None
    if c <= 0: return D(0) if b < -NOISE else None
    return c / ((b * b - a * c).sqrt() - b)

def to_wall(disc, wall):
    """When a disc comes within its radius of a wall: of its line, beside it, or of an end."""
    x, length = moved(disc.x, wall.start, -1), dot(wall.w, wall.w).sqrt()
    side, drift = ((p[0] * wall.w[1] - p[1] * wall.w[0]) / length for p in (x, disc.v))
    times = [to_circle(moved(x, wall.w, -end), disc.v, disc.r) for end in (0, 1)]
    if side * drift < 0 and abs(side) - disc.r > -NOISE:
        time = max(D(0), abs(side) - disc.r) / abs(drift)
        foot = dot(moved(x, disc.v, time), wall.w) / length**2
        if 0 <= foot <= 1: times.append(time)
    return min((time for time in times if time is not None), default=None)

def upcoming(bodies):
    """The next impact of each pair: the time it takes, and their names."""
    names = list(bodies)
    for place, a in enumerate(names):
        for b in names[place + 1:]:
            one, other = bodies[a], bodies[b]
            if isinstance(one, Wall) or one.lightness == other.lightness == 0: continue
            if isinstance(other, Wall): time = to_wall(one, other)
            else: time = to_circle(moved(one.x, other.x, -1), moved(one.v, other.v, -1), one.r + other.r)
            if time is not None: yield time, (a, b)

def collide(a, b, restitution):
    still = isinstance(b, Wall)
    normal = moved(b.nearest(a.x) if still else b.x, a.x, -1)
    closing = dot(a.v if still else moved(a.v, b.v, -1), normal)
    push = (1 + restitution) * closing / dot(normal, normal) / (a.lightness + b.lightness)
    a.v = moved(a.v, normal, -push * a.lightness)
    if not still: b.v = moved(b.v, normal, push * b.lightness)

def replay(q):
    """What is wrong with a log, if anything."""
    scene, now = q["scene"], D(0)
    bodies = {f"d{i}": Disc(disc) for i, disc in enumerate(scene["discs"])}
    bodies |= {f"w{i}": Wall(wall) for i, wall in enumerate(scene.get("walls", []))}
    restitution = number(scene.get("effects", {}).get("restitution", {}).get("newton", "1"))
    for event in q["events"]:
        pair, times = (event["a"], event["b"]), dict(map(reversed, upcoming(bodies)))
        if pair not in times: return f"{event['n']} does not happen"
        time = times[pair]
        if min(times.values()) < time - SAME * max(1, now + time): return f"{event['n']} is not the next one"
        now += time
        if not number(event["lo"]) - NOISE <= now <= number(event["hi"]) + NOISE: return f"{event['n']} is at {now}"
        for body in bodies.values():
            if isinstance(body, Disc): body.x = moved(body.x, body.v, time)
        a, b = (bodies[name] for name in pair)
        if isinstance(b, Wall):
            part = b.part(a.x)
            if event.get("end") != ("from" if part < NOISE else "to" if 1 - part < NOISE else None): return f"{event['n']}: end"
        collide(a, b, restitution)
    until = number(scene["frame"]["duration"]) * scene["frame"]["count"]
    for time, pair in upcoming(bodies):
        if now + time < until - SAME: return f"{pair} is missing at {now + time}"

directory = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent
vectors = json.loads((directory / "scenes.json").read_text())["vectors"]
wrong = {q["id"]: fault for q in vectors if (fault := replay(q))}
for name, fault in wrong.items(): print(name, "is wrong:", fault)
print(f"scenes: {sum(len(q['events']) for q in vectors)} impacts of {len(vectors)} scenes replayed")
sys.exit(bool(wrong))
