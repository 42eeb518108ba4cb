#!/usr/bin/env python3
"""Checks the vectors from the physics alone, in exact fractions: `check.py [DIR]`; 1 if one is wrong.

The distance of two bodies in free motion is a convex function of the time, so a look at it
here and there proves where it first comes down to their reach."""
import json, math, pathlib, sys
from fractions import Fraction as F
SOON = F(1, 2**400)
def number(text): return F(float.fromhex(text)) if "x" in text else F(text)
def vector(texts): return tuple(map(number, texts))
def dot(a, b): return a[0] * b[0] + a[1] * b[1]
def cross(a, b): return a[0] * b[1] - a[1] * b[0]
def moved(a, b, t): return (a[0] + b[0] * t, a[1] + b[1] * t)
def sign(x): return (x > 0) - (x < 0)
def is_above(p, q, d, x): return sign(q) * q * q * d >= sign(x - p) * (x - p)**2  # p + q sqrt(d) >= x

class Pair:  # a disc's centre, seen from another centre, or from a wall's start; w is the wall
    def __init__(self, a, b):
        self.wall = "from" in b
        start, drift = (b["from"], ("0", "0")) if self.wall else (b["position"], b["velocity"])
        self.x = moved(vector(a["position"]), vector(start), -1)
        self.v = moved(vector(a["velocity"]), vector(drift), -1)
        self.w = moved(vector(b["to"]), vector(start), -1) if self.wall else (F(0), F(0))
        self.reach = number(a["radius"]) + (0 if self.wall else number(b["radius"]))
    def foot(self, t): return dot(moved(self.x, self.v, t), self.w) / dot(self.w, self.w)
    def square(self, t):
        foot = min(F(1), max(F(0), self.foot(t))) if self.wall else 0
        apart = moved(moved(self.x, self.v, t), self.w, -foot)
        return dot(apart, apart)
    def gap(self, t): return sign(self.square(t) - self.reach**2)
    def least(self, until=None):  # squared: at the start or the end, next to a wall's end, or on it
        times, speed, turn = [F(0)], dot(self.v, self.v), cross(self.v, self.w)
        if speed: times += [-dot(moved(self.x, self.w, -e), self.v) / speed for e in (0, 1)]
        if turn: times.append(-cross(self.x, self.w) / turn)
        if until is not None: times = [min(t, until) for t in times] + [until]
        return min(self.square(t) for t in times if t >= 0)
    def meets(self, lo, hi):  # whether they first meet between these times, or at them, and approach
        return 0 <= lo <= hi and self.gap(0) >= 0 and self.gap(lo) >= 0 >= self.gap(hi) and self.gap(hi + SOON) < 0
    def root(self, end, p, q, d):  # whether at p + q sqrt(d) an end's circle, or the wall's line is touched
        x = moved(self.x, self.w, -1) if end == "to" else self.x
        a, b, c = dot(self.v, self.v), dot(x, self.v), dot(x, x) - self.reach**2
        if self.wall and not end:
            a, b = cross(self.v, self.w), cross(self.x, self.w)
            a, b, c = a * a, a * b, b * b - self.reach**2 * dot(self.w, self.w)
        return a * (p * p + q * q * d) + 2 * b * p + c == 0 and q * (a * p + b) == 0

def first_impact(q):
    pair, end, time, lo, hi = Pair(q["a"], q["b"]), q.get("end"), q["time"], F(0), F(0)
    start, least = pair.gap(0), pair.least()
    if start > 0: yield "class", q["class"] == {1: "miss", 0: "graze", -1: "hit"}[sign(least - pair.reach**2)]
    elif start < 0: yield "class", q["class"] == "overlap"
    else: yield "class", q["class"] == ("touching-approaching" if pair.gap(SOON) < 0 else "touching-separating")
    comes = q["class"] in ("hit", "graze") if start > 0 else pair.square(SOON) < pair.square(0)
    yield "a time", (time is not None) == comes
    if time:
        lo, hi, (p, r, d) = F(time["lo"]), F(time["hi"]), (F(time["exact"][k]) for k in "pqd")
        yield "bounds", hi - lo <= hi / 10**19 and is_above(p, r, d, lo) and is_above(-p, -r, d, -hi)
        yield "nearest", time["f64"] in (float(lo), float(hi))
        yield "root", pair.root(end, p, r, d) if start > 0 else lo == hi == 0
    if q["class"] == "hit": yield "first", pair.meets(lo, hi)
    if q["class"] == "graze": yield "tangent", lo == hi and pair.square(lo) == least
    if pair.wall and q["class"] != "miss":
        yield "end", any(end == ("from" if f <= 0 else "to" if f >= 1 else None) for f in map(pair.foot, (lo, hi)))
    yield "end flag", ("EndPoint" in q["flags"]) == (end is not None)
    parts = [F(s) / pair.reach**2 for s in (pair.square(0), least)]
    margin = min(float(abs(s - 1)) / (math.sqrt(s) + 1) for s in parts)
    yield "margin", abs(q["margin"] - margin) <= 1e-12 * margin

def scene(q):
    discs, walls = q["scene"]["discs"], q["scene"].get("walls", [])
    bodies = {f"d{i}": d for i, d in enumerate(discs)} | {f"w{i}": w for i, w in enumerate(walls)}
    fixed = {n for n, b in bodies.items() if "from" in b or b.get("mass") == "infinite"}
    pairs = {(a, b): Pair(bodies[a], bodies[b]) for i, a in enumerate(bodies) for b in list(bodies)[i + 1:] if not {a, b} <= fixed}
    events, frame = q["events"], q["scene"]["frame"]
    until = F(events[0]["lo"]) if events else number(frame["duration"]) * frame["count"]
    yield "none earlier", all(pair.least(until) >= pair.reach**2 for pair in pairs.values())
    if events: yield "first", pairs[events[0]["a"], events[0]["b"]].meets(until, F(events[0]["hi"]))
    yield "order", all(F(e["lo"]) <= F(f["hi"]) for e, f in zip(events, events[1:]))

def response(q):
    a, b, n, e = q["a"], q.get("b"), vector(q["normal"]), number(q["restitution"])
    at_rest = {"mass": "infinite", "before": ["0", "0"], "after": ["0", "0"]}
    before, after = ([vector(body[when]) for body in (a, b or at_rest)] for when in ("before", "after"))
    change = [moved(y, x, -1) for x, y in zip(before, after)]
    relative = [dot(moved(x, y, -1), n) for x, y in (before, after)]
    yield "Newton", relative[0] > 0 and relative[1] == -e * relative[0]
    yield "tangent", all(cross(c, n) == 0 for c in change)
    if (b or at_rest)["mass"] == "infinite": yield "infinite", change[1] == (0, 0)
    else: yield "momentum", all(number(a["mass"]) * x + number(b["mass"]) * y == 0 for x, y in zip(*change))

directory, wrong = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent, False
for name in ("disc-disc", "disc-wall", "disc-end", "response", "scenes"):
    check = {"response": response, "scenes": scene}.get(name, first_impact)
    vectors = json.loads((directory / f"{name}.json").read_text())["vectors"]
    for q in vectors:
        if faults := [what for what, holds in check(q) if not holds]:
            wrong = not print(q["id"], "is wrong:", ", ".join(faults))
    print(f"{name}: {len(vectors)} checked")
sys.exit(wrong)
