"""Both engines as they are run, with answers derived by hand."""

import json
import subprocess
import sys
import unittest
from pathlib import Path

#: No step of the engine that steps is longer.
STEP = 1 / 60

HERE = Path(__file__).parent


def disc(position, velocity=(0, 0), **other):
    """A disc of radius 1."""
    return {"position": position, "velocity": list(velocity), "radius": 1, **other}


def scene(discs, duration, **other):
    """A scene of one frame."""
    frame = {"duration": duration}
    return {"schema": "carom/scene/1", "discs": discs, "frame": frame, **other}


#: A gap of 5 - 2, closing at 1 + 2: at 1. Then they swap their velocities, and part.
HEAD_ON = scene([disc([0, 0], [1, 0]), disc([5, 0], [-2, 0])], 3)

#: The way to the wall is 3 - 1 at speed 1: at 2. Then it leaves.
INTO_A_WALL = scene([disc([0, 0], [1, 0])], 3, walls=[{"from": [3, -1], "to": [3, 1]}])

#: The other is 3 aside, and 2 would be a touch.
MISS = scene([disc([0, 0], [1, 0]), disc([5, "0x1.8p+1"])], 10)

#: Three of one mass on a line: the first meets the second at 1, which meets the third 2
#: later.
THREE = scene([disc([0, 0], [1, 0]), disc([3, 0]), disc([7, 0])], 5)

PERIODIC = scene([disc([5, 5])], 1, periodic={"from": [0, 0], "to": [10, 10]})


def ask(name, lines):
    """The answers of an adapter to lines."""
    lines = [line if isinstance(line, str) else json.dumps(line) for line in lines]
    run = subprocess.run(
        [sys.executable, HERE / f"with_{name}.py"],
        input="\n".join(lines),
        capture_output=True,
        text=True,
        check=True,
    )
    return [json.loads(line) for line in run.stdout.splitlines()]


def simulate(name, *scenes):
    """The answers to scenes."""
    return ask(
        name,
        [{"id": n, "request": "simulate", "scene": scene} for n, scene in enumerate(scenes)],
    )


def first_impacts(name, *scenes):
    """The answers to the first impact of the first disc of each scene."""
    lines = []
    for number, of in enumerate(scenes):
        other = of["walls"][0] if "walls" in of else of["discs"][1]
        a = of["discs"][0]
        lines.append({"id": number, "request": "first-impact", "a": a, "b": other})
    return ask(name, lines)


class Engines(unittest.TestCase):
    def assert_impacts(self, answer, expected, within):
        """Checks the bodies in order, and the times."""
        events = answer["events"]
        self.assertEqual([(event["a"], event["b"]) for event in events], [e[1:] for e in expected])
        for event, (time, *_) in zip(events, expected):
            self.assertLessEqual(abs(event["time"] - time), within, answer)

    def check_runs(self, name, within):
        """Runs, then what is answered by an error, then a run again."""
        requests = [
            {"id": number, "request": "simulate", "scene": scene}
            for number, scene in enumerate([HEAD_ON, INTO_A_WALL, MISS, PERIODIC, THREE])
        ]
        requests.insert(3, '{"id": 9, "request"')
        answers = ask(name, requests)
        self.assertEqual([answer["id"] for answer in answers], [0, 1, 2, None, 3, 4])
        self.assert_impacts(answers[0], [(1, "d0", "d1")], within)
        self.assert_impacts(answers[1], [(2, "d0", "w0")], within)
        self.assert_impacts(answers[2], [], within)
        self.assertIn("JSON", answers[3]["error"]["reason"])
        self.assertIn("periodic", answers[4]["error"]["reason"])
        self.assert_impacts(answers[5], [(1, "d0", "d1"), (3, "d1", "d2")], 2 * within)

    def check_first_impacts(self, name):
        """The same three questions."""
        head_on, wall, miss = first_impacts(name, HEAD_ON, INTO_A_WALL, MISS)
        for answer, time in [(head_on, 1), (wall, 2)]:
            self.assertEqual(answer["class"], "hit")
            self.assertAlmostEqual(answer["time"]["f64"], time, places=12)
        self.assertEqual(miss, {"id": 2, "class": "miss"})

    def test_pymunk(self):
        # Overlap is found a step late, and rounding may cost one more.
        self.check_runs("pymunk", 2 * STEP)
        self.check_first_impacts("pymunk")

    def test_pymunk_falls(self):
        # From 19.6 above, with gravity 9.8: 2 until the wall is met.
        walls = [{"from": [-9, 0], "to": [9, 0]}]
        falling = scene([disc([0, "103/5"])], 3, walls=walls, effects={"gravity": [0, "-9.8"]})
        (answer,) = simulate("pymunk", falling)
        self.assert_impacts(answer, [(2, "d0", "w0")], 2 * STEP)

    def test_pymunk_has_newtons_law(self):
        # From 1 to the wall: 1. Back at speed 1/2, from 2 to 1 takes 2.
        walls = [{"from": [3, -1], "to": [3, 1]}, {"from": [0, -1], "to": [0, 1]}]
        law = {"restitution": {"newton": 1, "walls": "1/2"}}
        (answer,) = simulate("pymunk", scene([disc([1, 0], [1, 0])], 4, walls=walls, effects=law))
        self.assert_impacts(answer, [(1, "d0", "w0"), (3, "d0", "w1")], 4 * STEP)

    def test_pymunk_has_infinite_masses(self):
        # The heavy one reaches the other at 1, and passes through the wall.
        walls = [{"from": [2, -1], "to": [2, 1]}]
        heavy = disc([0, 0], [1, 0], mass="infinite")
        (answer,) = simulate("pymunk", scene([heavy, disc([3, 0])], 2, walls=walls))
        touching_the_wall = [event for event in answer["events"] if event["a"] == "d0"]
        self.assert_impacts({"events": touching_the_wall}, [(1, "d0", "d1")], 2 * STEP)

    def test_billiards(self):
        self.check_runs("billiards", 1e-12)
        self.check_first_impacts("billiards")

    def test_billiards_has_both_sides_of_a_wall(self):
        # From the other side, 2 away: at 2.
        back = scene([disc([6, 0], [-1, 0])], 3, walls=INTO_A_WALL["walls"])
        self.assert_impacts(simulate("billiards", back)[0], [(2, "d0", "w0")], 1e-12)

    def test_billiards_has_no_ends_of_walls(self):
        # The line of the wall is met 1/2 above its end, and the end itself by the disc.
        wall = [{"from": [3, -1], "to": [3, 1]}]
        beyond = scene([disc([0, "3/2"], [1, 0])], 3, walls=wall)
        across = scene([disc([3, 5], [1, 0])], 3, walls=wall)
        answers = simulate("billiards", beyond, across)
        answers += first_impacts("billiards", beyond, across)
        for answer in answers:
            self.assertIn("the line of", answer["error"]["reason"])

    def test_billiards_refuses_what_it_has_not(self):
        walls = INTO_A_WALL["walls"]
        heavy = scene([disc([0, 0], [1, 0], mass="infinite")], 3, walls=walls)
        law = scene([disc([0, 0])], 1, effects={"restitution": {"newton": "1/2"}})
        falling = scene([disc([0, 0])], 1, effects={"gravity": [0, -1]})
        for answer in simulate("billiards", heavy, law, falling):
            self.assertIn("reason", answer["error"])


if __name__ == "__main__":
    unittest.main()
