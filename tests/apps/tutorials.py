# SPDX-License-Identifier: MIT
"""The commands of the tutorials work as they stand, what they quote is in the files quoted, and they make the
pictures that the pages show (scripts/make-tutorial-pictures keeps these)."""
import unittest

import command
import tutorial_steps


class Tutorials(command.CommandTest):
    def follow(self, name):
        kinds = [kind for kind, _, _ in tutorial_steps.FENCE.findall(tutorial_steps.text_of(name))]
        self.assertGreater(kinds.count("sh"), 2)
        for picture in tutorial_steps.follow(name, self.folder, command.PROGRAM):
            self.assertTrue((tutorial_steps.TUTORIALS / "figures" / picture).is_file(), picture)

    def test_engineer(self):
        self.follow("engineer.md")
        said = (self.folder / "channel.certificate.json").read_text()
        self.assertRegex(said, '"repair-done": "within .*1 crossings made vertices')

    def test_predicate_tester(self):
        self.follow("predicate_tester.md")

    def test_mesh_generator_author(self):
        self.follow("mesh_generator_author.md")


if __name__ == "__main__":
    unittest.main()
