"""A small simulation of somebody's own, held against the truth by way of `carom oracle`.

    python3 examples/your_own.py [path of carom]

exits with 1 if it differs. `examples/your_own.rs` is the same in Rust.
"""

import json
import subprocess
import sys

RADIUS, UNTIL = 1.0, 10.0
DISCS = [(2.0, 3.0), (6.5, -2.0), (11.0, 1.25), (17.0, -4.5)]
WALLS = [0.0, 20.0]


def simulate():
    """What is tested: equal discs on a line between two walls."""
    places, speeds = [list(column) for column in zip(*DISCS)]
    now, events = 0.0, []
    while True:
        waits = []
        for i, (x, v) in enumerate(zip(places, speeds)):
            if v < 0:
                waits.append(((WALLS[0] + RADIUS - x) / v, i, "w0"))
            if v > 0:
                waits.append(((WALLS[1] - RADIUS - x) / v, i, "w1"))
            for j in range(i + 1, len(places)):
                if speeds[j] < v:
                    gap = places[j] - x - 2 * RADIUS
                    waits.append((gap / (v - speeds[j]), i, j))
        wait, i, other = min(waits, key=lambda entry: entry[0])
        now += wait
        if now > UNTIL:
            return events
        places = [x + v * wait for x, v in zip(places, speeds)]
        if isinstance(other, str):
            speeds[i] = -speeds[i]
        else:
            speeds[i], speeds[other] = speeds[other], speeds[i]
            other = f"d{other}"
        events.append({"time": now, "a": f"d{i}", "b": other})


def judge(events, carom):
    """The check itself: a line to the oracle, and its answer."""
    scene = {
        "schema": "carom/scene/1",
        "discs": [{"position": [x, 0], "velocity": [v, 0], "radius": RADIUS} for x, v in DISCS],
        "walls": [{"from": [x, -5], "to": [x, 5]} for x in WALLS],
        "frame": {"duration": UNTIL},
    }
    question = json.dumps({"request": "judge", "scene": scene, "events": events})
    answer = subprocess.run([carom, "oracle"], input=question, capture_output=True, text=True)
    return json.loads(answer.stdout)["verdict"]


if __name__ == "__main__":
    verdict = judge(simulate(), sys.argv[1] if len(sys.argv) > 1 else "carom")
    print(json.dumps(verdict, indent=2))
    sys.exit(verdict["verdict"] == "differs")
