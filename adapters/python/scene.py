"""Scenes (`carom/scene/1`) in binary64, checked as they are read."""

import math
from dataclasses import dataclass

from numbers_as_written import NotANumber, nearest


class Refused(Exception):
    """Why a request has no answer."""


@dataclass(frozen=True)
class Disc:
    """A disc at the start; `mass` may be infinite."""

    position: tuple
    velocity: tuple
    radius: float
    mass: float

    @property
    def is_fixed(self):
        """Whether collisions never deflect it."""
        return math.isinf(self.mass)


@dataclass(frozen=True)
class Wall:
    """A two-sided segment."""

    start: tuple
    end: tuple


@dataclass(frozen=True)
class Effects:
    """What is not free motion. Keys that are absent are `None`."""

    gravity: tuple | None = None
    newton: float | None = None
    walls: float | None = None
    elastic_below: float | None = None
    paper: float | None = None
    drag: float | None = None

    def refuse(self, *names):
        """Refuses a scene with one of these effects."""
        for name in names:
            if getattr(self, name) is not None:
                raise Refused(f"the engine has no {NAMES[name]}")


#: The effects in words.
NAMES = {
    "gravity": "gravity",
    "newton": "restitution other than elastic",
    "walls": "restitution of walls alone",
    "elastic_below": "restitution that ends below a speed (elastic_below)",
    "paper": "restitution in the paper's convention",
    "drag": "linear drag",
}


@dataclass(frozen=True)
class Scene:
    """What is to be simulated."""

    discs: list
    walls: list
    duration: float
    count: int
    effects: Effects
    periodic: bool

    @property
    def until(self):
        """When the run ends."""
        return self.duration * self.count


def read_scene(value):
    """A scene from JSON."""
    keys(
        value,
        "scene",
        required=("schema", "discs"),
        optional=("id", "notes", "walls", "periodic", "frame", "effects"),
    )
    if value["schema"] != "carom/scene/1":
        raise Refused(f"schema: expected carom/scene/1, found {value['schema']!r:.60}")
    duration, count = read_frame(value.get("frame", {}))
    if math.isinf(duration * count):
        raise Refused("frame: the end of the run is beyond binary64")
    return Scene(
        discs=[read_disc(item, at) for item, at in items(value["discs"], "discs")],
        walls=[read_wall(item, at) for item, at in items(value.get("walls", []), "walls")],
        duration=duration,
        count=count,
        effects=read_effects(value.get("effects", {})),
        periodic="periodic" in value,
    )


def read_disc(value, at):
    """A disc from JSON."""
    keys(value, at, required=("position", "radius"), optional=("velocity", "mass"))
    mass = value.get("mass", 1)
    return Disc(
        position=point(value["position"], f"{at}.position"),
        velocity=point(value.get("velocity", [0, 0]), f"{at}.velocity"),
        radius=positive(value["radius"], f"{at}.radius"),
        mass=math.inf if mass == "infinite" else positive(mass, f"{at}.mass"),
    )


def read_wall(value, at):
    """A wall from JSON."""
    keys(value, at, required=("from", "to"))
    start, end = point(value["from"], f"{at}.from"), point(value["to"], f"{at}.to")
    if start == end:
        raise Refused(f"{at}: the ends are one point in binary64")
    return Wall(start, end)


def read_frame(value):
    """The duration of a frame, and how many there are."""
    keys(value, "frame", optional=("duration", "count"))
    count = value.get("count", 1)
    if isinstance(count, bool) or not isinstance(count, int) or count < 1:
        raise Refused("frame.count: expected a positive integer")
    return positive(value.get("duration", 1), "frame.duration"), count


def read_effects(value):
    """The effects of a scene."""
    keys(value, "effects", optional=("restitution", "gravity", "drag"))
    found = {}
    if "gravity" in value:
        found["gravity"] = point(value["gravity"], "effects.gravity")
    if "drag" in value:
        keys(value["drag"], "effects.drag", required=("linear",))
        found["drag"] = number(value["drag"]["linear"], "effects.drag.linear")
    if "restitution" in value:
        at, kinds = "effects.restitution", ("newton", "walls", "elastic_below", "paper")
        keys(value["restitution"], at, optional=kinds)
        for kind, written in value["restitution"].items():
            found[kind] = number(written, f"{at}.{kind}")
    return Effects(**found)


def keys(value, at, required=(), optional=()):
    """Checks which keys an object has."""
    if not isinstance(value, dict):
        raise Refused(f"{at}: expected an object")
    for key in required:
        if key not in value:
            raise Refused(f"{at}.{key}: this key is missing")
    for key in value:
        if key not in required and key not in optional:
            raise Refused(f"{at}: unknown key {key!r:.60}")


def items(value, at):
    """The items of an array, each with its path."""
    if not isinstance(value, list):
        raise Refused(f"{at}: expected an array")
    return [(item, f"{at}[{place}]") for place, item in enumerate(value)]


def point(value, at):
    """A pair of numbers."""
    if not isinstance(value, list) or len(value) != 2:
        raise Refused(f"{at}: expected two numbers")
    return number(value[0], f"{at}[0]"), number(value[1], f"{at}[1]")


def positive(value, at):
    """A number above zero, in binary64 too."""
    found = number(value, at)
    if found <= 0:
        raise Refused(f"{at}: expected a positive number")
    return found


def number(value, at):
    """The binary64 number nearest to what is written."""
    try:
        return nearest(value)
    except NotANumber as error:
        raise Refused(f"{at}: {error}") from None
