# SPDX-License-Identifier: MIT
"""The commands of the tutorials work as they stand, what they quote is in the files quoted, and they make the
pictures that the pages show (scripts/make-tutorial-pictures keeps these)."""
import re
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

    def test_messages_are_those_of_the_program(self):
        table = re.search(r"^\| the message says .*?\n\n", tutorial_steps.text_of("engineer.md"), re.M | re.S)[0]
        sources = "".join(path.read_text(encoding="utf-8") for folder in ("apps", "mesh")
                          for path in (tutorial_steps.TOP / folder).rglob("*.cpp"))
        said = re.sub(r'"\s*\n\s*"', "", sources)
        for row in table.strip().splitlines()[2:]:
            for message in re.findall(r"`([^`]*)`", row.split("|")[1]):
                for part in re.split(r"\bN\b", message):
                    self.assertIn(part.strip(), said, message)

    def test_predicate_tester(self):
        self.follow("predicate_tester.md")

    def test_surfaces(self):
        self.follow("surfaces.md")

    def test_mesh_generator_author(self):
        self.follow("mesh_generator_author.md")


if __name__ == "__main__":
    unittest.main()
