"""First impacts of an adapter against `carom oracle`: classes, and errors of the times.

    python3 adapters/measure/first_impacts.py COMMAND…

from the top of the repository, after `cargo build --release`.
"""

import json
import math
import random
import subprocess
import sys
from collections import Counter
from statistics import median

ORACLE = ["target/release/carom", "oracle"]

SEED = 7
PAIRS = 5000
WALLS = 2000
LENGTHS = [1, 10, 100, 1e4, 1e6, 1e9]


def main(command):
    """Asks both, and shows how they differ."""
    source = random.Random(SEED)
    questions = {"discs": [pair(source) for _ in range(PAIRS)]}
    for length in LENGTHS:
        name = f"a wall of length {length:g}"
        questions[name] = [disc_and_wall(source, length) for _ in range(WALLS)]
    for name, asked in questions.items():
        show(name, answers(ORACLE, asked), answers(command, asked))


def disc(source):
    """A disc somewhere, at rest."""
    position = [source.uniform(-10, 10), source.uniform(-10, 10)]
    return {"position": position, "velocity": [0, 0], "radius": source.uniform(0.2, 1)}


def pair(source):
    """Two discs that move towards each other, or past each other closely."""
    a, b = disc(source), disc(source)
    dx, dy = (there - here for here, there in zip(a["position"], b["position"]))
    way = math.hypot(dx, dy)
    aside = source.uniform(-1.3, 1.3) * (a["radius"] + b["radius"]) / way
    b["velocity"] = [source.uniform(-1, 1), source.uniform(-1, 1)]
    towards = [(dx - dy * aside) / way, (dy + dx * aside) / way]
    a["velocity"] = [own + more for own, more in zip(b["velocity"], towards)]
    return a, b


def disc_and_wall(source, length):
    """A wall, and a disc that comes from 6 away to about the middle part of it."""
    x, y, angle = source.uniform(-5, 5), source.uniform(-5, 5), source.uniform(0, 2 * math.pi)
    cos, sin = math.cos(angle), math.sin(angle)
    before = source.uniform(0.1, 0.9) * length
    wall = {
        "from": [x - before * cos, y - before * sin],
        "to": [x + (length - before) * cos, y + (length - before) * sin],
    }
    mover = disc(source)
    mover["position"] = [x - 6 * sin, y + 6 * cos]
    mover["velocity"] = [sin + source.uniform(-0.5, 0.5), -cos + source.uniform(-0.5, 0.5)]
    return mover, wall


def answers(command, asked):
    """What a program says to all questions."""
    lines = [
        json.dumps({"id": number, "request": "first-impact", "a": a, "b": b})
        for number, (a, b) in enumerate(asked)
    ]
    text = "\n".join(lines)
    run = subprocess.run(command, input=text, capture_output=True, text=True, check=True)
    found = [json.loads(line) for line in run.stdout.splitlines()]
    assert [answer["id"] for answer in found] == list(range(len(asked)))
    return found


def show(name, truth, said):
    """Classes and errors."""
    both = [(true, answer.get("class", "error"), answer) for true, answer in zip(truth, said)]
    classes = Counter((true["class"], word) for true, word, _ in both)
    print(f"{name}: {len(truth)}")
    for (true, word), count in sorted(classes.items()):
        print(f"    {true}, answered {word}: {count}")
    errors = [
        abs(answer["time"]["f64"] / true["time"]["f64"] - 1)
        for true, word, answer in both
        if true["class"] == word == "hit"
    ]
    if errors:
        told = f"median {median(errors):.1e}, largest {max(errors):.1e}"
        print(f"    error of the time, relative: {told}")


if __name__ == "__main__":
    main(sys.argv[1:])
