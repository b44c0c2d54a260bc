"""cambrian evolve: its reports, its files, and that it is reproducible."""

import json
import os
import pty
import signal
import subprocess
import time
import unittest

from program import CAMBRIAN, DONE, FAILED, ROOT, SMALL, ProgramTest


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
        self.assertEqual(len(lines), 8)
        for number, line in enumerate(lines[:4]):
            self.assertRegex(line, rf"^generation +{number}   best +[0-9.]+ BL/s   median")
        self.assertRegex(lines[6], r"^confirmed: [0-9.]+ BL/s, the median of 11 worlds "
                                   r"\([0-9.]+ to [0-9.]+\)$")
        self.assertEqual(lines[7], "experiment: walking-seed1.cambrian")
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
        self.assertEqual(reports[-1]["stopped_by"], "generations")
        self.assertEqual(reports[-1]["best_of_last"], reports[2]["best"])
        self.assertTrue((self.folder / reports[-1]["champion"]).exists())
        first = reports[0]
        self.assertEqual(first["reused"] + first["evaluations"] - first["confirmations"], 12)
        self.assertGreater(first["confirmations"], 0)
        self.assertEqual(sum(first["births_by_line"].values()), 12)
        self.assertEqual(len(reports[-1]["scores"]), 11)
        self.assertEqual(reports[-1]["fitness"], sorted(reports[-1]["scores"])[5])
        self.assertIsNone(reports[-1]["audited"])  # 2 s are too short to end early

    def test_the_champions_origin_is_told_in_words(self):
        self.write("grown.toml", SMALL + "[mutation]\nrate = 3\n")
        report = self.run_well("evolve", "grown.toml", "-n", 12, "--json", "-o", "a.json").stdout
        champion = json.loads(report.splitlines()[-1])
        self.assertGreater(champion["born"], 0)
        self.assertIn(champion["method"], ["asexual", "crossover", "grafting", "tuning"])
        self.assertGreater(len(champion["parents"]), 0)
        self.assertGreater(len(champion["mutations"]), 0)
        for mutation in champion["mutations"]:
            self.assertEqual(sorted(mutation), ["from", "operator", "place", "to"])
            self.assertTrue(mutation["operator"] and mutation["place"] and mutation["to"])
        words = self.run_well("evolve", "grown.toml", "-n", 12, "-o", "a.json").stdout
        [told] = [line for line in words.splitlines() if line.startswith("champion: ")]
        self.assertIn(champion["mutations"][0]["place"] + ": ", told)
        self.assertRegex(champion["name"], "^[A-Z][a-z]{5,}$")
        self.assertIn(champion["name"] + " in a.json (born in generation", told)

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
        self.assert_refused(self.run_program(*common, "--out", "results"), "--out results",
                            "results/", "results.cambrian")
        self.run_well(*common, "--out", "mine.json")
        self.assertTrue((self.folder / "mine.json").exists())
        self.run_well(*common, "--out", "/dev/null")
        self.assertFalse(os.path.isfile("/dev/null"))

    def test_a_name_that_fits_no_file_of_a_run_is_refused(self):
        self.write("small.toml", SMALL)
        self.write("kept.toml", SMALL)
        (self.folder / "res").mkdir()
        before = self.files()
        for name in ["runs-2026.11.29", "res/gravity9.81", "run.Cambrian", "a.csv", "a.card.png",
                     "kept.toml", ".json"]:
            result = self.run_program("evolve", "small.toml", "-n", 1, "--out", name)
            self.assert_refused(result, f"--out {name}: expected a folder ({name}/), an experiment "
                                        f"({name}.cambrian) or a creature file")
        self.assertEqual(self.files(), before)
        self.assertEqual((self.folder / "kept.toml").read_text(), SMALL)

    def test_what_a_name_will_become_is_said_before_the_run(self):
        self.write("small.toml", SMALL)
        champion = "champion-walking-seed1.creature.json"
        for options, words in [
                ([], f"writes the experiment to walking-seed1.cambrian and the champion to {champion}"),
                (["-o", "new/"], "the experiment to new/walking-seed1.cambrian and the champion to "
                                 f"new/{champion}"),
                (["-o", "a.cambrian"], "writes the experiment to a.cambrian\n"),
                (["-o", "a.json"], "writes the champion to a.json, and no experiment; --out")]:
            result = self.run_well("evolve", "small.toml", "-n", 1, *options)
            self.assertIn(words, result.stderr)
            self.assertEqual(result.stderr.count("\n"), 1)

    def test_equal_runs_at_once_into_one_folder_all_keep_their_files(self):
        self.write("small.toml", SMALL)
        runs = [self.start("evolve", "small.toml", "-n", 1, "--threads", 1, "--out", "sweep/")
                for _ in range(8)]
        for run in runs:
            _, messages = run.communicate(timeout=240)
            self.assertEqual(run.returncode, DONE, messages)
        numbers = ["", *(f"-{number}" for number in range(2, 9))]
        self.assertEqual(sorted(path.name for path in (self.folder / "sweep").iterdir()),
                         sorted([f"walking-seed1{each}.cambrian" for each in numbers] +
                                [f"champion-walking-seed1{each}.creature.json" for each in numbers]))

    @unittest.skipUnless(os.geteuid() == 0, "only root can become another user")
    def test_a_start_without_threads_says_so_and_leaves_no_file(self):
        self.write("small.toml", SMALL)
        self.write("pond.toml", (ROOT / "assets/settings/pond.toml").read_text())
        self.folder.chmod(0o777)
        user = ["setpriv", "--reuid=64321", "--regid=64321", "--clear-groups"]
        program = self.reachable_program()
        before = self.files()
        for command in [["evolve", "small.toml", "-n", "1"],
                        ["preserve", "pond.toml", "--seconds", "1"]]:
            run = [program, *command, "--out", "p.cambrian"]
            result = subprocess.run([*user, "prlimit", "--nproc=3", *run, "--threads", "16"],
                                    cwd=self.folder, capture_output=True, encoding="utf-8",
                                    check=False)
            self.assert_refused(result, "threads", "--threads", status=FAILED)
            self.assertEqual(self.files(), before)
            result = subprocess.run([*user, *run, "--threads", "1"], cwd=self.folder,
                                    capture_output=True, encoding="utf-8", check=False)
            self.assertEqual(result.returncode, DONE, result.stderr)
            (self.folder / "p.cambrian").unlink()

    def test_signals_that_were_ignored_before_the_start_stay_ignored(self):
        self.write("small.toml", "[run]\ngenerations = 100000\n[population]\nsize = 6\n"
                                 "[trial]\nduration = 1\n")
        pond = ROOT / "assets/settings/pond.toml"
        for command in [["evolve", "small.toml", "--out", "a.cambrian"],
                        ["preserve", pond, "--out", "b.cambrian"]]:
            process = self.start(*command, "--threads", 1, stdout=subprocess.DEVNULL,
                                 preexec_fn=lambda: (signal.signal(signal.SIGHUP, signal.SIG_IGN),
                                                     signal.signal(signal.SIGINT, signal.SIG_IGN)))
            self.wait_until_caught(process, signal.SIGTERM)
            for ignored in (signal.SIGHUP, signal.SIGINT):
                process.send_signal(ignored)
            time.sleep(0.5)
            self.assertIsNone(process.poll())
            process.send_signal(signal.SIGTERM)
            process.communicate(timeout=120)
            self.assertEqual(process.returncode, DONE)

    def test_the_champion_scores_in_its_file_what_the_report_said(self):
        self.write("small.toml", SMALL)
        reports = self.run_well("evolve", "small.toml", "--json", "-o", "a.json").stdout
        final = json.loads(reports.splitlines()[-1])
        creature = json.loads((self.folder / "a.json").read_text())
        self.assertEqual(creature["scored"]["fitness"], final["scores"][0])
        self.assertEqual(creature["scored"]["confirmed"],
                         {"worlds": 11, "median": final["fitness"],
                          "lowest": min(final["scores"]), "highest": max(final["scores"])})
        self.run_well("verify", "a.json")
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

    def test_a_read_only_disk_is_refused_before_anything_is_computed(self):
        self.write("small.toml", SMALL)
        disk = self.small_disk("4m")
        self.run_well("evolve", "small.toml", "-n", 1, "-o", "disk/a.cambrian")
        before = (disk / "a.cambrian").read_bytes()
        self.remount(disk, "ro")
        for arguments in [["evolve", "small.toml", "-o", "disk/b.cambrian"],
                          ["evolve", "small.toml", "-o", "disk/"],
                          ["evolve", "--resume", "disk/a.cambrian", "-n", 2]]:
            self.assert_refused(self.run_program(*arguments), "disk/", "ead-only")
        self.run_well("verify", "disk/a.cambrian")
        self.run_well("export", "disk/a.cambrian", "--stats")
        self.assertEqual((disk / "a.cambrian").read_bytes(), before)

    def test_a_champion_is_not_lost_when_its_place_vanishes(self):
        self.write("small.toml", SMALL)
        (self.folder / "gone").mkdir()
        refuge = self.folder / "refuge"
        refuge.mkdir()
        process = self.start("evolve", "small.toml", "-n", 20, "-o", "gone/a.creature.json",
                             env=dict(os.environ, TMPDIR=str(refuge)))
        process.stdout.readline()  # generation 0; the champion is written last
        (self.folder / "gone").rename(self.folder / "elsewhere")
        _, messages = process.communicate(timeout=600)
        if process.returncode == DONE:
            self.skipTest("the champion was written before the folder could be removed")
        self.assertEqual(process.returncode, FAILED)
        self.assertIn("the champion is in", messages)
        rescued = list(refuge.glob("cambrian-rescued-*/a.creature.json"))
        self.assertEqual(len(rescued), 1)
        self.assertIn(str(rescued[0]), messages)
        self.assertEqual(rescued[0].parent.stat().st_mode & 0o077, 0)  # nobody can plant a link

    def test_a_run_ends_at_its_target_or_its_last_evaluation(self):
        self.write("target.toml", SMALL.replace("generations = 3", "generations = 1000\n"
                                                "target-fitness = 1e-3"))
        report = self.run_well("evolve", "target.toml", "--json", "-o", "a.json").stdout
        final = json.loads(report.splitlines()[-1])
        self.assertEqual(final["stopped_by"], "target-fitness")
        self.assertGreaterEqual(final["best_of_last"], 1e-3)
        self.write("few.toml", SMALL.replace("generations = 3", "generations = 1000\n"
                                             "max-evaluations = 40"))
        lines = self.run_well("evolve", "few.toml", "--json", "-o", "a.json").stdout.splitlines()
        reports = [json.loads(line) for line in lines]
        self.assertEqual(reports[-1]["stopped_by"], "evaluations")
        spent = [report["evaluations"] for report in reports[:-1]]
        self.assertGreaterEqual(sum(spent), 40)
        self.assertLess(sum(spent[:-1]), 40)

    def test_giving_up_tells_how_many_were_audited(self):
        # A trial ends after 4.5 s at the earliest.
        self.write("hasty.toml", SMALL.replace("duration = 2", "duration = 9")
                   .replace("size = 12", "size = 30"))
        words = self.run_well("evolve", "hasty.toml", "-n", 6, "-o", "a.json").stdout
        self.assertRegex(words, r"\nearly termination: \d+ audited, \d+ would have survived\n")
        report = self.run_well("evolve", "hasty.toml", "-n", 6, "--json", "-o", "a.json").stdout
        audited = json.loads(report.splitlines()[-1])["audited"]
        self.assertGreater(audited["finished"], 0)
        self.assertLessEqual(audited["would_have_survived"], audited["finished"])

    def test_rejected_creatures_do_not_take_a_population_of_negative_scores(self):
        self.write("seek.toml", '[goal]\nbehavior = "seeking"\n[population]\nsize = 20\n'
                                "[trial]\nduration = 5.0\n")
        lines = self.run_well("evolve", "seek.toml", "-n", 12, "--json", "-o", "a.json").stdout
        reports = [json.loads(line) for line in lines.splitlines()]
        for report in reports[1:-1]:
            self.assertLess(report["rejected"], 0.5 * report["evaluations"], report)
            self.assertLessEqual(report["lower"], report["median"])
            self.assertLessEqual(report["median"], report["best"])

    def test_the_exported_champion_is_the_one_that_was_audited(self):
        self.write("small.toml", SMALL)
        self.run_well("evolve", "small.toml", "--seed", 3, "--out", "one/")
        saved = (self.folder / "one/champion-walking-seed3.creature.json").read_text()
        run = "one/walking-seed3.cambrian"
        self.assertEqual(json.loads(saved)["scored"]["confirmed"]["worlds"], 11)
        self.assertEqual(self.run_well("export", run, "--champion").stdout, saved)
        # It is so for the run that goes on, too.
        self.run_well("evolve", "--resume", run, "-n", 5, "--out", "later.json")
        later = (self.folder / "later.json").read_text()
        self.assertEqual(self.run_well("export", run, "--champion").stdout, later)
        self.assertEqual(self.run_well("export", run, "-g", 2).stdout, saved)
        self.run_well("verify", run)

    def test_founders_begin_the_population(self):
        self.write("small.toml", SMALL + "[selection]\nconfirmations = 0\n")
        self.run_well("evolve", "small.toml", "-n", 1, "-s", 3, "-o", "a.json")
        self.run_well("evolve", "small.toml", "-n", 1, "-s", 4, "-o", "b.json")
        before = max(json.loads((self.folder / name).read_text())["scored"]["fitness"]
                     for name in ["a.json", "b.json"])
        report = self.run_well("evolve", "small.toml", "-n", 1, "--json", "-o", "c.json",
                               "--founders", "a.json", "b.json").stdout
        self.assertGreaterEqual(json.loads(report.splitlines()[0])["best"], before)

    def test_founders_with_what_the_experiment_has_not_enabled_are_told_of(self):
        self.write("small.toml", SMALL)
        linear = ROOT / "tests/persist/creatures/W04_linear_joint.creature.json"
        for more, expected in [("", True), ("[body.joints]\nlinear = true\n", False)]:
            self.write("s.toml", SMALL + more)
            result = self.run_well("evolve", "s.toml", "-n", 1, "--founders", linear)
            self.assertEqual("W04 " in result.stderr, expected, result.stderr)

    def test_a_museum_fills_and_gives_founders(self):
        self.write("small.toml", SMALL)
        museum = self.folder / "museum"
        first = self.run_well("evolve", "small.toml", "-s", 3, "--museum", "museum", "-o", "a.json")
        self.assertIn("museum: the champion's body plan is new", first.stderr)
        [exhibit] = museum.iterdir()
        self.assertEqual(exhibit.read_bytes(), (self.folder / "a.json").read_bytes())
        self.run_well("verify", exhibit)
        again = self.run_well("evolve", "small.toml", "-s", 3, "--museum", "museum", "-o", "b.json")
        self.assertIn("museum: a creature with the champion's body plan is here already",
                      again.stderr)
        share = ["--set", "population.museum=0.25"]
        self.assert_refused(self.run_program("evolve", "small.toml", *share),
                            "[population] museum is 0.25", "expected its folder, by --museum")
        report = self.run_well("evolve", "small.toml", *share, "-s", 9, "-n", 1, "--museum",
                               "museum", "-o", "c.cambrian", "--json").stdout
        self.assertGreater(json.loads(report.splitlines()[0])["best"], 0)
        self.run_well("verify", "c.cambrian")
        empty = self.run_well("evolve", "small.toml", *share, "-n", 1, "--museum", "other",
                              "-o", "d.json")
        self.assertIn("other: the museum has no creature for this world yet", empty.stderr)

    def test_founders_that_cannot_be_used_are_refused(self):
        self.write("small.toml", SMALL)
        self.write("not.json", "{}")
        self.assert_refused(self.run_program("evolve", "small.toml", "-f", "none.json"),
                            "none.json", "No such file")
        self.assert_refused(self.run_program("evolve", "small.toml", "-f", "not.json"),
                            "not.json", "/format: missing")
        self.run_well("evolve", "small.toml", "-n", 1, "-o", "a.json")
        self.assert_refused(
            self.run_program("evolve", "small.toml", "-f", *["a.json"] * 13),
            "--founders: 13 creatures, but [population] size is 12")

    def test_a_goal_in_the_wrong_world_warns_and_runs(self):
        self.write("dry.toml", SMALL + "[goal]\nbehavior = \"swimming\"\n[environment]\n"
                   "ground = true\ngravity = 9.81\nviscosity-linear = 0\n"
                   "viscosity-quadratic = 0\n")
        result = self.run_well("evolve", "dry.toml", "-n", 1)
        self.assertIn("swimming makes little sense in this [environment]: the medium has no "
                      "viscosity", result.stderr)

    def test_every_selection_evolves_and_reports_the_same_every_time(self):
        for method in ["rank", "tournament", "roulette", "map-elites", "novelty",
                       "age-protection"]:
            self.write("s.toml", SMALL + f"[selection]\nmethod = \"{method}\"\n")
            reports = {self.run_well("evolve", "s.toml", "--json", "-t", threads, "-o",
                                     "a.json").stdout for threads in [1, 3]}
            self.assertEqual(len(reports), 1, method)
            self.run_well("verify", "a.json")

    def test_several_trials_are_verified_like_one(self):
        self.write("robust.toml", SMALL + "trials = 3\nfriction-jitter = 0.15\n"
                   "tilt-jitter = 2\ncombine = \"minimum\"\n")
        self.run_well("evolve", "robust.toml", "-n", 2, "-s", 9, "-o", "a.json")
        self.assertEqual(json.loads((self.folder / "a.json").read_text())
                         ["scored"]["trial"]["trials"], 3)
        self.run_well("verify", "a.json")

    def test_a_champion_of_drawn_ground_is_scored_on_ground_that_no_generation_saw(self):
        self.write("rough.toml", SMALL + "trials = 2\n")
        drawn = ("--set", 'environment.terrain="rough"', "--set", "environment.terrain-same=false")
        for options, is_held_out in ((), False), (drawn, True):
            lines = self.run_well("evolve", "rough.toml", "-n", 1, "-s", 9, "--json", *options,
                                  "-o", f"{is_held_out}.json").stdout.splitlines()
            self.assertEqual(json.loads(lines[-1])["held_out"] is not None, is_held_out)

    def test_a_full_disk_is_reported_and_the_old_file_kept(self):
        self.write("small.toml", SMALL)
        disk = self.small_disk("8k")
        (disk / "old.json").write_text("old")
        (disk / "filler").write_text("x" * 4096)
        result = self.run_program("evolve", "small.toml", "-n", 1, "-o", "disk/old.json",
                                  env={"TMPDIR": str(disk)})
        self.assertNotEqual(result.returncode, DONE)
        self.assertIn("No space left on device", result.stderr)
        self.assertEqual((disk / "old.json").read_text(), "old")

    def test_ctrl_c_keeps_the_champion_of_the_last_finished_generation(self):
        self.write("long.toml", SMALL.replace("generations = 3", "generations = 1000000"))
        process = self.start("evolve", "long.toml", "--json", "-o", "a.json",
                             stderr=subprocess.DEVNULL)
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
