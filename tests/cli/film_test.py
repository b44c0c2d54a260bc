"""Films of runs and races of creatures, without a display."""

import json
import subprocess
import unittest

from program import BAD_INPUT, ROOT, SMALL, ProgramTest

CREATURES = ROOT / "assets/creatures"


class Film(ProgramTest):
    def clip_facts(self, name):
        told = subprocess.run(
            ["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
             "stream=width,height,nb_read_frames", "-of", "json", str(self.folder / name)],
            check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout
        facts = json.loads(told)["streams"][0]
        return facts["width"], facts["height"], int(facts["nb_read_frames"])

    def test_a_film_has_a_scene_for_each_champion_and_the_same_bytes_again(self):
        self.write("small.toml", SMALL)
        self.run_well("evolve", "small.toml", "-o", "run.cambrian")
        small = ("--size", "160x90", "--fps", "10")
        self.run_well("film", "run.cambrian", "-o", "a.gif", "--seconds", 1, *small)
        self.assertEqual(self.clip_facts("a.gif"), (160, 90, 3 * 10))
        self.run_well("film", "run.cambrian", "-o", "b.gif", "--seconds", 1, *small)
        self.assertEqual(*[(self.folder / name).read_bytes() for name in ["a.gif", "b.gif"]])
        # A trial lasts two seconds.
        self.run_well("film", "run.cambrian", "-o", "c.mp4", "--seconds", 60, *small)
        self.assertEqual(self.clip_facts("c.mp4"), (160, 90, 3 * 20))

    def test_a_race_has_the_frames_of_the_trial(self):
        runners = [CREATURES / f"{name}.creature.json" for name in ["biped", "crawler", "worm"]]
        self.run_well("race", *runners, "-o", "race.gif", "--size", "320x180", "--fps", 5)
        self.assertEqual(self.clip_facts("race.gif"), (320, 180, 15 * 5))
        self.run_well("race", *runners, "-o", "short.mp4", "--size", "320x180", "--seconds", 2)
        self.assertEqual(self.clip_facts("short.mp4"), (320, 180, 60))

    def test_what_cannot_be_shown_is_refused(self):
        walker = CREATURES / "walker.creature.json"
        for arguments, reason in [
                (["race", walker, "-o", "race.gif"], "1 creatures; expected 2 to 6"),
                (["race", *[walker] * 7, "-o", "race.gif"], "7 creatures; expected 2 to 6"),
                (["race", walker, walker, "-o", "race.mp4", "--size", "321x180"], "even"),
                (["race", walker, walker, "-o", "race.png"], "it will be a clip"),
                (["film", walker, "-o", "film.gif"], "walker"),
                (["film", "none.cambrian", "-o", "film.gif"], "none.cambrian")]:
            self.assert_refused(self.run_program(*arguments), reason, status=BAD_INPUT)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
