"""Files of strangers, and what lies beside them, can do no more than be refused: they delete, crash
and fill nothing, and their texts do not steer the terminal."""

import contextlib
import os
import re
import shutil
import signal
import sqlite3
import struct
import unittest

from program import BAD_INPUT, DONE, SMALL, ProgramTest

JOURNAL_MARK = bytes.fromhex("d9d505f920a163d7")
TINY = SMALL.replace("generations = 3", "generations = 1")
TINY_POND = "[preserve]\nwidth = 8\nheight = 8\nfounders = 2\nrestock = 0\nmax-population = 4\n"
DOTTED = "a" + ".a" * 100_000 + " = 1\n"
STEERING = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069]")


def write_hot_journal(database, victim):
    """Writes a rollback journal that has to be played back and names a super-journal."""
    begin = database.read_bytes()[:100]
    page = struct.unpack(">H", begin[16:18])[0] or 65536
    pages = database.stat().st_size // page
    name = str(victim).encode()
    check = sum(byte if byte < 128 else byte - 256 for byte in name) & 0xffffffff
    head = JOURNAL_MARK + struct.pack(">IIIII", 0, 0, pages, 512, page)
    database.with_name(database.name + "-journal").write_bytes(
        head.ljust(512, b"\0") + struct.pack(">I", 0x40000000 // page + 1) + name
        + struct.pack(">II", len(name), check) + JOURNAL_MARK)


class Strangers(ProgramTest):
    def experiment(self, name="run.cambrian"):
        self.write("tiny.toml", TINY)
        self.run_well("evolve", "tiny.toml", "-o", name)
        return self.folder / name

    def preserve(self, name="world.cambrian"):
        self.write("pond.toml", TINY_POND)
        self.run_well("preserve", "pond.toml", "--seconds", 1, "-o", name)
        return self.folder / name

    @contextlib.contextmanager
    def changed(self, path):
        database = sqlite3.connect(path, isolation_level=None)
        with contextlib.closing(database):
            yield database
            database.execute("PRAGMA wal_checkpoint(TRUNCATE)")

    def assert_harmless(self, result):
        self.assertIsNone(STEERING.search(result.stdout), repr(result.stdout[:300]))
        self.assertIsNone(STEERING.search(result.stderr), repr(result.stderr[:300]))

    def temporary(self, name="temporary"):
        folder = self.folder / name
        folder.mkdir(exist_ok=True)
        return folder

    # -- what lies beside a database

    def test_reading_a_database_deletes_no_other_file(self):
        victim = self.write("thesis.pdf", "precious")
        for path, commands in [
                (self.experiment(), [["export", "--stats"], ["verify"], ["rescore"],
                                     ["evolve", "-n", 2, "--resume"]]),
                (self.preserve(), [["export", "--series"], ["verify"],
                                   ["preserve", "--seconds", 2, "--resume"]])]:
            write_hot_journal(path, victim)
            before = {each.name: each.read_bytes() for each in self.folder.iterdir()}
            for command in commands:
                result = self.run_program(*command, path.name)
                self.assert_refused(result, path.name, "its rollback journal names", "thesis.pdf",
                                    f"remove {path.name}-journal if you do not know")
            (self.folder / "link.cambrian").symlink_to(path)
            self.assert_refused(self.run_program(*commands[0], "link.cambrian"), "thesis.pdf")
            (self.folder / "link.cambrian").unlink()
            after = {each.name: each.read_bytes() for each in self.folder.iterdir()}
            self.assertEqual(after, before)

    def test_a_log_of_any_size_is_not_copied(self):
        path = self.experiment()
        temporary = self.temporary()
        for ending in ["-wal", "-journal"]:
            log = path.with_name(path.name + ending)
            with open(log, "wb") as file:
                file.truncate(3_000_000_000)
            self.assert_refused(
                self.run_program("export", path.name, "--stats", env={"TMPDIR": str(temporary)}),
                f"{log.name} beside it has 3000 MB, at most 512 MB are read")
            log.unlink()
        self.assertEqual(list(temporary.iterdir()), [])

    # -- the temporary folder

    def crashed(self):
        """Returns an experiment with the log of a killed program."""
        path = self.experiment()
        database = sqlite3.connect(path, isolation_level=None)
        database.execute("INSERT INTO facts VALUES ('noted', 'later')")
        for ending in ["", "-wal"]:
            shutil.copy(f"{path}{ending}", self.folder / f"crashed.cambrian{ending}")
        database.close()
        self.assertGreater((self.folder / "crashed.cambrian-wal").stat().st_size, 0)
        return "crashed.cambrian"

    def test_a_temporary_folder_that_cannot_be_used_is_named(self):
        name = self.crashed()
        read = self.run_well("export", name, "--stats", env={"TMPDIR": str(self.temporary())})
        self.assertEqual(read.stdout, self.run_well("export", "run.cambrian", "--stats").stdout)
        self.assertEqual(list(self.temporary().iterdir()), [])
        for folder, reason in [(self.folder / "none", "No such file or directory"),
                               (self.small_disk("40k", "full"), "No space left on device")]:
            result = self.run_program("export", name, "--stats", env={"TMPDIR": str(folder)})
            self.assert_refused(result, name, f"the temporary folder {folder}: {reason}")
        self.assertEqual(list((self.folder / "full").iterdir()), [])

    def test_copies_of_a_killed_reader_are_removed_by_the_next(self):
        name = self.crashed()
        for ending in ["", "-wal"]:
            shutil.copy(self.folder / (name + ending), self.folder / f"small.cambrian{ending}")
        with open(self.folder / name, "ab") as file:
            file.truncate(300_000_000)  # takes long to copy
        temporary = self.temporary()
        environment = dict(os.environ, TMPDIR=str(temporary))
        process = self.start("export", name, "--stats", env=environment)
        while process.poll() is None and not list(temporary.glob("*/copy")):
            pass
        process.send_signal(signal.SIGKILL)
        process.wait()
        if not list(temporary.iterdir()):
            self.skipTest("it was read before it could be killed")
        self.run_well("export", "small.cambrian", "--stats", env={"TMPDIR": str(temporary)})
        self.assertEqual(list(temporary.iterdir()), [])

    # -- nesting and sizes

    def test_nested_names_crash_nothing(self):
        refused = "nested deeper than 32 levels"
        self.write("dotted.toml", DOTTED)
        self.assert_refused(self.run_program("evolve", "dotted.toml"), "dotted.toml: line 1", refused)
        self.assert_refused(self.run_program("preserve", "dotted.toml"), refused)
        self.assert_refused(self.run_program("settings", "dotted.toml"), refused)
        path = self.preserve()
        with self.changed(path) as database:
            database.execute("UPDATE facts SET value = ? WHERE name = 'settings'", [DOTTED])
        for command in [["verify"], ["export", "--series"], ["preserve", "--resume"]]:
            result = self.run_program(*command, path.name)
            if result.returncode != DONE:  # the series needs no settings
                self.assert_refused(result, path.name, refused)
        path = self.experiment()
        with self.changed(path) as database:
            database.execute("UPDATE settings SET toml = ?", [DOTTED[:99_000] + " = 1\n"])
        for command in [["verify"], ["export", "--settings"], ["evolve", "-n", 2, "--resume"]]:
            self.assert_refused(self.run_program(*command, path.name), path.name, refused)

    def test_every_text_of_a_file_has_a_bound(self):
        for path, table, column in [(self.preserve(), "lives", "cause"),
                                    (self.experiment(), "individuals", "method")]:
            with self.changed(path) as database:
                database.execute(f"UPDATE {table} SET {column} = printf('%.*c', 4000000, 'x')")
            option = "--lives" if table == "lives" else "--champion"
            self.assert_refused(self.run_program("export", path.name, option), path.name,
                                f'column "{column}": a text of 4000000 bytes; expected at most 1000')

    # -- memory

    def test_a_world_too_large_for_memory_is_refused_before_it_begins(self):
        self.write("huge.toml", "[preserve]\nwidth = 1000\nheight = 1000\nenergy-density = 1000\n"
                                "plant-energy = 0.1\n")
        self.assert_refused(self.run_program("preserve", "huge.toml", "--seconds", 1),
                            "huge.toml: [preserve] width, height: 1000 m by 1000 m with up to "
                            "1e+10 plants need about 1.5e+03 GB of memory, at most 0.7 GB")
        self.assertLess(self.memory_of("preserve", "huge.toml", status=BAD_INPUT), 64e6)
        path = self.preserve()
        with self.changed(path) as database:
            database.execute("UPDATE facts SET value = ? WHERE name = 'settings'",
                             [(self.folder / "huge.toml").read_text()])
        for command in [["verify"], ["preserve", "--resume"]]:
            self.assert_refused(self.run_program(*command, path.name), "1e+10 plants need about")
        self.write("wide.toml", "[preserve]\nwidth = 600\nheight = 600\nfounders = 1\n")
        self.run_well("preserve", "wide.toml", "--seconds", 0.1, "-o", "wide.cambrian")
        self.assert_refused(self.run_program("preserve", "--resume", "wide.cambrian", "--law",
                                             "preserve.plant-energy=0.1"), "plants need about")

    # -- texts

    def test_texts_of_files_do_not_steer_the_terminal(self):
        steering = "\x1b]0;owned\x07\x1b[2J\u009b31mRED\u202eDER\r"
        self.write("goal.toml", f'[goal]\nbehavior = "{steering[16:]}"\n'.replace("\r", ""))
        self.assert_harmless(self.run_program("evolve", "goal.toml"))
        for change in [
                "UPDATE individuals SET outcome = ?", "UPDATE individuals SET method = ?",
                "UPDATE simulators SET version = ?", "UPDATE journal SET command = ?",
                "UPDATE settings SET toml = ? || '= 1'", "UPDATE results SET verdict = ?",
                "UPDATE individuals SET mutations = ?"]:
            path = self.experiment("run.cambrian")
            with self.changed(path) as database:
                database.execute(change, [steering])
            for command in [["verify"], ["export", "--champion"], ["export", "--stats"],
                            ["evolve", "-n", 2, "--resume"], ["rescore"]]:
                result = self.run_program(*command, path.name)
                self.assert_harmless(result)
            path.unlink()
        path = self.experiment()
        with self.changed(path) as database:
            database.execute("PRAGMA writable_schema = ON")
            database.execute("UPDATE sqlite_schema SET name = ?, tbl_name = ? WHERE name = 'kept'",
                             [steering, steering])
        self.assert_harmless(self.run_program("verify", path.name))
        for change in ["UPDATE facts SET value = ? WHERE name = 'simulator'",
                       "UPDATE facts SET value = ? WHERE name = 'settings'",
                       "UPDATE lives SET method = ?", "UPDATE lives SET cause = ?"]:
            path = self.preserve("world.cambrian")
            with self.changed(path) as database:
                database.execute(change, [steering])
            for command in [["verify"], ["export", "--lives"],
                            ["preserve", "--seconds", 2, "--resume"]]:
                self.assert_harmless(self.run_program(*command, path.name))
            path.unlink()

    def test_names_of_creatures_and_files_do_not_steer_the_terminal(self):
        champion = self.evolve_champion("a.creature.json", TINY)
        name = "\x1b]0;owned\u009b31m\u202e.creature.json"
        text = champion.read_text()
        self.write(name, text.replace('"simulator": "', '"simulator": "\\u001b[31m\\u009b\\u202e'))
        for command in ["simulate", "verify", "rescore"]:
            self.assert_harmless(self.run_program(command, name))

    def test_cells_of_csv_are_no_formulas(self):
        path = self.preserve()
        with self.changed(path) as database:
            database.execute("UPDATE lives SET method = '=HYPERLINK(\"x\",\"y\")'")
        lives = self.run_well("export", path.name, "--lives").stdout.splitlines()
        self.assertIn(',"\'=HYPERLINK(""x"",""y"")",', lives[1])

    # -- disks that are nearly full

    def test_a_preserve_on_a_nearly_full_disk_is_complete_or_not_there(self):
        self.write("pond.toml", TINY_POND)
        self.run_well("preserve", "pond.toml", "--seconds", 1, "-o", "first.cambrian")
        size = (self.folder / "first.cambrian").stat().st_size
        disk = self.small_disk("4m")
        for room in range(40_000, 2 * size + 120_000, 16_384):
            self.remount(disk, f"size={room}")
            result = self.run_program("preserve", "pond.toml", "--seconds", 1, "-o", "disk/w.cambrian")
            left = [path.name for path in disk.iterdir()]
            self.remount(disk, "size=4m")
            if result.returncode == DONE:
                self.assertEqual(left, ["w.cambrian"])
            else:
                self.assertRegex(result.stderr, "the disk is full|No space left on device")
                self.assertLessEqual(set(left), {"w.cambrian", "w.cambrian-wal", "w.cambrian-shm"})
            if "w.cambrian" in left:
                self.run_well("export", "disk/w.cambrian", "--series")
                self.run_well("preserve", "--resume", "disk/w.cambrian", "--seconds", 2)
            for path in disk.iterdir():
                path.unlink()


if __name__ == "__main__":
    unittest.main()
