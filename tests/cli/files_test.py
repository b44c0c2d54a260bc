"""Paths: commands that read and write the same file, special files and folders, and leftover
files."""

import ctypes
import json
import os
import shutil
import signal
import socket
import sqlite3
import stat
import struct
import subprocess
import unittest

from experiment_tables import digests, opened
from program import BAD_INPUT, CAMBRIAN, FAILED, NOBODY, SMALL, ProgramTest


def gone_process():
    """Returns the id of a process that has ended."""
    process = subprocess.Popen(["true"])
    process.wait()
    return process.pid


class FolderWatch:
    """Records the names of all files created in a folder, including those that were deleted
    again."""

    CREATED, MOVED_TO = 0x100, 0x80

    def __init__(self, folder):
        self.names = []
        libc = ctypes.CDLL(None, use_errno=True)
        self.watch = libc.inotify_init1(os.O_NONBLOCK | os.O_CLOEXEC)
        libc.inotify_add_watch(self.watch, str(folder).encode(), self.CREATED | self.MOVED_TO)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        events = b""
        while True:
            try:
                events += os.read(self.watch, 65536)
            except BlockingIOError:
                break
        while events:
            size = struct.unpack_from("iIII", events)[3]
            self.names.append(events[16:16 + size].rstrip(b"\0").decode())
            events = events[16 + size:]
        os.close(self.watch)


class Files(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("small.toml", SMALL)

    def evolve(self, *arguments):
        return self.run_well("evolve", "small.toml", "-n", 2, *arguments)

    def contents(self):
        return {path.name: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}

    def begun(self, *arguments):
        """Returns a process that has written its first line."""
        process = self.start(*arguments, stderr=subprocess.DEVNULL)
        process.stdout.readline()
        return process

    # -- output to an input or to a file in use

    def test_no_command_writes_onto_what_it_reads(self):
        self.evolve("-o", "run.cambrian")
        self.run_well("export", "run.cambrian", "--champion", "-o", "best.creature.json")
        os.link(self.folder / "run.cambrian", self.folder / "hard")
        os.link(self.folder / "small.toml", self.folder / "hard.toml")
        (self.folder / "soft").symlink_to("best.creature.json")
        (self.folder / "sub").mkdir()
        shutil.copy(self.folder / "small.toml", self.folder / "sub/walking.toml")
        before = self.contents()
        for arguments in [
                ["export", "run.cambrian", "--stats", "-o", "hard"],
                ["evolve", "small.toml", "-o", "small.toml"],
                ["evolve", "small.toml", "-o", "hard.toml"],
                ["evolve", "small.toml", "-o", "./sub/../small.toml"],
                ["evolve", "small.toml", "-f", "best.creature.json", "-o", "soft"],
                ["evolve", "-r", "run.cambrian", "-n", "4", "-o", "run.cambrian"],
                ["simulate", "best.creature.json", "--trace", "best.creature.json"],
                ["simulate", "best.creature.json", "--trace", "soft"],
                ["simulate", "best.creature.json", "-e", "small.toml", "--trace", "small.toml"],
                ["rescore", "best.creature.json", "-o", "soft"],
                ["settings", "small.toml", "-o", "small.toml"],
                ["settings", "sub/walking.toml", "-o", "sub"]]:
            self.assert_refused(self.run_program(*arguments), "read by the same command")
            self.assertEqual(self.contents(), before, arguments)
        with open(self.folder / "run.cambrian", "ab") as behind:
            result = subprocess.run([CAMBRIAN, "export", "run.cambrian", "--stats"],
                                    cwd=self.folder, stdout=behind, stderr=subprocess.PIPE,
                                    encoding="utf-8", check=False)
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("standard output: it leads to run.cambrian", result.stderr)
        self.assertEqual(self.contents(), before)

    def test_a_name_must_fit_what_a_command_writes(self):
        self.evolve("-o", "run.cambrian")
        self.run_well("export", "run.cambrian", "--champion", "-o", "best.creature.json")
        before = self.contents()
        for arguments, endings in [
                (["export", "run.cambrian", "--champion", "-o", "small.toml"], ".creature.json or .json"),
                (["export", "run.cambrian", "-g", "0", "-o", "a.card.png"], ".creature.json or .json"),
                (["export", "run.cambrian", "--stats", "-o", "stats"], ".csv"),
                (["export", "run.cambrian", "--stats", "-o", "best.creature.json"], ".csv"),
                (["export", "run.cambrian", "--settings", "-o", "settings.json"], ".toml"),
                (["simulate", "best.creature.json", "--trace", "small.toml"], ".csv"),
                (["rescore", "best.creature.json", "-o", "small.toml"], ".creature.json or .json"),
                (["settings", "-o", "best.creature.json"], ".toml"),
                *((command, ending) for command, ending in [
                    (["render", "best.creature.json", "-o", "small.toml"],
                     ".png, .mp4, .gif, .apng or .html"),
                    (["view", "best.creature.json", "--screenshot", "small.toml"], ".png"),
                    (["view", "best.creature.json", "--frame-log", "small.toml"], ".csv")]
                  if self.possible([command]))]:
            result = self.run_program(*arguments)
            self.assert_refused(result, f"cannot write {arguments[-1]}: it will be a",
                                f"expected a name that ends in {endings}\n")
            self.assertEqual(self.contents(), before, arguments)

    def test_a_folder_is_not_named_like_a_file_by_mistake(self):
        for name in ["a.toml", "report.md", "run.cambrian"]:
            self.assert_refused(self.run_program("compare", "small.toml", "--out", name),
                                f"cannot write {name}: it will be a folder; {name}/ makes one")
        self.assertEqual(self.files(), ["small.toml"])

    def test_nothing_but_an_experiment_is_written_as_one(self):
        self.evolve("-o", "run.cambrian")
        before = self.contents()
        for name in ["run.cambrian", "new.cambrian", "run.cambrian-wal", "run.cambrian-shm",
                     "run.cambrian-journal"]:
            for arguments in [["export", "run.cambrian", "--stats"], ["settings"]]:
                self.assert_refused(self.run_program(*arguments, "-o", name),
                                    "cannot write " + name)
        self.assertEqual(self.contents(), before)

    def test_a_running_experiment_is_not_replaced(self):
        self.evolve("-o", "other.cambrian")
        self.begun("evolve", "small.toml", "-n", "100000", "-o", "run.cambrian")
        os.link(self.folder / "run.cambrian", self.folder / "hard")
        (self.folder / "soft").symlink_to("run.cambrian")
        inode = (self.folder / "run.cambrian").stat().st_ino
        for arguments in [["export", "other.cambrian", "--stats", "-o", "hard"],
                          ["export", "other.cambrian", "--stats", "-o", "soft"],
                          ["settings", "-o", "hard"]]:
            self.assert_refused(self.run_program(*arguments), "open in another window or program")
        self.assert_refused(self.run_program("export", "other.cambrian", "--stats", "-o",
                                             "run.cambrian"), "run.cambrian")
        self.assertEqual((self.folder / "run.cambrian").stat().st_ino, inode)

    # -- --resume A -o B

    def test_resumed_into_another_file_the_first_stays_as_it_is(self):
        self.evolve("-o", "a.cambrian")
        before = (self.folder / "a.cambrian").read_bytes()
        report = self.run_well("evolve", "-r", "a.cambrian", "-n", 4, "-o", "b.cambrian", "--json")
        self.assertEqual(json.loads(report.stdout.splitlines()[-1])["experiment"], "b.cambrian")
        self.assertEqual((self.folder / "a.cambrian").read_bytes(), before)
        self.run_well("evolve", "small.toml", "-n", 4, "-o", "uncut.cambrian")
        self.assertEqual(digests(self.folder / "b.cambrian"),
                         digests(self.folder / "uncut.cambrian"))
        self.assertEqual(digests(self.folder / "a.cambrian"),
                         digests(self.folder / "b.cambrian")[:2])
        self.run_well("verify", "b.cambrian")
        for arguments, words in [(["-n", 6, "-o", "b.cambrian"], "File exists"),
                                 (["-n", 2, "-o", "c.cambrian"], "--generations N"),
                                 (["-n", 6, "-o", "no/c.cambrian"], "No such file")]:
            self.assert_refused(self.run_program("evolve", "-r", "a.cambrian", *arguments), words)
        self.assertEqual(self.files(), ["a.cambrian", "b.cambrian", "small.toml",
                                        "uncut.cambrian"])

    def test_a_running_experiment_can_be_gone_on_with_in_another_file(self):
        self.begun("evolve", "small.toml", "-n", "100000", "-o", "a.cambrian")
        process = self.begun("evolve", "-r", "a.cambrian", "-n", "200000", "-o", "b.cambrian")
        process.kill()
        process.wait()
        count = len(digests(self.folder / "b.cambrian"))
        self.assertGreater(count, 0)
        self.assertEqual(digests(self.folder / "b.cambrian"),
                         digests(self.folder / "a.cambrian")[:count])

    # -- without write permission

    def read_all(self, names):
        """What others read of each file; leaves nothing and changes nothing."""
        self.run_well("export", "run.cambrian", "--champion", "-o", "best.creature.json")
        expected = {option: self.run_well("export", "run.cambrian", option).stdout
                    for option in ["--stats", "--settings", "--champion"]}
        self.forbid_writing()
        before = self.files()
        for name in names:
            for option, text in expected.items():
                result = self.as_nobody("export", name, option)
                self.assertEqual((result.returncode, result.stderr), (0, ""), (name, option))
                self.assertEqual(result.stdout, text, (name, option))
            self.assertEqual(self.as_nobody("verify", name).returncode, 0, name)
            self.assertEqual(self.files(), before, name)
        self.assertEqual(self.as_nobody("verify", "best.creature.json").returncode, 0)
        self.assertEqual(self.files(), before)

    def test_an_experiment_is_read_where_nothing_can_be_written(self):
        self.evolve("-o", "run.cambrian")
        self.read_all(["run.cambrian"])

    def test_a_crashed_experiment_is_read_where_nothing_can_be_written(self):
        """With and without the file that SQLite's readers share, and through a link."""
        process = self.begun("evolve", "small.toml", "-n", "100000", "-o", "run.cambrian")
        process.stdout.readline()
        process.kill()
        process.wait()
        (self.folder / "moved").mkdir()
        self.assertGreater((self.folder / "run.cambrian-wal").stat().st_size, 0)
        for ending in ["", "-wal"]:
            shutil.copy(self.folder / f"run.cambrian{ending}",
                        self.folder / f"moved/run.cambrian{ending}")
        (self.folder / "link.cambrian").symlink_to("moved/run.cambrian")
        (self.folder / "moved").chmod(0o555)
        self.read_all(["run.cambrian", "moved/run.cambrian", "link.cambrian"])
        self.assertEqual(sorted(os.listdir(self.folder / "moved")),
                         ["run.cambrian", "run.cambrian-wal"])

    def test_reading_leaves_nothing_where_it_could_write(self):
        self.evolve("-o", "run.cambrian")
        before = self.contents()
        for arguments in [["export", "run.cambrian", "--stats"], ["verify", "run.cambrian"],
                          ["export", "run.cambrian", "--champion"]]:
            self.run_well(*arguments)
            self.assertEqual(self.contents(), before, arguments)

    # -- paths that are not regular files

    def test_fifos_sockets_folders_and_devices_are_no_experiments(self):
        os.mkfifo(self.folder / "pipe.cambrian")
        listener = socket.socket(socket.AF_UNIX)
        self.addCleanup(listener.close)
        listener.bind(str(self.folder / "socket.cambrian"))
        (self.folder / "folder.cambrian").mkdir()
        (self.folder / "zero.cambrian").symlink_to("/dev/zero")
        (self.folder / "null.cambrian").symlink_to("/dev/null")
        for name in ["pipe", "socket", "folder", "zero", "null"]:
            for arguments in [["export", f"{name}.cambrian", "--stats"],
                              ["verify", f"{name}.cambrian"],
                              ["evolve", "-r", f"{name}.cambrian"],
                              ["evolve", "-r", f"{name}.cambrian", "-n", 9, "-o", "b.cambrian"]]:
                result = self.run_program(*arguments)
                self.assert_refused(result, f"{name}.cambrian")
                self.assertEqual(result.stderr.count("\n"), 1)
            self.assert_refused(self.run_program("evolve", "small.toml", "-o",
                                                 f"{name}.cambrian"), f"{name}.cambrian")
        self.assertTrue(stat.S_ISFIFO((self.folder / "pipe.cambrian").stat().st_mode))

    def test_names_that_sqlite_takes_for_something_else_are_names(self):
        for name in ["file:run.cambrian", ":memory:.cambrian", "file:a?mode=memory#%41.cambrian",
                     "a?b#c%41.cambrian"]:
            self.evolve("-o", name)
            self.assertIn(name, self.files())
            self.run_well("export", name, "--stats")
            self.run_well("evolve", "-r", name, "-n", 3)
            self.assertEqual(len(digests(self.folder / name)), 3)
        self.assertEqual(len(self.files()), 5)

    # -- leftover files

    def test_what_a_killed_program_left_is_taken_away(self):
        stale = f".cambrian-{gone_process()}-"
        for name in ["1", "1-journal", "2"]:
            self.write(stale + name, "half")
        self.write(".cambrian-1-1", "another's, at work")
        self.run_well("settings", "-o", "all.toml")
        self.assertEqual(self.files(), [".cambrian-1-1", "all.toml", "small.toml"])

    def test_an_experiment_is_complete_from_the_moment_it_is_there(self):
        """At no time is there a rollback journal that would remain after a kill."""
        with FolderWatch(self.folder) as watch:
            self.evolve("-o", "run.cambrian")
        self.assertIn("run.cambrian", watch.names)
        self.assertNotIn("run.cambrian-journal", watch.names)

    def test_a_broken_off_change_is_undone_for_readers(self):
        """The rollback journal is that of an older program, killed before it set up its log."""
        self.evolve("-o", "run.cambrian")
        stats = self.run_well("export", "run.cambrian", "--stats").stdout
        path = self.folder / "run.cambrian"
        with opened(path) as database:
            database.execute("PRAGMA journal_mode = DELETE")
        database = sqlite3.connect(path, isolation_level=None)
        self.addCleanup(database.close)
        database.execute("PRAGMA cache_size = 2")
        database.execute("BEGIN IMMEDIATE")
        database.execute("UPDATE generations SET best = best + 1000")
        database.execute("UPDATE individuals SET method = method || printf('%.20000c', 'x')")
        (self.folder / "killed").mkdir()
        for ending in ["", "-journal"]:
            shutil.copy(f"{path}{ending}", self.folder / f"killed/run.cambrian{ending}")
        database.execute("ROLLBACK")
        killed = self.folder / "killed"
        self.assertNotEqual((killed / "run.cambrian").read_bytes(), path.read_bytes())
        before = {each.name: each.read_bytes() for each in killed.iterdir()}
        self.assertEqual(self.run_well("export", "killed/run.cambrian", "--stats").stdout, stats)
        self.run_well("verify", "killed/run.cambrian")
        self.assertEqual({each.name: each.read_bytes() for each in killed.iterdir()}, before)
        self.run_well("evolve", "-r", "killed/run.cambrian", "-n", 3)
        self.assertEqual(os.listdir(killed), ["run.cambrian"])

    def test_an_experiment_that_cannot_begin_leaves_no_file(self):
        disk = self.small_disk("64k")
        self.assert_refused(self.run_program("evolve", "small.toml", "-o", "disk/a.cambrian"),
                            "disk/a.cambrian")
        self.assertEqual(list(disk.iterdir()), [])

    # -- messages, statuses, permissions

    def test_a_path_that_does_not_exist_is_status_2(self):
        self.evolve("-o", "run.cambrian")
        self.run_well("export", "run.cambrian", "--champion", "-o", "best.creature.json")
        for arguments in self.possible([
                ["studio", "none.toml"], ["studio", "--frame-log", "none/x"],
                ["studio", "--status-log", "none/x"], ["studio", "--screenshot", "none/x.png"],
                ["studio", "--if-no-display", "none.toml"], ["view", "none.creature.json"],
                ["evolve", "none.toml"], ["evolve", "-r", "none.cambrian"],
                ["evolve", "small.toml", "-f", "none.creature.json"],
                ["evolve", "small.toml", "-o", "none/x.creature.json"],
                ["evolve", "small.toml", "-o", "none/x.cambrian"],
                ["simulate", "none.creature.json"],
                ["simulate", "best.creature.json", "-e", "none.toml"],
                ["simulate", "best.creature.json", "--trace", "none/x.csv"],
                ["render", "none.creature.json", "-o", "x.png"],
                ["render", "best.creature.json", "-o", "none/x.png"],
                ["render", "best.creature.json", "-e", "none.toml", "-o", "x.png"],
                ["verify", "none.creature.json"], ["verify", "none.cambrian"],
                ["rescore", "none.creature.json"],
                ["rescore", "best.creature.json", "-o", "none/x.creature.json"],
                ["settings", "none.toml"], ["settings", "-o", "none/x.toml"],
                ["export", "none.cambrian", "--stats"],
                ["export", "run.cambrian", "--stats", "-o", "none/x.csv"],
                ["export", "run.cambrian", "--champion", "-o", "none/x.creature.json"]]):
            result = self.run_program(*arguments, env={"DISPLAY": "", "WAYLAND_DISPLAY": ""})
            self.assert_refused(result, "none", "No such file")
            self.assertEqual(result.stderr.count("\n"), 1, (arguments, result.stderr))

    def test_numbers_are_shown_as_they_were_typed(self):
        self.run_well("evolve", "small.toml", "-n", 1, "-o", "best.creature.json")
        for arguments, words in [
                (["evolve", "small.toml", "--seed", "-1"], "--seed: -1 is outside [0, 1e+15]"),
                (["evolve", "small.toml", "--seed", "1e16"], "--seed: 1e16 is outside"),
                (["evolve", "small.toml", "--seed", "1.5"], "whole number, found 1.5"),
                (["evolve", "small.toml", "--seed", "x"], "--seed: 'x' is not a number"),
                (["evolve", "small.toml", "--seed", "99999999999999999999"],
                 "--seed: 99999999999999999999 is outside"),
                (["evolve", "small.toml", "-n", "0"], "--generations: 0 is outside [1, 1000000]"),
                (["evolve", "small.toml", "-t", "inf"], "--threads: inf is not finite"),
                (["simulate", "best.creature.json", "--seconds", "inf"],
                 "--seconds: inf is not finite"),
                (["simulate", "best.creature.json", "--seconds", "nan"],
                 "--seconds: nan is not finite"),
                (["simulate", "best.creature.json", "--seconds", "1e999"],
                 "--seconds: 1e999 is not finite"),
                (["simulate", "best.creature.json", "--seconds", "-3"], "-3 is outside [0, 10000]"),
                (["export", "x.cambrian", "-g", "-1"], "--generation: -1 is outside")]:
            result = self.run_program(*arguments)
            self.assert_refused(result, words)
            self.assertEqual(result.stderr.count("\n"), 1)
        for arguments in self.possible([["studio", "--scale", "nan"],
                                        ["render", "x", "-o", "a.mp4", "--speed", "nan"]]):
            self.assert_refused(self.run_program(*arguments), ": nan is not finite")

    def test_a_number_is_read_as_the_help_writes_it(self):
        self.assertIn("1e+15", self.run_well("evolve", "--help").stdout)
        self.write("far.toml", SMALL.replace("[run]\n", "[run]\nseed = 1e+15\n"))
        self.run_well("evolve", "far.toml", "-n", 1, "-o", "a.cambrian")
        self.run_well("evolve", "small.toml", "-n", 1, "-s", "1e+15", "-o", "b.cambrian")
        self.run_well("evolve", "small.toml", "-n", 1, "-s", 10**15, "-o", "c.cambrian")
        names = ["a.cambrian", "b.cambrian", "c.cambrian"]
        self.assertEqual(len({tuple(digests(self.folder / name)) for name in names}), 1)

    def test_every_message_begins_with_the_programs_name(self):
        for arguments in self.possible([
                          ["fly"], ["evolve"], ["evolve", "--speed", "3", "small.toml"],
                          ["evolve", "small.toml", "-n"], ["simulate"], ["verify"], ["render"],
                          ["export"], ["completion", "tcsh"], ["evolve", "small.toml", "extra"],
                          ["evolve", "small.toml", "-r", "x.cambrian"], ["render", "x", "--size", "1x1"]]):
            result = self.run_program(*arguments)
            self.assert_refused(result, "cambrian: ")
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)

    def test_an_empty_value_is_an_error(self):
        self.run_well("evolve", "small.toml", "-n", 1, "-o", "best.creature.json")
        for arguments in self.possible([
                          ["simulate", "best.creature.json", "-e", ""],
                          ["simulate", "best.creature.json", "--trace", ""],
                          ["simulate", "best.creature.json", "--integrator", ""],
                          ["simulate", ""], ["verify", ""], ["settings", ""],
                          ["settings", "--goal", ""], ["settings", "-o", ""],
                          ["evolve", ""], ["evolve", "small.toml", "-o", ""],
                          ["evolve", "small.toml", "-f", ""], ["evolve", "-r", ""],
                          ["studio", ""], ["studio", "--frame-log", ""],
                          ["studio", "--if-no-display", ""], ["export", "", "--stats"]]):
            result = self.run_program(*arguments, env={"DISPLAY": "", "WAYLAND_DISPLAY": ""})
            self.assert_refused(result, "")
            self.assertEqual(result.stderr.count("\n"), 1, (arguments, result.stderr))
        self.assertEqual(self.files(), ["best.creature.json", "small.toml"])

    def test_files_replaced_keep_their_mode(self):
        path = self.write("all.toml", "old")
        for mode in [0o600, 0o640, 0o755]:
            path.chmod(mode)
            self.run_well("settings", "-o", "all.toml")
            self.assertEqual(stat.S_IMODE(path.stat().st_mode), mode)
        if os.geteuid() == 0:
            os.chown(path, NOBODY, NOBODY)
            self.run_well("settings", "-o", "all.toml")
            self.assertEqual((path.stat().st_uid, path.stat().st_gid), (NOBODY, NOBODY))

    def test_a_second_run_into_a_folder_keeps_the_first(self):
        for extra in [["-o", "runs/"], ["-o", "runs"], ["-o", "runs/"]]:
            self.evolve(*extra)
        names = ["champion-walking-seed1-2.creature.json", "champion-walking-seed1-3.creature.json",
                 "champion-walking-seed1.creature.json", "walking-seed1-2.cambrian",
                 "walking-seed1-3.cambrian", "walking-seed1.cambrian"]
        self.assertEqual(sorted(os.listdir(self.folder / "runs")), names)
        (self.folder / "runs/walking-seed1.cambrian").unlink()
        self.evolve("-o", "runs/")
        self.assertIn("champion-walking-seed1-4.creature.json", os.listdir(self.folder / "runs"))

    def limited(self, limit, *arguments):
        return subprocess.run(["bash", "-c", f'ulimit {limit}; exec "$@"', "bash", CAMBRIAN,
                               *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8",
                              check=False)

    def test_a_small_stack_is_told(self):
        for limit in ["-s 128", "-s 256"]:
            result = self.limited(limit, "evolve", "small.toml", "-n", "1")
            self.assert_refused(result, "stack", "ulimit -s", status=FAILED)
        self.assertEqual(self.limited("-S -s 128", "evolve", "small.toml", "-n", "1").returncode,
                         0)

    def test_a_limit_of_file_sizes_is_told(self):
        self.evolve("-o", "run.cambrian")
        for arguments in [["evolve", "small.toml", "-o", "new.cambrian"],
                          ["settings", "-o", "all.toml"],
                          ["evolve", "-r", "run.cambrian", "-n", 9]]:
            result = self.limited("-f 4", *arguments)
            self.assertIn(result.returncode, [FAILED, BAD_INPUT], arguments)
            self.assertTrue(result.stderr.startswith("cambrian: "), (arguments, result.stderr))
            self.assertNotIn(-signal.SIGXFSZ, [result.returncode])
        self.assertNotIn("all.toml", self.files())
        self.assertFalse([name for name in self.files() if name.startswith(".cambrian-")])
        self.assertEqual(len(digests(self.folder / "run.cambrian")), 2)


if __name__ == "__main__":
    unittest.main()
