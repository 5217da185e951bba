# SPDX-License-Identifier: MIT
"""Pages (-o NAME.html) in headless Chromium, as a reader has them: what is drawn, measured and said, by
mouse and by keys, dark and light. Skipped where Chromium, its driver or Selenium are missing."""
import json
import math
import shutil
import tempfile
import unittest

from browser_or_skip import browser
from command import CommandTest, section


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
        """Draws as for a million triangles: the exact picture is drawn in slices, and equals the one drawn at once."""
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

    def test_the_legend_is_in_the_window_and_the_whole_mesh_in_the_picture(self):
        self.make()
        self.write_solution()
        done = self.run_command("adapt", "a.mesh", "--solution", "u.sol", "--field", "1", "--vertices", "400", "-o", "b.html")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in "a.html", "b.html":
            for width, height in (1280, 720), (1920, 1080):
                with self.subTest(f"{name} at {width} x {height}"):
                    browser.resize(self.driver, width, height)
                    self.addCleanup(browser.resize, self.driver)
                    self.open(name)
                    self.assertLessEqual(self.ask("document.getElementById('keys').getBoundingClientRect().bottom"), height)
                    wide, high = self.ask("(({ camera: c, mesh: { box: b } }) => [(b.x1 - b.x0) * c.scale / c.width,"
                                          " (b.y1 - b.y0) * c.scale / c.height])(asterism.stage)")
                    self.assertLessEqual(max(wide, high), 0.9401)

    def test_a_size_that_nobody_asked_for_is_not_told(self):
        self.make()
        for more, told in ((), ""), (("--size", "0.2"), "swirl:12, of which a length of 1 is 0.2"):
            done = self.run_command("certify", "a.mesh", "--metric", "swirl:12", *more, "-o", "c.html")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.open("c.html")
            self.assertNotIn("Size", self.text("asked"))
            self.assertIn(told, self.text("asked"))

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

    def test_ellipses_left_out_are_told(self):
        done = self.run_command("mesh", "square", "--metric", "swirl:12", "--size", "0.06", "-o", "a.html")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.open("a.html")
        self.assertGreater(self.ask("asterism.mesh.vertices"), 2000)
        self.assertEqual(self.ask("asterism.stage.ellipses"), 0)
        self.assertIn("none while more than 2,000 vertices are in sight", self.text("scaled"))
        self.driver.find_element("id", "ellipses").click()
        browser.repaint(self.driver)
        self.assertEqual(self.text("scaled"), "")
        self.driver.find_element("id", "ellipses").click()
        self.ask("asterism.stage.camera.zoom(20), asterism.stage.paint()")
        self.assertIn("the metric's unit circles", self.text("scaled"))

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
        self.assertIn("Triangle 1 of vertices", places)
        self.assertLess(self.ask("document.body.innerText.indexOf('Places to look at')"),
                        self.ask("document.body.innerText.indexOf('Asked and delivered')"))
        self.assertFalse(self.ask("document.getElementById('ellipses').checked"))
        self.assertLess(places.index("turn clockwise"), places.index("Findings that may follow from those"))
        self.assertEqual(self.ask("document.querySelectorAll('#places details[open] ul.long').length"), 1)
        self.assertEqual(self.ask("[...document.querySelectorAll('#places ul')].filter((list) => "
                                  "list.scrollHeight > list.clientHeight + 1).length"), 0)
        self.assertNotRegex(places + self.text("asked"), r"\w_\w")
        self.assertIn("first of all, triangles that turn clockwise or are flat (1).", self.text("verdict"))
        self.assertEqual(self.ask("asterism.mesh.count - [...Array(asterism.mesh.count).keys()]"
                                  ".filter((t) => asterism.stage.mode.of(t) === 0).length"), 1)
        self.open("bad.html", "#triangle=1")
        self.assertIn("Witnesses:", self.text("chosen"))

    def write_solution(self, name="u.sol", height=1.0):
        """On a.mesh: a scalar, and a vector whose length is 5."""
        lines = (self.folder / "a.mesh").read_text().split("\n")
        start, count = section(lines, "Vertices")
        at = [tuple(map(float, line.split()[:2])) for line in lines[start:start + count]]
        self.write(name, f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices {count}\n2 1 2\n"
                   + "".join(f"{height * math.tanh(8 * (x + y))!r} 3 4\n" for x, y in at) + "End\n")

    def counts(self):
        return self.ask("[asterism.mesh.vertices, asterism.mesh.count]")

    def test_a_solution_is_shown_before_and_after_adaptation(self):
        self.make()
        self.write_solution()
        done = self.run_command("adapt", "a.mesh", "--solution", "u.sol", "--field", "1", "--vertices", "400", "-o", "b.html")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.open("b.html")
        self.assertEqual(self.ask("asterism.stage.mode.name"), "solution: 1")
        self.assertGreater(len(browser.colours_of_canvas(self.driver)), 50)
        buttons = self.driver.find_elements("css selector", "#frames button")
        self.assertEqual([one.text for one in buttons], ["Before", "Adapted"])
        after, camera = self.counts(), self.ask("[asterism.stage.camera.x, asterism.stage.camera.scale]")
        self.driver.find_element("id", "canvas").send_keys(",")
        self.assertEqual(buttons[0].get_attribute("aria-pressed"), "true")
        self.assertNotEqual(self.counts(), after)
        self.assertEqual(self.counts()[0], self.ask("asterism.facts.frames[0].vertices"))
        self.assertEqual(self.ask("asterism.stage.mode.name"), "solution: 1")
        self.assertEqual(self.ask("[asterism.stage.camera.x, asterism.stage.camera.scale]"), camera)
        browser.hover_middle(self.driver)
        hover = self.driver.execute_async_script(
            "requestAnimationFrame(() => requestAnimationFrame(() => arguments[0](document.getElementById('hover').innerText)))")
        self.assertRegex(hover, r"\n1 -?[\d.e-]+\n2, length 5\n2.x 3\n2.y 4\nat ")
        browser.click_middle(self.driver)
        self.assertIn("2.y", self.text("chosen"))
        buttons[1].click()
        self.assertEqual(self.counts(), after)
        self.assertEqual(self.text("chosen"), "None chosen.")
        self.assertTrue(self.text("verdict").startswith("Certified"))
        rows = self.driver.find_elements("css selector", "#compared tbody tr")
        self.assertEqual(len(rows), 2)
        self.assertIn(f"{after[0]:,}", rows[1].text)

    def test_a_field_has_one_scale_in_all_rounds_of_a_loop(self):
        self.make()
        for round_ in range(4):
            self.write(f"r{round_}.mesh", (self.folder / "a.mesh").read_text())
            self.write_solution(f"r{round_}.sol", 1.0 + round_)
        meshes = [f"r{i}.mesh" for i in range(4)]
        done = self.run_command("draw", *meshes, "-o", "loop.html")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.open("loop.html")
        self.assertTrue(self.text("verdict").startswith("Not judged"))
        self.assertIn("no metric", self.text("asked"))
        slider = self.driver.find_element("id", "frame")
        self.assertEqual((slider.get_attribute("min"), slider.get_attribute("max")), ("1", "4"))
        legend = self.ask("document.getElementById('colours').innerText")
        self.assertRegex(legend, r"solution: 1\s+-?[\d.]+\s+[34]")
        seen = self.driver.execute_async_script("""
            const done = arguments[0], play = document.getElementById("play"), seen = [];
            const look = () => seen.push([document.getElementById("framed").textContent, document.getElementById("colours").innerText]);
            new MutationObserver(look).observe(document.getElementById("framed"), { childList: true });
            play.click();
            const wait = () => (play.textContent === "Play" ? done(seen) : setTimeout(wait, 50));
            wait();""")
        self.assertEqual([name for name, _ in seen], ["r0", "r1", "r2", "r3"])
        self.assertEqual({colours for _, colours in seen}, {legend})

    def test_a_domain_is_shown_as_it_was_before_it_was_repaired(self):
        self.write("crossed.poly", "5 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 0 1\n5 -0.1 0.5\n6 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n"
                   "5 5 3 5\n6 5 1 6\n0\n")
        done = self.run_command("mesh", "crossed.poly", "--repair-domain", "--size", "0.3", "-o", "a.mesh", "-o", "a.html")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.open("a.html")
        meshed = browser.colours_of_canvas(self.driver)
        self.driver.find_elements("css selector", "#frames button")[0].click()
        self.assertEqual(self.counts(), [5, 0])
        outline = browser.colours_of_canvas(self.driver)
        self.assertGreater(len(outline), 1)
        self.assertTrue(outline != meshed)
        self.assertIn("There are no triangles.", self.text("angles"))
        self.assertIn("Repairs of the domain", self.text("places"))
        self.assertEqual(self.run_command("draw", "crossed.poly", "-o", "b.html").returncode, 0)
        self.open("b.html")
        self.assertEqual(self.counts(), [5, 0])

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
