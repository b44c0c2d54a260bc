"""Pictures, clips and cards without a display, as `cambrian render` makes them."""

import json
import os
import signal
import subprocess
import time
import unittest

from program import BAD_INPUT, FAILED, ROOT, ProgramTest

WALKER = ROOT / "assets/creatures/walker.creature.json"
SWIMMER = ROOT / "assets/creatures/finned_swimmer.creature.json"
POND = "[preserve]\nwidth = 12\nheight = 10\nfounders = 6\nenergy-density = 100\n"


class Render(ProgramTest):
    def setUp(self):
        super().setUp()
        for name in ["DISPLAY", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR"]:
            saved = os.environ.pop(name, None)
            if saved is not None:
                self.addCleanup(os.environ.__setitem__, name, saved)

    def render(self, creature, out, *options):
        self.run_well("render", creature, "-o", out, *options)
        return self.folder / out

    def picture_facts(self, path):
        """Returns width, height and number of colours, read by an independent decoder."""
        told = subprocess.run(["convert", str(path), "-format", "%w %h %k", "info:"], check=True,
                              stdout=subprocess.PIPE, encoding="utf-8").stdout
        return tuple(map(int, told.split()))

    def clip_facts(self, path):
        form = ["-f", "apng"] if path.suffix in (".png", ".apng") else []
        told = subprocess.run(
            ["ffprobe", *form, "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
             "stream=width,height,nb_read_frames,r_frame_rate", "-of", "json", str(path)],
            check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout
        return json.loads(told)["streams"][0]

    def refuse(self, *arguments, parts, status=BAD_INPUT):
        before = self.files()
        self.assert_refused(self.run_program("render", *arguments), *parts, status=status)
        self.assertEqual(self.files(), before)

    def test_a_sheet_is_a_picture_of_its_size(self):
        width, height, colors = self.picture_facts(self.render(WALKER, "sheet.png"))
        self.assertEqual((width, height), (1600, 900))
        self.assertGreater(colors, 500)

    def test_size_poses_and_theme_change_the_sheet(self):
        dark = self.render(WALKER, "dark.png", "--size", "640x360", "--poses", "4")
        light = self.render(WALKER, "light.png", "--size", "640x360", "--poses", "4",
                            "--theme", "light")
        self.assertEqual(self.picture_facts(dark)[:2], (640, 360))
        self.assertNotEqual(dark.read_bytes(), light.read_bytes())
        more = self.render(WALKER, "more.png", "--size", "640x360", "--poses", "9")
        self.assertNotEqual(dark.read_bytes(), more.read_bytes())

    def test_any_trial_of_a_score_can_be_drawn(self):
        dodger = ROOT / "assets/creatures/dodger.creature.json"
        sheets = [self.render(dodger, f"{trial}.png", "--size", "320x180", "--trial", trial)
                  .read_bytes() for trial in ("1", "2")]
        self.assertNotEqual(*sheets)
        self.assertEqual(sheets[0], self.render(dodger, "same.png", "--size", "320x180")
                         .read_bytes())
        self.refuse(WALKER, "-o", "a.png", "--trial", "2", parts=["there is no trial 2"])

    def test_a_swimmer_has_its_sheet_too(self):
        self.assertGreater(self.picture_facts(self.render(SWIMMER, "swimmer.png"))[2], 500)

    def test_a_clip_has_the_frames_asked_for(self):
        clip = self.render(WALKER, "clip.mp4", "--size", "320x180", "--fps", "20", "--seconds", "2")
        facts = self.clip_facts(clip)
        self.assertEqual((facts["width"], facts["height"]), (320, 180))
        self.assertEqual(facts["nb_read_frames"], "40")
        self.assertEqual(facts["r_frame_rate"], "20/1")

    def test_a_clip_of_half_the_speed_has_twice_the_frames(self):
        clip = self.render(WALKER, "slow.gif", "--size", "160x90", "--fps", "10", "--seconds", "1",
                           "--speed", "0.5")
        self.assertEqual(self.clip_facts(clip)["nb_read_frames"], "20")

    def test_a_gif_needs_no_ffmpeg_and_has_a_size_of_its_own(self):
        (self.folder / "empty").mkdir()
        self.run_well("render", WALKER, "-o", "a.gif", "--seconds", 3,
                      env={"PATH": str(self.folder / "empty")})
        facts = self.clip_facts(self.folder / "a.gif")
        self.assertEqual((facts["width"], facts["height"]), (640, 360))
        self.assertEqual(facts["nb_read_frames"], "60")
        self.assertLess((self.folder / "a.gif").stat().st_size, 1_500_000)

    def test_dithering_and_theme_change_a_gif(self):
        small = ("--size", "97x65", "--seconds", "0.2")
        made = [self.render(WALKER, f"{number}.gif", *small, *options).read_bytes()
                for number, options in enumerate([(), (), ("--dither",), ("--theme", "light")])]
        self.assertEqual(made[0], made[1])
        self.assertEqual(len(set(made)), 3)

    def test_a_moving_card_carries_its_creature(self):
        card = self.render(WALKER, "walker.card.png", "--animated", "--seconds", "1")
        self.assertEqual(self.clip_facts(card)["nb_read_frames"], "20")
        self.assertEqual(self.picture_facts(card)[:2], (600, 800))
        clip = self.render(WALKER, "walker.apng", "--seconds", "0.5", "--size", "160x90",
                           "--fps", "10")
        self.assertEqual(self.clip_facts(clip)["nb_read_frames"], "5")
        known = [self.run_well(*command, WALKER).stdout.replace(str(WALKER), "NAME")
                 for command in (["verify"], ["simulate", "--json"])]
        for moving in (card, clip):
            told = [self.run_well(*command, moving.name).stdout.replace(moving.name, "NAME")
                    for command in (["verify"], ["simulate", "--json"])]
            self.assertEqual(told, known)
        again = self.render(card, "again.card.png", "--animated", "--seconds", "1")
        self.assertEqual(again.read_bytes(), card.read_bytes())

    def test_a_clip_shows_the_complete_trial_unless_told(self):
        champion = self.evolve_champion()  # its trial lasts 2 s
        clip = self.render(champion, "uncut.mp4", "--size", "96x64", "--fps", "10")
        self.assertEqual(self.clip_facts(clip)["nb_read_frames"], "20")

    def keep_preserve(self, name, *seconds):
        """Keeps a small preserve until each of these times, going on from the one before."""
        self.write("pond.toml", POND)
        self.run_well("preserve", "pond.toml", "-f", SWIMMER, "--seconds", seconds[0], "-o", name)
        for later in seconds[1:]:
            self.run_well("preserve", "--resume", name, "--seconds", later)

    def test_a_picture_of_a_preserve_shows_the_moment_asked_for(self):
        self.keep_preserve("pond.cambrian", 60, 121)
        small = ("--size", "320x240")
        shown = [self.render("pond.cambrian", f"{index}.png", *small, *options).read_bytes()
                 for index, options in enumerate([(), ("--from", 120), ("--from", 119),
                                                  ("--from", 59), ("--theme", "light")])]
        self.assertEqual(shown[0], shown[1])
        self.assertEqual(len(set(shown)), 4)
        self.assertEqual(self.picture_facts(self.folder / "0.png")[:2], (320, 240))
        self.assertGreater(self.picture_facts(self.folder / "0.png")[2], 50)

    def test_a_clip_of_a_preserve_ends_where_its_picture_does(self):
        self.keep_preserve("pond.cambrian", 120)
        options = ("--size", "160x120", "--fps", "10", "--speed", "2", "--to", "110")
        clip = self.render("pond.cambrian", "clip.gif", *options, "--from", "108")
        self.assertEqual(self.clip_facts(clip)["nb_read_frames"], "10")
        clip = self.render("pond.cambrian", "minute.mp4", "--size", "64x64", "--fps", "1",
                           "--speed", "10")
        self.assertEqual(self.clip_facts(clip)["nb_read_frames"], "6")

    def test_what_cannot_be_drawn_of_a_preserve_gets_one_message(self):
        self.keep_preserve("pond.cambrian", 60)
        for options, part in [
                (("-o", "a.png", "--from", 61), "--from 61 is outside 0 s to 60 s"),
                (("-o", "a.gif", "--to", 61), "--to 61 is outside 0 s to 60 s"),
                (("-o", "a.gif", "--from", 60), "--from 60 is not before 60 s"),
                (("-o", "a.gif", "--to", 0), "nothing moves yet at 0 s"),
                (("-o", "a.png", "--to", 10), "--to is for clips"),
                (("-o", "a.card.png",), "a preserve has no card"),
                (("-o", "a.png", "--poses", 3), "a preserve's times are --from and --to")]:
            self.refuse("pond.cambrian", *options, parts=[part])
        self.refuse(WALKER, "-o", "a.gif", "--from", 1, parts=["are for preserves"])
        self.write("small.toml", "[run]\ngenerations = 1\n[population]\nsize = 4\n"
                                 "[trial]\nduration = 1\n")
        self.run_well("evolve", "small.toml", "-o", "e.cambrian")
        self.refuse("e.cambrian", "-o", "a.png", parts=["it is an experiment, no preserve"])

    def test_a_card_carries_its_creature(self):
        card = self.render(WALKER, "walker.card.png")
        self.assertEqual(self.picture_facts(card)[:2], (960, 1280))
        self.assertIn(b"cambrian-creature", card.read_bytes())
        told = [self.run_well(*command, card.name).stdout.replace(card.name, "NAME")
                for command in (["verify"], ["simulate", "--json"])]
        known = [self.run_well(*command, WALKER).stdout.replace(str(WALKER), "NAME")
                 for command in (["verify"], ["simulate", "--json"])]
        self.assertEqual(told, known)
        again = self.render(card, "again.card.png")
        self.assertEqual(again.read_bytes(), card.read_bytes())

    def test_any_picture_can_be_made_a_card(self):
        self.render(WALKER, "posted.png", "--card", "--size", "480x640")
        self.assertIn("replay verified", self.run_well("verify", "posted.png").stdout)

    def test_evolution_begins_with_a_card(self):
        self.render(WALKER, "walker.card.png", "--size", "240x320")
        self.write("small.toml", "[run]\ngenerations = 1\n[population]\nsize = 4\n"
                                 "[trial]\nduration = 1\n")
        self.run_well("evolve", "small.toml", "--founders", "walker.card.png", "--out",
                      "champion.creature.json")

    def test_pictures_that_are_no_cards_are_refused(self):
        self.render(WALKER, "sheet.png", "--size", "160x90")
        uncut = self.render(WALKER, "walker.card.png", "--size", "240x320").read_bytes()
        for name, content, part in [
                ("sheet.png", None, "a picture without a creature inside"),
                ("cut.png", uncut[:len(uncut) // 2], "cut off"),
                ("bad.png", uncut.replace(b"cambrian-creature", b"cambrian-creatures"), "CRC"),
                ("odd.png", b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 8, "cannot be read")]:
            if content is not None:
                self.write(name, content)
            for command in ["simulate", "verify"]:
                self.assert_refused(self.run_program(command, name), name, part,
                                    "expected a creature card")

    def test_mistakes_are_told_and_write_nothing(self):
        self.refuse(WALKER, "-o", "clip.avi", parts=["clip.avi", ".png, .mp4, .gif, .apng or .html"])
        self.refuse(WALKER, "-o", "clip.mp4", "--card", parts=["a card is a picture"])
        self.refuse(WALKER, "-o", "a.png", "--fps", "3", parts=["--fps", "are for clips"])
        self.refuse(WALKER, "-o", "a.png", "--animated", parts=["--animated is for cards"])
        self.refuse(WALKER, "-o", "a.gif", "--animated", parts=["a card is a picture"])
        self.refuse(WALKER, "-o", "a.mp4", "--dither", parts=["--dither is for clips of few colors"])
        self.refuse(WALKER, "-o", "a.card.png", "--dither", parts=["--dither is for clips"])
        self.refuse(WALKER, "-o", "a.mp4", "--poses", "3", parts=["--poses is for sheets"])
        self.refuse(WALKER, "-o", "a.mp4", "--size", "321x180", parts=["even"])
        self.refuse("none.creature.json", "-o", "a.png", parts=["none.creature.json"])
        for size in ["big", "0x0", "10x10", "640x", "x360", "640x360x2", "9999x100", "-640x360"]:
            result = self.run_program("render", WALKER, "-o", "a.png", "--size=" + size)
            self.assertEqual(result.returncode, BAD_INPUT, size)
            self.assertIn("expected WIDTHxHEIGHT", result.stderr)
        self.assertEqual(self.files(), [])

    def test_a_target_that_cannot_be_written_is_told_at_once(self):
        for name in ["nowhere/a.png", "nowhere/a.mp4", "nowhere/a.card.png"]:
            self.refuse(WALKER, "-o", name, parts=["cannot write " + name])
        (self.folder / "folder.png").mkdir()
        self.refuse(WALKER, "-o", "folder.png", parts=["cannot write folder.png"])

    def test_without_ffmpeg_clips_say_so_and_pictures_work(self):
        (self.folder / "empty").mkdir()
        result = self.run_program("render", WALKER, "-o", "a.mp4",
                                  env={"PATH": str(self.folder / "empty")})
        self.assert_refused(result, "ffmpeg, which is not installed", status=FAILED)
        self.assertEqual(self.files(), ["empty"])
        self.run_well("render", WALKER, "-o", "a.png", env={"PATH": str(self.folder / "empty")})

    def test_what_ffmpeg_complains_of_is_told(self):
        fake = self.write("ffmpeg", "#!/bin/sh\necho 'no such encoder' >&2\nexit 1\n")
        fake.chmod(0o755)
        result = self.run_program("render", WALKER, "-o", "a.mp4",
                                  env={"PATH": f"{self.folder}:/usr/bin:/bin"})
        self.assert_refused(result, "a.mp4", "no such encoder", status=FAILED)
        self.assertEqual(self.files(), ["ffmpeg"])

    def fake_ffmpeg(self, script):
        self.write("ffmpeg", "#!/bin/sh\n" + script).chmod(0o755)
        return self.run_program("render", WALKER, "-o", "a.mp4", "--seconds", 0.5,
                                env={"PATH": f"{self.folder}:/usr/bin:/bin"})

    def test_many_messages_of_ffmpeg_hold_up_no_clip(self):
        result = self.fake_ffmpeg("for last; do true; done\n"
                                  "head -c 300000 /dev/zero | tr '\\0' w >&2\n"
                                  "cat > ${last#file:}\n"
                                  "head -c 300000 /dev/zero | tr '\\0' w >&2\n")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.files(), ["a.mp4", "ffmpeg"])

    def test_a_clip_into_which_ffmpeg_wrote_nothing_is_an_error(self):
        result = self.fake_ffmpeg("cat > /dev/null\n")
        self.assert_refused(result, "cannot make a.mp4: ffmpeg wrote nothing", status=FAILED)
        self.assertEqual(self.files(), ["ffmpeg"])

    def test_a_gif_is_as_long_in_browsers_as_its_trial(self):
        self.refuse(WALKER, "-o", "a.gif", "--fps", 60,
                    parts=["a.gif: a GIF shows at most 50 frames a second, found 60"])
        self.run_well("render", WALKER, "-o", "a.gif", "--seconds", 0.5, "--fps", 50,
                      "--size", "64x64")
        gif = (self.folder / "a.gif").read_bytes()
        delays = [int.from_bytes(gif[at + 4:at + 6], "little") for at in range(len(gif) - 8)
                  if gif[at:at + 3] == b"\x21\xf9\x04" and gif[at + 7] == 0]
        self.assertEqual(set(delays), {2})

    def test_a_full_disk_leaves_no_clip(self):
        for name in ["a.gif", "a.apng", "a.mp4", "a.card.png"]:
            disk = self.small_disk("100k", "disk of " + name)
            options = ("--animated",) if name == "a.card.png" else ()
            result = self.run_program("render", WALKER, "-o", disk / name, *options)
            self.assertEqual(result.returncode, FAILED, name)
            self.assertIn("No space left on device", result.stderr)
            self.assertEqual(list(disk.iterdir()), [])

    def test_a_killed_clip_is_removed_by_the_next(self):
        process = self.start("render", WALKER, "-o", "clip.gif", "--speed", 0.05,
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        deadline = time.monotonic() + 120
        while not self.files() and time.monotonic() < deadline:
            time.sleep(0.05)
        process.kill()
        process.communicate(timeout=120)
        self.assertFalse((self.folder / "clip.gif").exists())
        self.render(WALKER, "clip.gif", "--size", "64x64", "--seconds", "0.1")
        self.assertEqual(self.files(), ["clip.gif"])

    def test_an_interrupted_clip_leaves_nothing(self):
        before = self.write("clip.mp4", "the clip before")
        process = self.start("render", WALKER, "-o", "clip.mp4", "--fps", 120, "--speed", 0.05,
                             stdout=subprocess.DEVNULL)
        self.wait_until_caught(process, signal.SIGINT)
        deadline = time.monotonic() + 120
        while len(self.files()) < 2 and time.monotonic() < deadline:
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        _, message = process.communicate(timeout=120)
        self.assertEqual(process.returncode, FAILED)
        self.assertIn("interrupted", message)
        self.assertEqual(self.files(), ["clip.mp4"])
        self.assertEqual(before.read_text(), "the clip before")


if __name__ == "__main__":
    unittest.main(verbosity=2)
