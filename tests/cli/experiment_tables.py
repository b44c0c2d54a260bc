"""Reads experiment files without the program, for tests."""

import contextlib
import sqlite3


def opened(path):
    return contextlib.closing(sqlite3.connect(path, isolation_level=None))


def digests(path):
    """Returns the digest of each generation's population."""
    with opened(path) as database:
        return [row[0] for row in database.execute(
            "SELECT population_digest FROM generations ORDER BY generation")]
