"""How long the steps are of an engine that steps."""

import argparse
import math

from scene import Refused

#: A run of more steps is refused.
MOST_STEPS = 1_000_000


def add_options(parser: argparse.ArgumentParser):
    """The options that say how long a step is."""
    parser.add_argument(
        "--substeps",
        type=natural,
        default=10,
        help="a frame of the scene has at least so many steps (default 10)",
    )
    parser.add_argument(
        "--max-step",
        type=positive,
        default=1 / 60,
        help="no step is longer (default 1/60, 0.01666…)",
    )


def natural(text):
    """A positive integer."""
    value = int(text)
    if value < 1:
        raise ValueError(text)
    return value


def positive(text):
    """A positive number."""
    value = float(text)
    if not 0 < value < math.inf:
        raise ValueError(text)
    return value


def steps(scene, substeps, max_step):
    """The length of a step, and how many there are."""
    a_frame = max(substeps, scene.duration / max_step)
    if not a_frame * scene.count <= MOST_STEPS:
        raise Refused(f"more than {MOST_STEPS} steps")
    a_frame = math.ceil(a_frame)
    return scene.duration / a_frame, a_frame * scene.count
