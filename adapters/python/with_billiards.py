"""billiards, which goes from event to event: elastic balls and one-sided infinite walls.

A wall of a scene is two of the engine's walls, one for each side. Where a disc meets the
line of a wall beyond its ends, the engine has no such wall, and the scene is refused.
"""

import argparse
import math

import billiards
import numpy
from billiards.physics import time_of_impact

from protocol import is_wall, pair, serve
from scene import Refused

#: A run with more impacts is refused.
MOST_IMPACTS = 100_000

#: A disc that is nearer to a wall's line than this part of its radius lies across it.
ACROSS = 1 - 1e-9


class Engine:
    """The engine as it comes."""

    def __init__(self, max_impacts=MOST_IMPACTS):
        self.max_impacts = max_impacts

    def simulate(self, scene):
        """The impacts, as the engine's `evolve` finds them one by one."""
        refuse(scene)
        sides = [(place, side) for place, wall in enumerate(scene.walls) for side in both(wall)]
        place_of = {id(side): place for place, side in sides}
        table = billiards.Billiard(obstacles=[side for _, side in sides])
        for disc in scene.discs:
            table.add_ball(disc.position, disc.velocity, disc.radius, disc.mass)
        impacts = []
        while min(table.toi_next[0], table.obstacles_next[0]) <= scene.until:
            if len(impacts) == self.max_impacts:
                raise Refused(f"more than {self.max_impacts} impacts")
            if table.toi_next[0] <= table.obstacles_next[0]:
                time, one, other = table.bounce_ballball()
                check_masses(scene, one, other)
                impacts.append((float(time), *pair(one, other)))
            else:
                time, one, side = table.bounce_ballobstacle()
                place = place_of[id(side)]
                check_foot(scene, one, place, table.balls_position[one])
                impacts.append((float(time), f"d{one}", f"w{place}"))
        return impacts

    def first_impact(self, disc, other):
        """The engine's time of impact."""
        position, velocity = numpy.array(disc.position), numpy.array(disc.velocity)
        if not is_wall(other):
            time = time_of_impact(
                position, velocity, disc.radius, other.position, other.velocity, other.radius
            )
            return time_or_none(time)
        check_side(disc, other, "a", "b")
        sides = both(other)
        time = time_or_none(min(side.calc_toi(position, velocity, disc.radius) for side in sides))
        if time is not None and not has_foot(other, position + velocity * time):
            raise Refused(beyond("a", "b"))
        return time


def time_or_none(time):
    """A time, unless it is never."""
    return None if math.isinf(time) else float(time)


def refuse(scene):
    """Refuses what the engine does not have."""
    if scene.periodic:
        raise Refused("the engine has no periodic scenes")
    scene.effects.refuse("gravity", "newton", "paper", "drag")
    for place, disc in enumerate(scene.discs):
        for number, wall in enumerate(scene.walls):
            check_side(disc, wall, f"d{place}", f"w{number}")


def both(wall):
    """The engine's walls for the two sides of a wall."""
    return [billiards.InfiniteWall(wall.start, wall.end, inside) for inside in ("left", "right")]


def check_side(disc, wall, a, b):
    """Refuses a disc across the line of a wall beyond its ends: it may meet an end, but
    the engine's walls let through what lies across them."""
    (x, y), (dx, dy) = minus(disc.position, wall.start), minus(wall.end, wall.start)
    is_across = abs(dx * y - dy * x) < ACROSS * disc.radius * math.hypot(dx, dy)
    if is_across and not has_foot(wall, disc.position):
        raise Refused(f"{a} lies across the line of {b} at the start, beyond its ends")


def check_masses(scene, one, other):
    """Refuses an impact of discs of infinite mass; the engine moves one of them."""
    if scene.discs[one].is_fixed and scene.discs[other].is_fixed:
        raise Refused(f"d{one} and d{other} of infinite mass collide in the engine")


def check_foot(scene, one, place, position):
    """Refuses what the engine's infinite walls do not have."""
    if scene.discs[one].is_fixed:
        raise Refused(f"d{one} of infinite mass is deflected by walls in the engine")
    if not has_foot(scene.walls[place], position):
        raise Refused(beyond(f"d{one}", f"w{place}"))


def beyond(a, b):
    """What is said of an impact beyond the ends of a wall."""
    return f"{a} meets the line of {b} beyond its ends, and the engine's walls have none"


def has_foot(wall, position):
    """Whether the foot of the perpendicular is on the wall."""
    along = minus(wall.end, wall.start)
    from_start, from_end = minus(position, wall.start), minus(position, wall.end)
    return dot(from_start, along) >= 0 >= dot(from_end, along)


def minus(one, other):
    """The difference of two vectors."""
    return one[0] - other[0], one[1] - other[1]


def dot(one, other):
    """The scalar product."""
    return one[0] * other[0] + one[1] * other[1]


if __name__ == "__main__":
    options = argparse.ArgumentParser(prog="run billiards", description=__doc__)
    options.add_argument(
        "--max-impacts", type=int, default=MOST_IMPACTS, help="a run with more is refused"
    )
    serve(Engine(options.parse_args().max_impacts))
