"""cambrian evolve: what it reports, what it keeps, and that it is the same every time."""

import json
import os
import pty
import signal
import subprocess
import unittest

from program import CAMBRIAN, DONE, FAILED, SMALL, ProgramTest


class Evolve(ProgramTest):
    def test_same_seed_same_bytes_on_1_2_and_7_threads(self):
        self.write("small.toml", SMALL)
        outputs, creatures = set(), set()
        for threads in [1, 2, 7]:
            result = self.run_well("evolve", "small.toml", "--seed", 7, "--threads", threads,
                                   "--out", "a.creature.json")
            outputs.add(result.stdout)
            creatures.add((self.folder / "a.creature.json").read_bytes())
        self.assertEqual(len(outputs), 1)
        self.assertEqual(len(creatures), 1)

    def test_another_seed_gives_another_creature(self):
        self.write("small.toml", SMALL)
        for seed in [1, 2]:
            self.run_well("evolve", "small.toml", "-s", seed, "-n", 1, "-o", f"{seed}.json")
        first, second = (json.loads((self.folder / f"{seed}.json").read_text()) for seed in [1, 2])
        self.assertNotEqual(first["nodes"], second["nodes"])
        self.assertEqual(first["scored"]["seed"], 1)

    def test_every_generation_is_one_line_and_the_best_never_falls(self):
        self.write("small.toml", SMALL)
        lines = self.run_well("evolve", "small.toml", "-n", 4).stdout.splitlines()
        self.assertEqual(len(lines), 6)
        for number, line in enumerate(lines[:4]):
            self.assertRegex(line, rf"^generation +{number}   best +[0-9.]+ BL/s   median")
        best = [float(line.split()[3]) for line in lines[:4]]
        self.assertEqual(best, sorted(best))
        self.assertIn("best of generation 0:", lines[4])
        self.assertIn("of generation 3:", lines[4])

    def test_json_is_one_object_a_line(self):
        self.write("small.toml", SMALL)
        lines = self.run_well("evolve", "small.toml", "--json").stdout.splitlines()
        reports = [json.loads(line) for line in lines]
        self.assertEqual([report["generation"] for report in reports[:-1]], [0, 1, 2])
        self.assertEqual(reports[-1]["generations"], 3)
        self.assertFalse(reports[-1]["interrupted"])
        self.assertEqual(reports[-1]["best_of_last"], reports[2]["best"])
        self.assertTrue((self.folder / reports[-1]["champion"]).exists())

    def test_the_champion_goes_where_it_is_asked_to(self):
        self.write("small.toml", SMALL)
        name = "champion-walking-seed5.creature.json"
        common = ["evolve", "small.toml", "-n", 1, "-s", 5]
        self.run_well(*common)
        self.assertTrue((self.folder / name).exists())
        self.run_well(*common, "--out", "new/folder/")
        self.assertTrue((self.folder / "new/folder" / name).exists())
        self.run_well(*common, "--out", "new")
        self.assertTrue((self.folder / "new" / name).exists())
        self.run_well(*common, "--out", "mine.json")
        self.assertTrue((self.folder / "mine.json").exists())
        self.run_well(*common, "--out", "/dev/null")
        self.assertFalse(os.path.isfile("/dev/null"))

    def test_the_champion_scores_in_its_file_what_the_report_said(self):
        self.write("small.toml", SMALL)
        reports = self.run_well("evolve", "small.toml", "--json", "-o", "a.json").stdout
        best = json.loads(reports.splitlines()[-1])["best_of_last"]
        creature = json.loads((self.folder / "a.json").read_text())
        self.assertEqual(creature["scored"]["fitness"], best)
        self.assertEqual(creature["scored"]["trial"]["duration"], 2)

    def test_a_place_that_cannot_be_written_is_refused_before_evolving(self):
        self.write("small.toml", "[run]\ngenerations = 1000000\n")
        for place in ["no/such/folder/a.json", "/proc/a.json", "/proc/new/"]:
            result = self.run_program("evolve", "small.toml", "--out", place)
            self.assert_refused(result, "cannot", place.rstrip("/"))
        self.assertEqual(self.files(), ["small.toml"])

    def test_a_folder_without_permission_is_refused(self):
        if os.geteuid() == 0:
            self.skipTest("root may write anywhere")
        self.write("small.toml", SMALL)
        (self.folder / "locked").mkdir(mode=0o555)
        self.assert_refused(self.run_program("evolve", "small.toml", "--out", "locked/"),
                            "Permission denied")

    def test_a_champion_is_not_lost_when_its_place_vanishes(self):
        self.write("small.toml", SMALL)
        (self.folder / "gone").mkdir()
        refuge = self.folder / "refuge"
        refuge.mkdir()
        process = subprocess.Popen(
            [CAMBRIAN, "evolve", "small.toml", "-n", "20", "-o", "gone/a.creature.json"],
            cwd=self.folder, env=dict(os.environ, TMPDIR=str(refuge)), stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, encoding="utf-8")
        process.stdout.readline()  # generation 0; the champion is written after the last one
        (self.folder / "gone").rename(self.folder / "elsewhere")
        _, messages = process.communicate(timeout=600)
        if process.returncode == DONE:
            self.skipTest("the champion was written before the folder could be removed")
        self.assertEqual(process.returncode, FAILED)
        self.assertIn("the champion is in", messages)
        rescued = list(refuge.glob("rescued-*-a.creature.json"))
        self.assertEqual(len(rescued), 1)
        self.assertIn(str(rescued[0]), messages)

    def test_a_full_disk_is_reported_and_the_old_file_kept(self):
        self.write("small.toml", SMALL)
        disk = self.folder / "disk"
        disk.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=8k", "tmpfs", str(disk)],
                          stderr=subprocess.DEVNULL, check=False).returncode != 0:
            self.skipTest("a small disk cannot be mounted here")
        self.addCleanup(subprocess.run, ["umount", str(disk)], check=False)
        (disk / "old.json").write_text("old")
        (disk / "filler").write_text("x" * 4096)
        result = self.run_program("evolve", "small.toml", "-n", 1, "-o", "disk/old.json",
                                  env={"TMPDIR": str(disk)})
        self.assertNotEqual(result.returncode, DONE)
        self.assertIn("No space left on device", result.stderr)
        self.assertEqual((disk / "old.json").read_text(), "old")

    def test_ctrl_c_keeps_the_champion_of_the_last_finished_generation(self):
        self.write("long.toml", SMALL.replace("generations = 3", "generations = 1000000"))
        process = subprocess.Popen([CAMBRIAN, "evolve", "long.toml", "--json", "-o", "a.json"],
                                   cwd=self.folder, stdout=subprocess.PIPE, encoding="utf-8")
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate(timeout=600)
        self.assertEqual(process.returncode, DONE)
        final = json.loads(output.splitlines()[-1])
        self.assertTrue(final["interrupted"])
        self.assertTrue((self.folder / "a.json").exists())

    def test_on_a_terminal_a_bar_shows_the_progress(self):
        self.write("small.toml", SMALL)
        master, slave = pty.openpty()
        process = subprocess.Popen([CAMBRIAN, "evolve", "small.toml"], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=slave, encoding="utf-8")
        os.close(slave)
        shown = b""
        while True:
            try:
                chunk = os.read(master, 4096)
            except OSError:  # the program has closed the terminal
                break
            if not chunk:
                break
            shown += chunk
        output, _ = process.communicate(timeout=600)
        os.close(master)
        self.assertRegex(shown.decode(), r"generation \d of 3 \[#*\.*\] \d+ %")
        self.assertTrue(shown.endswith(b"\r\x1b[K"))
        self.assertNotIn("\x1b", output)


if __name__ == "__main__":
    unittest.main(verbosity=2)
