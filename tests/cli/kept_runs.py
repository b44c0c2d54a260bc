"""Runs on one machine, with which runs on a cluster are compared. Many tests compare with the same
run, so its digests are kept from one test to the next."""

import fcntl
import hashlib
import json
import os
import pathlib

from program import CAMBRIAN

FOLDER = os.environ.get("CAMBRIAN_KEPT_RUNS")
LEAST = 6  # generations, since most tests need two to six


def digests_of_run(settings, count, compute):
    """Returns the digests of the first generations of the run with some settings, as this very
    program computes it. `compute` returns those of so many generations, and is called unless so
    many are kept. Without a folder nothing is kept."""
    if FOLDER is None:
        return compute(count)
    folder = pathlib.Path(FOLDER)
    folder.mkdir(parents=True, exist_ok=True)
    program = pathlib.Path(CAMBRIAN).read_bytes()
    path = folder / f"{hashlib.sha256(program + settings.encode()).hexdigest()}.json"
    with open(path.with_suffix(".lock"), "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # a test that needs the same run waits for it
        kept = json.loads(path.read_text()) if path.exists() else []
        if len(kept) < count:
            kept = compute(max(count, LEAST))
            complete = path.with_suffix(".new")
            complete.write_text(json.dumps(kept))
            complete.replace(path)
        return kept[:count]
