"""pymunk, the Python binding of Chipmunk, which steps: overlaps are found after each step.

A time is that of the end of the step in which Chipmunk first finds the overlap.
"""

import argparse
import math

import pymunk

import stepping
from protocol import is_wall, pair, serve
from scene import Refused


class Engine:
    """Chipmunk with these steps, and otherwise as it comes."""

    def __init__(self, options):
        self.options = options

    def simulate(self, scene):
        """The impacts: each contact that begins."""
        refuse(scene)
        length, count = stepping.steps(scene, self.options.substeps, self.options.max_step)
        space, log = fill(scene, self.options), []
        listen(space, scene, log)
        impacts = []
        for step in range(1, count + 1):
            space.step(length)
            # The last step ends with the run, and not by rounding after it.
            time = min(step * length, scene.until)
            impacts += [(time, *names) for names in log]
            log.clear()
        return impacts

    def first_impact(self, disc, other):
        """Chipmunk's query of a thick segment: the path of the disc, seen from the other."""
        still = (0.0, 0.0) if is_wall(other) else other.velocity
        velocity = minus(disc.velocity, still)
        speed = math.hypot(*velocity)
        if speed == 0:
            return None
        shape = shape_of(other)
        horizon = reach(disc, other) / speed
        start = disc.position
        end = (start[0] + velocity[0] * horizon, start[1] + velocity[1] * horizon)
        found = shape.segment_query(start, end, disc.radius)
        return None if found is None else found.alpha * horizon


def refuse(scene):
    """Refuses what Chipmunk does not have."""
    if scene.periodic:
        raise Refused("the engine has no periodic scenes")
    scene.effects.refuse("elastic_below", "paper", "drag")


def fill(scene, options):
    """A space with all bodies."""
    space = pymunk.Space()
    space.gravity = scene.effects.gravity or (0, 0)
    space.damping = 1
    space.iterations = options.iterations
    space.collision_slop = options.slop
    for place, disc in enumerate(scene.discs):
        body = body_of(disc)
        shape = pymunk.Circle(body, disc.radius)
        space.add(body, named(shape, f"d{place}"))
    for place, wall in enumerate(scene.walls):
        shape = pymunk.Segment(space.static_body, wall.start, wall.end, 0)
        space.add(named(shape, f"w{place}"))
    return space


def body_of(disc):
    """The body of a disc. One of infinite mass is kinematic: it moves, undeflected."""
    if disc.is_fixed:
        body = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
    else:
        # Without friction nothing turns, so that the moment is of no account.
        body = pymunk.Body(disc.mass, math.inf)
    body.position, body.velocity = disc.position, disc.velocity
    return body


def named(shape, name):
    """An elastic shape without friction."""
    shape.elasticity, shape.friction, shape.name = 1, 0, name
    return shape


def listen(space, scene, log):
    """Logs the contacts that begin, and sets the restitution of those that go on."""
    effects = scene.effects
    discs = 1 if effects.newton is None else effects.newton
    walls = discs if effects.walls is None else effects.walls

    def begin(arbiter, _space, _data):
        a, b = arbiter.shapes
        if all(shape.body.body_type != pymunk.Body.DYNAMIC for shape in (a, b)):
            arbiter.process_collision = False
        else:
            log.append(in_order(a.name, b.name))

    def pre_solve(arbiter, _space, _data):
        with_wall = any(shape.name[0] == "w" for shape in arbiter.shapes)
        arbiter.restitution = walls if with_wall else discs

    space.on_collision(begin=begin, pre_solve=None if discs == walls == 1 else pre_solve)


def in_order(a, b):
    """Two names, a disc before a wall, the lower index first."""
    if a[0] == b[0]:
        return pair(int(a[1:]), int(b[1:]))
    return (a, b) if a[0] == "d" else (b, a)


def shape_of(other):
    """The shape of a body that is asked about."""
    body = pymunk.Body(body_type=pymunk.Body.STATIC)
    if is_wall(other):
        shape = pymunk.Segment(body, other.start, other.end, 0)
    else:
        body.position = other.position
        shape = pymunk.Circle(body, other.radius)
    shape.cache_bb()
    return shape


def reach(disc, other):
    """So far at most the disc goes until it meets the other."""
    if is_wall(other):
        ends = [minus(end, disc.position) for end in (other.start, other.end)]
        return max(math.hypot(*end) for end in ends) + disc.radius
    return math.hypot(*minus(other.position, disc.position)) + disc.radius + other.radius


def minus(one, other):
    """The difference of two vectors."""
    return one[0] - other[0], one[1] - other[1]


def parser():
    """The options."""
    options = argparse.ArgumentParser(prog="run pymunk", description=__doc__)
    stepping.add_options(options)
    options.add_argument(
        "--iterations",
        type=stepping.natural,
        default=10,
        help="of the solver, a step (Chipmunk's default, 10)",
    )
    options.add_argument(
        "--slop",
        type=float,
        default=0.1,
        help="the overlap that is not corrected (Chipmunk's default, 0.1)",
    )
    return options


if __name__ == "__main__":
    serve(Engine(parser().parse_args()))
