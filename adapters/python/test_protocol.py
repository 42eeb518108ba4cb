"""Requests and answers, with an engine that only repeats."""

import io
import json
import unittest

from protocol import is_wall, serve
from scene import Refused


class Echo:
    """Repeats what it is asked."""

    def simulate(self, scene):
        if not scene.discs:
            raise AssertionError("an engine may stop")
        return [(scene.until, "d0", "w1")]

    def first_impact(self, disc, other):
        if is_wall(other):
            return None
        if disc.is_fixed:
            raise Refused("no infinite masses")
        return disc.radius + other.radius


def answers(*lines):
    """The answers to lines of JSON or of bytes."""
    lines = [line if isinstance(line, bytes) else json.dumps(line).encode() for line in lines]
    target = io.StringIO()
    serve(Echo(), lines, target)
    return [json.loads(line) for line in target.getvalue().splitlines()]


def scene(**other):
    """A scene of one disc."""
    disc = {"position": [0, 0], "radius": 1}
    return {"schema": "carom/scene/1", "discs": [disc], **other}


def simulate(of):
    """A request."""
    return {"id": 1, "request": "simulate", "scene": of}


class Protocol(unittest.TestCase):
    def test_a_run(self):
        frame = {"duration": "1/2", "count": 3}
        (answer,) = answers(simulate(scene(frame=frame)))
        event = {"time": 1.5, "a": "d0", "b": "w1"}
        self.assertEqual(answer, {"id": 1, "events": [event]})

    def test_first_impacts(self):
        a = {"position": [0, 0], "radius": "1/2"}
        disc, wall = {"position": [5, 0], "radius": 1}, {"from": [1, 1], "to": [2, 1]}
        heavy = {**a, "mass": "infinite"}
        pairs = [(a, disc), (a, wall), (heavy, disc)]
        lines = [{"id": ["x"], "request": "first-impact", "a": a, "b": b} for a, b in pairs]
        hit, miss, refused = answers(*lines)
        self.assertEqual(hit, {"id": ["x"], "class": "hit", "time": {"f64": 1.5}})
        self.assertEqual(miss, {"id": ["x"], "class": "miss"})
        self.assertEqual(refused, {"id": ["x"], "error": {"reason": "no infinite masses"}})

    def test_bad_lines_have_answers_in_order(self):
        lines = [b"{", b"\xff", b"[]", b"[" * 100_000, b'{"id": NaN}', b'{"id": 1e999}']
        lines += [b"", b" \n"]
        lines += [{"id": 1, "request": "guess"}, {"id": 2, "request": "simulate"}]
        empty = {"schema": "carom/scene/1", "discs": []}
        lines += [{"id": 3, "request": "simulate", "scene": empty}]
        lines += [simulate(scene())]
        found = answers(*lines)
        self.assertEqual([answer["id"] for answer in found], [None] * 6 + [1, 2, 3, 1])
        self.assertTrue(all(answer["error"]["reason"] for answer in found[:-1]))
        self.assertIn("an engine may stop", found[-2]["error"]["reason"])
        self.assertIn("events", found[-1])

    def test_what_is_wrong_with_a_scene_is_named(self):
        disc = {"position": [0, 0], "radius": 1}
        table = [
            (scene(schema="other"), "schema"),
            (scene(extra=1), "extra"),
            (scene(discs=[{"position": [0, 0]}]), "discs[0].radius"),
            (scene(discs=[{**disc, "radius": 0}]), "discs[0].radius"),
            (scene(discs=[{**disc, "radius": "1e-999"}]), "discs[0].radius"),
            (scene(discs=[{**disc, "mass": -1}]), "discs[0].mass"),
            (scene(discs=[{**disc, "velocity": [1]}]), "discs[0].velocity"),
            (scene(discs=[{**disc, "position": [1, "x"]}]), "discs[0].position[1]"),
            (scene(discs={}), "discs"),
            (scene(walls=[{"from": [0, 0], "to": [0, "0/7"]}]), "walls[0]"),
            (scene(frame={"count": 0}), "frame.count"),
            (scene(frame={"duration": 0}), "frame.duration"),
            (scene(frame={"duration": 1e308, "count": 2}), "frame"),
            (scene(effects={"wind": 1}), "wind"),
            (scene(effects={"restitution": {"other": 1}}), "other"),
        ]
        for wrong, place in table:
            with self.subTest(place=place):
                (answer,) = answers(simulate(wrong))
                self.assertIn(place, answer["error"]["reason"])


if __name__ == "__main__":
    unittest.main()
