"""How many impacts of gases a run of an adapter follows, by `carom check`.

    python3 adapters/measure/gases.py COMMAND…

from the top of the repository, after `cargo build --release`.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median

CAROM = "target/release/carom"

SEEDS = range(1, 11)
DISCS = 10


def main(command):
    """Runs all gases, and shows what is followed."""
    with tempfile.TemporaryDirectory() as folder:
        files = [gas(Path(folder) / f"{seed}.json", seed) for seed in SEEDS]
        logs = runs(command, [json.loads(file.read_text()) for file in files])
        counts = [followed(file, log) for file, log in zip(files, logs)]
    ours, theirs = zip(*counts)
    print(f"followed: median {median(ours)}, from {min(ours)} to {max(ours)}")
    print(f"impacts: {sum(map(len, logs))} logged, {sum(theirs)} in truth")


def gas(file, seed):
    """A gas in a file."""
    options = ["--seed", str(seed), "--count", str(DISCS), "--output", str(file)]
    subprocess.run([CAROM, "generate", "gas", *options], check=True)
    return file


def runs(command, scenes):
    """The impacts of each scene."""
    lines = [
        json.dumps({"id": number, "request": "simulate", "scene": scene})
        for number, scene in enumerate(scenes)
    ]
    text = "\n".join(lines)
    run = subprocess.run(command, input=text, capture_output=True, text=True, check=True)
    return [json.loads(line)["events"] for line in run.stdout.splitlines()]


def followed(file, log):
    """How many impacts are as they truly happen, and of how many."""
    lines = "\n".join(json.dumps(event) for event in log)
    command = [CAROM, "check", str(file), "--events", "-"]
    check = subprocess.run(command, input=lines, capture_output=True, text=True)
    ours, theirs = re.search(r"(\d+) of (\d+) impacts as they truly", check.stdout).groups()
    return int(ours), int(theirs)


if __name__ == "__main__":
    main(sys.argv[1:])
