"""What tests look up in experiment files, past the program."""

import contextlib
import sqlite3


def opened(path):
    return contextlib.closing(sqlite3.connect(path, isolation_level=None))


def digests(path):
    """Of the populations, one a generation."""
    with opened(path) as database:
        return [row[0] for row in database.execute(
            "SELECT population_digest FROM generations ORDER BY generation")]
