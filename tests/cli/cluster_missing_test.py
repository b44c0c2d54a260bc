"""A program that was built without libnats says so."""

import unittest

from program import ProgramTest


class Missing(ProgramTest):
    def test_without_libnats_each_command_says_what_to_install(self):
        self.write("settings.toml", "[run]\ngenerations = 1\n")
        for command in (["worker", "nats://localhost"], ["cluster", "nats://localhost"],
                        ["evolve", "settings.toml", "--cluster", "nats://localhost"]):
            self.assert_refused(self.run_program(*command), "install libnats-dev")
        self.assertEqual(self.files(), ["settings.toml"])


if __name__ == "__main__":
    unittest.main()
