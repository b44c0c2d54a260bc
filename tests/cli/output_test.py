"""Output: results to standard output, files that are replaced, and files that never are."""

import os
import stat
import subprocess
import threading
import unittest

from program import BAD_INPUT, CAMBRIAN, DONE, FAILED, SMALL, ProgramTest


class Output(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("small.toml", SMALL)

    def shell(self, command, **options):
        """Runs a shell command in which $C is the program."""
        return subprocess.run(["bash", "-c", command], cwd=self.folder,
                              env=dict(os.environ, C=CAMBRIAN), stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8",
                              timeout=600, check=False, **options)

    def every_printer(self):
        """Returns every command that writes to standard output, each with its own files."""
        self.run_well("evolve", "small.toml", "-n", 2, "-o", "run.cambrian")
        self.run_well("export", "run.cambrian", "--champion", "-o", "best.creature.json")
        return ["--help", "--version", "evolve --help", "settings", "schema", "manual",
                "completion bash", "completion zsh", "completion fish",
                "simulate best.creature.json", "simulate best.creature.json --json",
                "verify best.creature.json", "verify run.cambrian",
                "export run.cambrian --champion", "export run.cambrian --stats",
                "export run.cambrian --settings", "export run.cambrian --stats -o /dev/stdout",
                "settings -o /dev/stdout", "settings -o /dev/fd/1",
                "simulate best.creature.json --trace /dev/stdout",
                "evolve small.toml -n 1 -o other.cambrian",
                "evolve small.toml -n 1 --json -o other.creature.json"]

    def assert_write_failure(self, result, command, reason, status=FAILED):
        self.assertEqual(result.returncode, status, (command, result.stderr))
        lines = [line for line in result.stderr.splitlines()
                 if "to continue" not in line and "cambrian: writes the" not in line]
        self.assertEqual(len(lines), 1, (command, result.stderr))
        self.assertTrue(lines[0].startswith("cambrian: cannot write"), (command, lines))
        self.assertIn(reason, lines[0], command)

    def test_a_full_disk_behind_standard_output_is_told(self):
        for command in self.every_printer():
            self.shell("rm -f other.*")
            result = self.shell(f"$C {command} > /dev/full")
            self.assert_write_failure(result, command, "No space left on device")

    def test_a_closed_standard_output_is_told_and_no_file_takes_its_place(self):
        for command in self.every_printer():
            self.shell("rm -f other.*")
            before = (self.folder / "run.cambrian").read_bytes()
            result = self.shell(f"$C {command} >&-")
            named = "/dev/" in command  # reported before the work begins
            self.assert_write_failure(result, command, "Bad file descriptor",
                                      status=BAD_INPUT if named else FAILED)
            self.assertEqual((self.folder / "run.cambrian").read_bytes(), before, command)

    def test_a_reader_that_has_gone_is_told(self):
        for command in self.every_printer():
            self.shell("rm -f other.*")
            reader, writer = os.pipe()
            os.close(reader)
            result = subprocess.run([CAMBRIAN, *command.split()], cwd=self.folder, stdout=writer,
                                    stdin=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                    encoding="utf-8", timeout=600, check=False)
            os.close(writer)
            self.assert_write_failure(result, command, "Broken pipe")

    def test_a_disk_that_fills_up_in_the_middle_is_told(self):
        disk = self.small_disk("4k")
        for command in ["settings", "schema", "manual", "completion zsh"]:
            result = self.shell(f"$C {command} > disk/out")
            self.assert_write_failure(result, command, "No space left on device")
        self.assertEqual(len(list(disk.iterdir())), 1)

    def test_what_is_in_the_file_behind_standard_output_stays(self):
        self.run_well("evolve", "small.toml", "-n", 2, "-o", "run.cambrian")
        table = self.run_well("export", "run.cambrian", "--stats").stdout
        for named in ["", " -o /dev/stdout", " -o /dev/fd/1", " -o /proc/self/fd/1",
                      " -o /proc/thread-self/fd/1", " -o out.csv"]:
            if "out.csv" in named:
                (self.folder / "out.csv").symlink_to("/dev/stdout")
            command = f"$C export run.cambrian --stats{named}"
            self.shell(f"(echo a; {command}; echo z) > f")
            self.assertEqual((self.folder / "f").read_text(), f"a\n{table}z\n", named)
            self.shell(f"{command} >> f")
            self.assertEqual((self.folder / "f").read_text(), f"a\n{table}z\n{table}", named)
        self.shell("exec 5> g; $C export run.cambrian --stats -o /dev/fd/5; echo z >&5")
        self.assertEqual((self.folder / "g").read_text(), table + "z\n")

    def test_a_file_that_was_removed_behind_standard_output_leaves_the_device(self):
        """Uses a folder in place of /dev, where a link taken for a file would be deleted."""
        result = self.shell("exec > gone; rm gone; ln -s /proc/self/fd/1 device.toml; "
                            "$C settings -o device.toml")
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.assertTrue((self.folder / "device.toml").is_symlink())
        self.assertEqual(self.files(), ["device.toml", "small.toml"])

    def test_open_files_that_cannot_be_written_are_refused(self):
        for line, reason in [("$C settings -o /dev/fd/7 7< small.toml", "Bad file descriptor"),
                             ("$C settings -o /dev/fd/9", "Bad file descriptor"),
                             (f"$C settings -o /proc/{os.getpid()}/fd/0", "another program")]:
            self.assert_refused(self.shell(line), reason)
        self.assertEqual((self.folder / "small.toml").read_text(), SMALL)

    def test_a_fifo_is_written_to_and_stays(self):
        os.mkfifo(self.folder / "pipe")
        got = []
        reader = threading.Thread(target=lambda: got.append((self.folder / "pipe").read_text()))
        reader.start()
        self.run_well("settings", "-o", "pipe")
        reader.join()
        self.assertEqual(got, [self.run_well("settings").stdout])
        self.assertTrue(stat.S_ISFIFO((self.folder / "pipe").stat().st_mode))

    def test_a_link_that_leads_to_nothing_yet_stays_a_link(self):
        (self.folder / "link.toml").symlink_to("new.toml")
        self.run_well("settings", "-o", "link.toml")
        self.assertTrue((self.folder / "link.toml").is_symlink())
        self.assertEqual((self.folder / "new.toml").read_text(),
                         self.run_well("settings").stdout)
        (self.folder / "round.toml").symlink_to("round.toml")
        self.assert_refused(self.run_program("settings", "-o", "round.toml"), "symbolic links")

    @unittest.skipUnless(os.geteuid() == 0, "only root makes devices")
    def test_devices_are_never_replaced(self):
        os.mknod(self.folder / "null.toml", stat.S_IFCHR | 0o666, os.makedev(1, 3))
        os.mknod(self.folder / "disk.toml", stat.S_IFBLK | 0o666, os.makedev(7, 250))
        self.run_well("settings", "-o", "null.toml")
        self.assertTrue(stat.S_ISCHR((self.folder / "null.toml").stat().st_mode))
        self.assert_refused(self.run_program("settings", "-o", "disk.toml"), "it is a disk")
        self.assertTrue(stat.S_ISBLK((self.folder / "disk.toml").stat().st_mode))

    def test_a_reader_that_leaves_ends_a_run_with_everything_kept(self):
        process = self.start("evolve", "small.toml", "-n", 100000, "-o", "runs/")
        process.stdout.readline()
        process.stdout.close()
        process.wait(timeout=600)
        messages = process.stderr.read()
        self.assertEqual(process.returncode, FAILED, messages)
        self.assertIn("Broken pipe", messages)
        self.assertIn("cambrian evolve --resume", messages)
        self.run_well("verify", "runs/champion-walking-seed1.creature.json")
        self.assertIn("generations", self.run_well("verify", "runs/walking-seed1.cambrian").stdout)

    def test_a_slow_reader_of_a_stream_that_does_not_wait_gets_everything(self):
        reader, writer = os.pipe()
        os.set_blocking(writer, False)
        process = subprocess.Popen([CAMBRIAN, "schema"], stdout=writer, stdin=subprocess.DEVNULL,
                                   cwd=self.folder)
        os.close(writer)
        with os.fdopen(reader, "rb") as stream:
            text = stream.read()
        self.assertEqual(process.wait(timeout=600), DONE)
        self.assertEqual(text.decode(), self.run_well("schema").stdout)


if __name__ == "__main__":
    unittest.main()
