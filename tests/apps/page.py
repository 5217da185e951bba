# SPDX-License-Identifier: MIT
"""Pages (-o NAME.html) in headless Chromium, as a reader has them: what is drawn, measured and said, by
mouse and by keys, dark and light. Skipped where Chromium, its driver or Selenium are missing."""
import json
import shutil
import sys
import tempfile
import unittest

from command import CommandTest

NEEDED = "chromium, chromium-driver and python3-selenium (scripts/setup.sh, large_packages)"
try:
    import browser
except ImportError as missing:
    print(f"skipped: {missing}; the test needs {NEEDED}")
    sys.exit(77)
if not (shutil.which("chromium") and shutil.which("chromedriver")):
    print(f"skipped: the test needs {NEEDED}")
    sys.exit(77)


class PageTest(CommandTest):
    @classmethod
    def setUpClass(cls):
        cls.profile = tempfile.mkdtemp(prefix="asterism-browser-")
        cls.addClassCleanup(shutil.rmtree, cls.profile, True)
        cls.driver = browser.start(cls.profile)
        cls.addClassCleanup(cls.driver.quit)

    def open(self, name, fragment=""):
        browser.open_page(self.driver, self.folder / name, fragment)
        errors = [line["message"] for line in self.driver.get_log("browser") if line["level"] == "SEVERE"]
        self.assertEqual(errors, [])

    def text(self, name):
        return self.driver.find_element("id", name).text

    def ask(self, script):
        return self.driver.execute_script("return " + script)

    def make(self, *more):
        done = self.run_command("mesh", "square", "--metric", "swirl:12", "--size", "0.2",
                                "-o", "a.mesh", "-o", "a.html", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / "a.certificate.json").read_text())

    def test_numbers_are_the_certificates(self):
        claim = self.make()
        self.open("a.html")
        self.assertTrue(self.text("verdict").startswith("Certified"))
        self.assertIn(claim["mesh"]["fingerprint"], self.text("again"))
        self.assertIn("asterism verify a.mesh --certificate a.certificate.json", self.text("again"))
        self.assertEqual(self.ask("asterism.claim"), claim)
        asked = self.text("asked")
        whole = [cell.get_attribute("title") for cell in self.driver.find_elements("css selector", "#asked td")]
        self.assertIn(f"{claim['audit']['worst_angle']:.12g}"[:12], [text[:12] for text in whole])
        shown = float(asked.split("Least angle")[1].split("degrees")[1])
        self.assertLessEqual(shown, claim["audit"]["worst_angle"])
        self.assertGreater(shown, claim["audit"]["worst_angle"] - 1e-4)
        self.assertIn("degrees, the same", asked)
        self.assertAlmostEqual(self.ask("asterism.mesh.angles.worst.degrees"), claim["audit"]["worst_angle"], 9)
        lengths = self.ask("[asterism.mesh.lengths.edges, asterism.mesh.lengths.unit]")
        self.assertAlmostEqual(lengths[1] / lengths[0], claim["measured"]["unit_edges"], 12)
        self.assertEqual(self.ask("asterism.mesh.angles.bins.reduce((a, b) => a + b, 0)"),
                         9 * claim["mesh"]["triangles"])

    def test_the_picture_is_not_blank_in_any_colouring(self):
        self.make()
        self.open("a.html")
        pictures = set()
        for i in range(len(self.driver.find_elements("css selector", "#mode option"))):
            browser.choose(self.driver, "mode", i)
            browser.repaint(self.driver)
            colours = browser.colours_of_canvas(self.driver)
            self.assertGreater(len(colours), 3, i)
            pictures.add(frozenset(colours.items()))
        self.assertGreaterEqual(len(pictures), 3)

    def test_a_click_gives_nine_angles_three_tensors_and_the_witness(self):
        self.make()
        self.open("a.html")
        browser.click_middle(self.driver)
        chosen = self.text("chosen")
        self.assertRegex(chosen, r"Triangle [\d,]+ of vertices \d+, \d+, \d+; region 1; least angle")
        rows = self.driver.find_elements("css selector", "#chosen table:nth-of-type(1) tbody tr")
        self.assertEqual([len(row.find_elements("css selector", "td")) for row in rows], [3, 3, 3])
        least = min(float(cell.text.rstrip("°")) for row in rows for cell in row.find_elements("css selector", "td"))
        self.assertAlmostEqual(least, float(chosen.split("least angle ")[1].split()[0]), 2)
        self.assertEqual(len(self.driver.find_elements("css selector", "#chosen table:nth-of-type(2) thead th")), 4)
        self.assertEqual(len(self.driver.find_elements("css selector", "#chosen table:nth-of-type(2) tbody tr")), 8)
        self.assertIn("No finding names it.", chosen)

    def test_keys_do_what_the_mouse_does(self):
        self.make()
        self.open("a.html")
        canvas = self.driver.find_element("id", "canvas")
        scale = self.ask("asterism.stage.camera.scale")
        canvas.send_keys("+")
        self.assertAlmostEqual(self.ask("asterism.stage.camera.scale"), 1.5 * scale, 9)
        x = self.ask("asterism.stage.camera.x")
        canvas.send_keys(browser.RIGHT)
        self.assertGreater(self.ask("asterism.stage.camera.x"), x)
        canvas.send_keys(browser.ENTER)
        self.assertIn("least angle", self.text("chosen"))
        canvas.send_keys(browser.ESCAPE)
        self.assertEqual(self.text("chosen"), "None chosen.")
        canvas.send_keys("n")
        self.assertIn(f"Triangle {self.ask('asterism.mesh.angles.worst.triangle + 1'):,}", self.text("chosen"))
        canvas.send_keys("0")
        self.assertAlmostEqual(self.ask("asterism.stage.camera.scale"), scale, 9)
        for _ in range(20):
            canvas.send_keys("+")
        browser.repaint(self.driver)
        self.assertGreater(self.ask("asterism.stage.ellipses"), 0)

    def settled(self):
        for _ in range(200):
            if not self.driver.execute_async_script(
                    "setTimeout(() => arguments[0](asterism.stage.pictures.busy), 50)") and self.ask(
                    "asterism.stage.pictures.shows(asterism.stage.camera)"):
                return
        self.fail("the picture is not there after ten seconds")

    def test_a_slow_picture_is_moved_and_then_drawn_as_it_is(self):
        """As of a million triangles: the exact picture comes in slices, and is the one drawn at once."""
        self.make()
        self.open("a.html")
        self.ask("asterism.stage.pictures.quick = () => false")
        for change in ("camera.zoom(3)", "camera.move(90, 40)", "camera.zoom(0.2)"):
            self.ask(f"asterism.stage.{change}, asterism.stage.move()")
            self.assertGreater(len(browser.colours_of_canvas(self.driver)), 3, change)
            self.settled()
            found = browser.colours_of_canvas(self.driver)
            browser.repaint(self.driver)
            self.assertEqual(found, browser.colours_of_canvas(self.driver), change)
        browser.choose(self.driver, "mode", 1)
        self.settled()
        found = browser.colours_of_canvas(self.driver)
        browser.repaint(self.driver)
        self.assertEqual(found, browser.colours_of_canvas(self.driver))

    def on_a_screen(self, width, height):
        browser.resize(self.driver, width, height)
        self.addCleanup(browser.resize, self.driver)
        self.open("a.html")

    def test_two_fingers_zoom_and_one_scrolls_the_page(self):
        self.make()
        self.on_a_screen(390, 844)
        camera = "[asterism.stage.camera.scale, asterism.stage.camera.x, asterism.stage.camera.y]"
        before = self.ask(camera)
        browser.touch(self.driver, [[(150, 400), (250, 400)], [(130, 400), (270, 400)], [(100, 400), (300, 400)]])
        after = self.ask(camera)
        self.assertAlmostEqual(after[0], 2 * before[0], 6)
        self.assertEqual(self.ask("scrollY"), 0)
        browser.touch(self.driver, [[(150, 400), (250, 400)], [(170, 380), (270, 380)], [(190, 360), (290, 360)]])
        moved = self.ask(camera)
        self.assertAlmostEqual(moved[0], after[0], 6)
        self.assertAlmostEqual(moved[1], after[1] - 40 / after[0], 6)
        self.assertAlmostEqual(moved[2], after[2] - 40 / after[0], 6)
        self.assertEqual(self.ask("scrollY"), 0)
        self.assertEqual(self.text("chosen"), "None chosen.")
        browser.touch(self.driver, [[(200, 400)]])
        self.assertIn("least angle", self.text("chosen"))
        browser.touch(self.driver, [[(200, y)] for y in range(500, 200, -20)])
        self.assertGreater(self.ask("scrollY"), 100)
        self.assertEqual(self.ask(camera), moved)

    def test_ellipses_are_as_large_as_their_distance_allows(self):
        self.make()
        self.open("a.html")
        canvas_width = self.ask("asterism.stage.camera.width")
        for _ in range(8):
            self.assertGreater(self.ask("asterism.stage.ellipses"), 0)
            longest, gap = self.ask("[asterism.stage.longestEllipse, asterism.stage.ellipseGap]")
            self.assertLessEqual(longest, 0.601 * gap)
            self.assertGreater(longest, 0.2 * gap)
            self.assertGreaterEqual(gap, canvas_width / 18)
            self.ask("asterism.stage.camera.zoom(1.7), asterism.stage.paint()")

    def test_the_mouse_is_told_what_it_is_over_and_how_long_things_are(self):
        self.make()
        self.open("a.html")
        browser.hover_middle(self.driver)
        hover = self.driver.execute_async_script(
            "requestAnimationFrame(() => requestAnimationFrame(() => arguments[0](document.getElementById('hover').innerText)))")
        self.assertRegex(hover, r"Triangle \d+\nangles [\d.]+° to [\d.]+°\nlength over width [\d.]+\nat ")
        length, pixels = self.ask("[Number(document.getElementById('scale').textContent),"
                                  " parseFloat(document.getElementById('scale').style.width)]")
        self.assertAlmostEqual(length * self.ask("asterism.stage.camera.scale"), pixels, 3)

    def test_without_webgl_a_plain_canvas_draws(self):
        self.make()
        without = ("const kind = HTMLCanvasElement.prototype, get = kind.getContext;"
                   "kind.getContext = function (what, ...more) { return what === '2d' ? get.call(this, what, ...more) : null; };")
        added = self.driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": without})
        try:
            self.open("a.html")
            for _ in range(2):
                seen = self.ask("new Set(document.getElementById('canvas').getContext('2d')"
                                ".getImageData(200, 100, 300, 200).data).size")
                self.assertGreater(seen, 10)
                self.ask("asterism.stage.pictures.quick = () => false")
                self.ask("asterism.stage.camera.zoom(2), asterism.stage.move()")
                self.settled()
        finally:
            self.driver.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", added)

    def test_everything_has_a_name_for_those_who_do_not_see_it(self):
        self.make()
        self.open("a.html")
        named = "button, select, input, canvas[role], svg, section, table"
        for one in filter(lambda e: e.is_displayed(), self.driver.find_elements("css selector", named)):
            self.assertTrue(one.accessible_name, one.get_attribute("outerHTML")[:200])
        canvas = self.driver.find_element("id", "canvas")
        self.assertRegex(canvas.accessible_name, r"The mesh: \d+ vertices, \d+ triangles")
        self.assertEqual(self.driver.find_element("id", "chosen").get_attribute("aria-live"), "polite")
        self.assertEqual(len(self.driver.find_elements("css selector", "h1")), 1)

    def test_dark_and_light_both_have_contrast(self):
        self.make()
        self.open("a.html")
        papers = []
        for _ in range(2):
            paper, ink = (browser.luminance(self.driver, f"getComputedStyle(document.body).{name}")
                          for name in ("backgroundColor", "color"))
            lighter, darker = max(paper, ink), min(paper, ink)
            self.assertGreater((lighter + 0.05) / (darker + 0.05), 7)
            papers.append(paper)
            self.driver.find_element("id", "theme").click()
            browser.repaint(self.driver)
        self.assertGreater(max(papers), 0.8)
        self.assertLess(min(papers), 0.05)

    def test_what_is_refused_says_so_and_its_witnesses_lead_to_places(self):
        self.make()
        lines = (self.folder / "a.mesh").read_text().splitlines()
        start = lines.index("Triangles") + 2
        a, b, c, r = lines[start].split()
        lines[start] = " ".join([a, c, b, r])
        self.write("bad.mesh", "\n".join(lines) + "\n")
        self.write("bad.sol", (self.folder / "a.sol").read_text())
        done = self.run_command("certify", "bad.mesh", "-o", "bad.html")
        self.assertEqual(done.returncode, 1)
        self.assertEqual([f for f in self.files() if f.startswith("bad.")], ["bad.html", "bad.mesh", "bad.sol"])
        self.open("bad.html")
        self.assertTrue(self.text("verdict").startswith("NOT certified"))
        places = self.text("places")
        self.assertIn("Findings: triangles that turn clockwise or are flat (1)", places)
        self.assertIn("Triangle 1 of vertex", places)
        self.assertLess(places.index("turn clockwise"), places.index("Findings that may follow from those"))
        self.assertNotRegex(places + self.text("asked"), r"\w_\w")
        self.assertIn("1 triangles that turn clockwise or are flat", self.text("verdict"))
        self.assertEqual(self.ask("asterism.mesh.count - [...Array(asterism.mesh.count).keys()]"
                                  ".filter((t) => asterism.stage.mode.of(t) === 0).length"), 1)
        self.open("bad.html", "#triangle=1")
        self.assertIn("Witnesses:", self.text("chosen"))

    def test_a_picture_of_files_claims_what_their_certificate_does_and_no_more(self):
        self.make()
        self.assertEqual(self.run_command("draw", "a.mesh", "-o", "b.html").returncode, 0)
        self.open("b.html")
        self.assertTrue(self.text("verdict").startswith("Certified"))
        self.assertIn("which this page did not prove again", self.text("asked"))
        (self.folder / "a.certificate.json").unlink()
        self.assertEqual(self.run_command("draw", "a.mesh", "-o", "c.html").returncode, 0)
        self.open("c.html")
        self.assertTrue(self.text("verdict").startswith("Not judged"))


if __name__ == "__main__":
    unittest.main()
