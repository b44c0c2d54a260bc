"""Runs the real program as a user would, for the tests of this folder."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CAMBRIAN = os.environ.get("CAMBRIAN", str(ROOT / "build/release/bin/cambrian"))

RANDOM_CREATURES = os.environ.get("RANDOM_CREATURES",
                                  str(ROOT / "build/release/bin/random_creatures"))
FAULTY_PROGRAM = os.environ.get("FAULTY_PROGRAM",
                                str(ROOT / "build/release/bin/faulty_program"))

DONE, FAILED, BAD_INPUT = 0, 1, 2
NOBODY = 65534  # id of a user without rights

# A short trial with few creatures, which takes seconds on one core with any build.
SMALL = """
[run]
generations = 3
[population]
size = 12
[trial]
duration = 2
"""
# A preserve in which a lineage soon has many members.
FERTILE = """
[preserve]
width = 12
height = 10
founders = 2
restock = 0
bodies = "ghostly"
energy-density = 1000
growth-time = 10
max-population = 60
[mutation]
rate = 0
[breeding]
asexual = 1
crossover = 0
grafting = 0
"""


class ProgramTest(unittest.TestCase):
    """Each test has its own empty folder, which is also the working directory."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="cambrian-cli-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def run_program(self, *arguments, **options):
        """Returns the finished process with its output as text. Fails after two minutes."""
        environment = dict(os.environ, **options.pop("env", {}))
        return subprocess.run(
            [CAMBRIAN, *map(str, arguments)], cwd=self.folder, env=environment,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            encoding="utf-8", timeout=600, check=False, **options)

    def start(self, *arguments, **options):
        """Starts the program with standard output and error as text; it ends with the test."""
        options.setdefault("stdin", subprocess.DEVNULL)
        options.setdefault("stdout", subprocess.PIPE)
        options.setdefault("stderr", subprocess.PIPE)
        process = subprocess.Popen([CAMBRIAN, *map(str, arguments)], cwd=self.folder,
                                   encoding="utf-8", **options)
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def wait_until_caught(process, number):
        """Waits until the program handles a signal instead of dying of it."""
        caught = 0
        while process.poll() is None and not caught >> (number - 1) & 1:
            time.sleep(0.01)
            status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
            caught = int(re.search(r"SigCgt:\s+([0-9a-f]+)", status)[1], 16)

    @staticmethod
    def end(process):
        if process.poll() is None:
            process.kill()
        process.wait(60)
        for stream in (process.stdout, process.stderr):
            if stream:
                stream.close()

    def memory_of(self, *arguments, status=DONE):
        """Returns the program's peak memory in bytes."""
        process = self.start(*arguments, stdout=subprocess.DEVNULL)
        messages = process.stderr.read()
        _, code, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(code)
        self.assertEqual(process.returncode, status, messages)
        return usage.ru_maxrss * 1024

    # -- as a user without rights

    def as_nobody(self, *arguments, **options):
        """Returns the finished process of a user without write permission in a protected folder."""
        return subprocess.run(
            [*self.nobody(), self.reachable_program(), *map(str, arguments)], cwd=self.folder,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            encoding="utf-8", timeout=600, check=False, **options)

    @staticmethod
    def nobody():
        """Returns the start of the command line that runs a program as such a user."""
        if os.geteuid() != 0:
            return []
        return ["setpriv", f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups"]

    def reachable_program(self):
        """Returns a copy of the program that every user may run."""
        copy = self.folder / "program"
        if not copy.exists():
            shutil.copy(CAMBRIAN, copy)
            copy.chmod(0o755)
        return copy

    def forbid_writing(self):
        """Makes the folder and its contents read-only."""
        self.reachable_program()
        self.folder.chmod(0o555)
        self.addCleanup(self.folder.chmod, 0o755)

    def possible(self, commands):
        """Returns the command lines (lists of words) that this build of the program supports."""
        window = "built without" not in self.run_program("view", "--help").stdout
        return [words for words in commands
                if window or str(words[0]) not in ("studio", "view", "render")]

    def run_well(self, *arguments, **options):
        result = self.run_program(*arguments, **options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return result

    def assert_refused(self, result, *parts, status=BAD_INPUT):
        """Checks for one message on standard error with these parts and no standard output."""
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        self.assertEqual(result.stdout, "")
        for part in parts:
            self.assertIn(part, result.stderr)
        self.assertTrue(result.stderr.startswith("cambrian: "), result.stderr)

    def small_disk(self, size, name="disk"):
        """Returns a folder on a separate disk of that size ("600k"); skips the test if that is
        impossible."""
        disk = self.folder / name
        disk.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(disk)],
                          stderr=subprocess.DEVNULL, check=False).returncode != 0:
            self.skipTest("a small disk cannot be mounted here")
        self.addCleanup(subprocess.run, ["umount", "--lazy", str(disk)], check=False)
        return disk

    @staticmethod
    def remount(disk, options):
        subprocess.run(["mount", "-o", f"remount,{options}", str(disk)], check=True)

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def evolve_champion(self, name="champion.creature.json", settings=SMALL):
        """Returns the champion's file of a small evolution."""
        self.write("small.toml", settings)
        self.run_well("evolve", "small.toml", "--out", name)
        return self.folder / name
