"""The documents that the program writes: the manual page, the shells' completion, the schema. Also
tests that an installed program finds its installed files."""

import os
import pathlib
import re
import shutil
import subprocess
import unittest

from program import CAMBRIAN, ProgramTest

BUILD = pathlib.Path(CAMBRIAN).resolve().parents[1]


def names_in(help_text):
    """Returns the options and subcommands in the output of --help."""
    options = set(re.findall(r"(?<![\w-])(--?[a-z][a-z-]*)\b", help_text.split("Example:")[0]))
    _, _, subcommands = help_text.partition("Subcommands:")
    return options, re.findall(r"^  ([a-z]+)", subcommands, re.MULTILINE)


class Documents(ProgramTest):
    def everything(self):
        """Returns every subcommand with its options."""
        options, subcommands = names_in(self.run_well("--help").stdout)
        self.assertGreaterEqual(len(subcommands), 8)
        named = {"": options}
        for name in subcommands:
            named[name] = names_in(self.run_well(name, "--help").stdout)[0]
        return named

    def test_the_manual_names_every_subcommand_and_option(self):
        page = self.run_well("manual").stdout.replace("\\-", "-")
        for subcommand, options in self.everything().items():
            section = page if subcommand == "" else page.split(f"\n.SS {subcommand}\n")[1]
            section = section.split("\n.SS ")[0]
            for option in options - {"-q"}:
                self.assertIn(f"\\fB{option}\\fR", section)

    def test_each_option_is_explained_by_a_phrase_about_it(self):
        page = self.run_well("manual").stdout.replace("\\-", "-")
        options = re.findall(r"^\.TP\n(\\f.*)\n(.*)", page.split(".SH EXIT STATUS")[0], re.MULTILINE)
        self.assertGreater(len(options), 60)
        for names, text in options:
            self.assertRegex(text, r"^([A-Z]|[0-9])\w*", names)
            self.assertNotRegex(text, r"^(Which|What|How|Where|Who|So) ", names)

    def test_the_manual_is_good_roff(self):
        self.write("cambrian.1", self.run_well("manual").stdout)
        for checker in [["mandoc", "-T", "lint", "-W", "error"],
                        ["groff", "-ww", "-man", "-T", "utf8", "-z"],
                        ["man", "--warnings", "-l"]]:
            if shutil.which(checker[0]) is None:
                continue
            result = subprocess.run([*checker, "cambrian.1"], cwd=self.folder, check=False,
                                    stdin=subprocess.DEVNULL, encoding="utf-8",
                                    stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                    env=dict(os.environ, MANPAGER="cat", MANWIDTH="100"))
            self.assertEqual((result.returncode, result.stderr), (0, ""), checker)
            if checker[0] == "mandoc":
                self.assertEqual(result.stdout, "")

    def complete(self, *words):
        """Returns bash's completions of the last word, in a folder with some files."""
        self.write("completion.bash", self.run_well("completion", "bash").stdout)
        for name in ["a.creature.json", "two words.creature.json", "b.toml", "c.txt", "d.csv"]:
            self.write(name, "")
        (self.folder / "folder").mkdir(exist_ok=True)
        script = ('source ./completion.bash; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); '
                  '_cambrian; [ ${#COMPREPLY[@]} -eq 0 ] || printf "%s\\n" "${COMPREPLY[@]}"')
        result = subprocess.run(["bash", "--norc", "-c", script, "bash", "cambrian", *words],
                                cwd=self.folder, encoding="utf-8", check=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(result.stderr, "")
        return sorted(result.stdout.splitlines())

    def test_bash_completes_every_subcommand_and_option(self):
        named = self.everything()
        self.assertEqual(set(self.complete("")), set(named) - {""})
        self.assertEqual(self.complete("evo"), ["evolve"])
        for subcommand, options in named.items():
            words = [subcommand, "-"] if subcommand else ["-"]
            self.assertEqual(set(self.complete(*words)), options, subcommand)
        self.assertEqual(self.complete("evolve", "--gen"), ["--generations"])

    def test_bash_completes_files_by_their_endings(self):
        creatures = ["a.creature.json", "folder", "two words.creature.json"]
        self.assertEqual(self.complete("simulate", ""), creatures)
        self.assertEqual(self.complete("verify", "a.creature.json", ""), creatures)
        self.assertEqual(self.complete("rescore", "--out", ""), creatures)
        self.assertEqual(self.complete("simulate", "two"), ["two words.creature.json"])
        self.assertEqual(self.complete("evolve", ""), ["b.toml", "folder"])
        self.assertEqual(self.complete("evolve", "b.toml", "--founders", ""), creatures)
        self.assertEqual(self.complete("simulate", "--environment", ""), ["b.toml", "folder"])
        self.assertEqual(self.complete("simulate", "--trace", ""), ["d.csv", "folder"])
        self.assertEqual(self.complete("evolve", "b.toml", "--generations", ""), [])
        self.assertEqual(self.complete("completion", ""), ["bash", "fish", "zsh"])

    def test_zsh_and_fish_can_read_their_completion(self):
        for shell in ["zsh", "fish"]:
            script = self.run_well("completion", shell).stdout
            for subcommand, options in self.everything().items():
                for option in options:
                    word = re.escape(option.lstrip("-"))
                    self.assertRegex(script, rf"(?<![\w-])-*{word}(?![\w-])", subcommand)
            if shutil.which(shell):
                self.write("script", script)
                subprocess.run([shell, "-n", "script"], cwd=self.folder, check=True)

    def test_an_unknown_shell_is_refused(self):
        result = self.run_program("completion", "tcsh")
        self.assertEqual(result.returncode, 2)
        self.assertIn("tcsh", result.stderr)

    def test_an_installed_program_has_what_it_needs_beside_it(self):
        subprocess.run(["cmake", "--install", BUILD, "--prefix", self.folder / "usr"], check=True,
                       stdout=subprocess.DEVNULL)
        usr = self.folder / "usr"
        for path in ["share/man/man1/cambrian.1", "share/bash-completion/completions/cambrian",
                     "share/zsh/site-functions/_cambrian",
                     "share/fish/vendor_completions.d/cambrian.fish",
                     "share/cambrian/creatures/walker.creature.json",
                     "share/cambrian/help/files.md",
                     "share/cambrian/schema/creature-3.schema.json",
                     "share/cambrian/schema/creature-4.schema.json"]:
            self.assertGreater((usr / path).stat().st_size, 0, path)
        result = subprocess.run([usr / "bin/cambrian", "manual"], check=True, encoding="utf-8",
                                stdout=subprocess.PIPE)
        self.assertEqual(result.stdout, (usr / "share/man/man1/cambrian.1").read_text())


if __name__ == "__main__":
    unittest.main(verbosity=2)
