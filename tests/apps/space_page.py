# SPDX-License-Identifier: MIT
"""Pages about surfaces (`surface -o NAME.html`) in headless Chromium: drawn on a graphics card and without one,
turned by mouse, fingers and keys, and saying what the certificate says. Skipped where Chromium, its driver or
Selenium are missing."""
import json
import shutil
import tempfile
import unittest

from browser_or_skip import browser
from command import CommandTest


class SpacePage(CommandTest):
    def setUp(self):
        super().setUp()
        self.profile = tempfile.mkdtemp(prefix="asterism-browser-")
        self.addCleanup(shutil.rmtree, self.profile, True)

    def start(self):
        self.driver = browser.start(self.profile)
        self.addCleanup(self.driver.quit)

    def open(self, name):
        browser.open_page(self.driver, self.folder / name)
        self.no_errors()

    def no_errors(self):
        errors = [line["message"] for line in self.driver.get_log("browser") if line["level"] == "SEVERE"]
        self.assertEqual(errors, [])

    def make(self, *more, status=0):
        done = self.run_command("surface", *more, "-o", "s.html", "-o", "s.mesh")
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return json.loads((self.folder / "s.certificate.json").read_text())

    def text(self, name):
        return self.driver.find_element("id", name).text

    def ask(self, script):
        return self.driver.execute_script("return " + script)

    def picture(self):
        """Returns the pixels as a text."""
        browser.repaint(self.driver)
        return self.ask('document.getElementById("canvas").toDataURL()')

    def test_what_it_says_is_what_was_proved(self):
        claim = self.make("octant", "--chord", "0.05")
        self.start()
        self.open("s.html")
        self.assertTrue(self.text("verdict").startswith("Certified"))
        self.assertIn("asterism verify s.mesh", self.text("again"))
        self.assertEqual(self.text("colours"), "1 patch")
        browser.resize(self.driver, 1280, 720)
        self.assertLessEqual(self.ask("document.getElementById('keys').getBoundingClientRect().bottom"), 720)
        browser.resize(self.driver)
        table = dict(self.ask("asterism.facts.table"))
        self.assertEqual(table["vertices"], str(claim["vertices"]))
        self.assertEqual(table["triangles"], str(claim["triangles"]))
        self.assertAlmostEqual(float(table["distance proved, both ways"]), claim["distance"], delta=1e-6)
        self.assertEqual(self.ask("asterism.corners.count"), claim["triangles"])
        self.assertIn(table["distance proved, both ways"], self.text("asked"))

    def test_a_mesh_that_is_not_certified_is_not_called_so(self):
        self.make("saddle", "--chord", "0.001", "--vertices", "20", status=1)
        self.start()
        self.open("s.html")
        self.assertTrue(self.text("verdict").startswith("Not certified"))

    def test_it_is_drawn_turned_and_coloured_on_a_card(self):
        self.make("teapot", "--chord", "0.3")
        self.start()
        self.open("s.html")
        self.assertTrue(self.ask("asterism.stage.isOnCard"))
        pictures = {self.picture()}
        for mode in range(3):
            browser.choose(self.driver, "mode", mode)
            browser.repaint(self.driver)
            self.assertGreater(len(browser.colours_of_canvas(self.driver)), 10, mode)
            pictures.add(self.picture())
        self.assertEqual(len(pictures), 3)
        first = self.picture()
        self.driver.find_element("id", "canvas").send_keys(browser.RIGHT)
        turned = self.picture()
        self.assertNotEqual(turned, first)
        browser.touch(self.driver, [[(400, 400)], [(450, 420)]])
        self.assertNotEqual(self.picture(), turned)
        browser.touch(self.driver, [[(400, 400), (500, 400)], [(350, 400), (550, 400)]])
        self.assertGreater(self.ask("asterism.stage.turning.zoom"), 1.5)
        self.driver.find_element("id", "whole").click()
        self.assertEqual(self.picture(), first)
        self.driver.find_element("id", "theme").click()
        self.assertNotEqual(self.picture(), first)
        self.no_errors()

    def test_it_is_drawn_without_a_card(self):
        self.make("octant", "--chord", "0.05")
        self.start()
        self.driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": """
            const original = HTMLCanvasElement.prototype.getContext;
            HTMLCanvasElement.prototype.getContext = function(kind, ...more) {
              return kind === "webgl2" ? null : original.call(this, kind, ...more);
            };"""})
        self.open("s.html")
        self.assertFalse(self.ask("asterism.stage.isOnCard"))
        first = self.picture()
        self.driver.find_element("id", "canvas").send_keys(browser.RIGHT)
        self.assertNotEqual(self.picture(), first)
        colours = self.ask("""(() => {
            const canvas = document.getElementById("canvas"), found = new Set();
            const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
            for (let i = 0; i < pixels.length; i += 28) found.add(pixels.slice(i, i + 3).join());
            return found.size; })()""")
        self.assertGreater(colours, 10)
        self.no_errors()


if __name__ == "__main__":
    unittest.main()
