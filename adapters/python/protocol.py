"""carom's questions, a line of JSON each, and an engine's answers in the same order.

An engine has two functions, each of which may raise `Refused`:
`simulate(scene)` gives the impacts as (time, a, b), and `first_impact(disc, other)` the
time of the first, or `None`.
"""

import json
import sys

from scene import Refused, Wall, read_disc, read_scene, read_wall


def serve(engine, source=None, target=None):
    """Answers all lines."""
    source = source or sys.stdin.buffer
    target = target or sys.stdout
    for line in source:
        if line.strip():
            target.write(answer(engine, line) + "\n")
            target.flush()


def answer(engine, line):
    """The answer to a line, as JSON."""
    name = None
    try:
        request = parse(line)
        name = request.get("id")
        return written(name, content(engine, request))
    except Refused as refusal:
        return problem(name, str(refusal))
    except Exception as error:  # Whatever the engine raises is its answer.
        return problem(name, f"the engine stopped: {type(error).__name__}: {error}")


def problem(name, reason):
    """An error answer."""
    return written(name, {"error": {"reason": reason}})


def written(name, said):
    """An answer as JSON; a name that JSON cannot hold, as 1e999, is left out."""
    try:
        return json.dumps({"id": name, **said}, allow_nan=False)
    except ValueError:
        reason = "the answer or its id is not finite"
        return json.dumps({"id": None, "error": {"reason": reason}})


def parse(line):
    """The request of a line."""
    try:
        request = json.loads(line.decode("utf-8"), parse_constant=refuse_constant)
    except (ValueError, RecursionError) as error:
        raise Refused(f"not a line of JSON: {error}") from None
    if not isinstance(request, dict):
        raise Refused("expected an object")
    return request


def refuse_constant(name):
    """NaN and infinities, which Python would read, are not JSON."""
    raise Refused(f"not a line of JSON: {name}")


def content(engine, request):
    """What is said to a request."""
    match request.get("request"):
        case "simulate":
            scene = read_scene(wanted(request, "scene"))
            return {"events": [event(*impact) for impact in engine.simulate(scene)]}
        case "first-impact":
            return meeting(engine.first_impact(*two_bodies(request)))
        case other:
            raise Refused(f"expected simulate or first-impact, found {other!r:.60}")


def two_bodies(request):
    """A disc, and a disc or a wall."""
    a, b = wanted(request, "a"), wanted(request, "b")
    is_wall = isinstance(b, dict) and "from" in b
    return read_disc(a, "a"), (read_wall if is_wall else read_disc)(b, "b")


def wanted(request, key):
    """The value of a key that must be there."""
    if key not in request:
        raise Refused(f"expected the key {key}")
    return request[key]


def meeting(time):
    """The answer to a first impact."""
    if time is None:
        return {"class": "miss"}
    return {"class": "hit", "time": {"f64": time}}


def event(time, a, b):
    """An impact of two named bodies."""
    return {"time": time, "a": a, "b": b}


def pair(i, j):
    """The names of two discs, the lower index first."""
    return f"d{min(i, j)}", f"d{max(i, j)}"


def is_wall(body):
    """Whether a body of a first impact is a wall."""
    return isinstance(body, Wall)
