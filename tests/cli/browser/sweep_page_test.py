# SPDX-License-Identifier: Apache-2.0
"""A sweep's report in a browser: a click filters, a hover shows, the console stays empty and nothing is loaded.

Usage: sweep_page_test.py GNOMON; exit status 77 where there is no browser.
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import devtools

CUBE = """v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1
f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"""
SPEC = """scenes = ["cube.obj"]
[fixed]
technique = "slb"
res = 32
plane = 32
[axes]
frac_bits = [3, 4, 5]
slope_bits = [3, 4, 5]
"""


class SweepPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.folder.name)
        (folder / "cube.obj").write_text(CUBE)
        (folder / "spec.toml").write_text(SPEC)
        subprocess.run([GNOMON, "sweep", folder / "spec.toml", "-o", folder / "out", "-q"], check=True,
                       stdout=subprocess.DEVNULL)
        cls.page = devtools.Page(CHROMIUM)
        cls.page.open((folder / "out" / "report.html").as_uri())

    @classmethod
    def tearDownClass(cls):
        cls.page.__exit__()
        cls.folder.cleanup()

    def setUp(self):
        self.page.reload()

    def tearDown(self):
        self.assertEqual(self.page.console, [])
        self.assertTrue(self.page.requests)
        self.assertTrue(all(url.startswith(("file:", "data:")) for url in self.page.requests), self.page.requests)

    def count(self):
        return self.page.run("document.getElementById('count').textContent")

    def test_every_point_is_shown(self):
        self.assertIn("9 of 9 points shown", self.count())
        self.assertGreater(self.page.run("document.querySelectorAll('#table tbody tr').length"), 0)
        self.assertIn("theory: -1.00", self.page.run("document.getElementById('slope').textContent"))

    def test_a_click_filters(self):
        button = 'button[data-key="frac_bits"][data-value="4"]'
        self.page.click(button)
        self.assertIn("6 of 9 points shown", self.count())
        self.assertEqual(self.page.run(f"document.querySelector('{button}').getAttribute('aria-pressed')"), "false")
        commands = self.page.run("[...document.querySelectorAll('#table code')].map((e) => e.textContent)")
        self.assertTrue(commands)
        self.assertFalse(any("frac_bits=4" in command for command in commands))
        self.page.click(button)
        self.assertIn("9 of 9 points shown", self.count())

    def test_a_hover_shows_configuration_and_command(self):
        self.assertTrue(self.page.run("document.getElementById('tip').hidden"))
        self.page.middle_of("#front .u-over")
        left, top, width, height = self.page.run(
            "(() => { const b = document.querySelector('#front .u-over').getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })()")
        shown = False
        for step in range(40 * 30):
            x, y = step % 40, step // 40
            self.page.hover(left + (x + 0.5) * width / 40, top + (y + 0.5) * height / 30)
            shown = not self.page.run("document.getElementById('tip').hidden")
            if shown:
                break
        self.assertTrue(shown, "no point under the pointer anywhere")
        text = self.page.run("document.getElementById('tip').textContent")
        for part in ("frac_bits", "slope_bits", "memory, bits of the formats", "gnomon run", "--set"):
            self.assertIn(part, text)
        self.page.hover(2, 2)
        self.page.wait_for("document.getElementById('tip').hidden")

    def test_another_figure_is_drawn(self):
        self.page.run("(() => { const s = document.getElementById('y'); s.value = 'errors.fixed.all.share';"
                      " s.dispatchEvent(new Event('change')); })()")
        self.assertIn("mislabelled voxels", self.page.run("document.querySelector('#table thead').textContent"))

    def test_the_front_takes_a_third_figure(self):
        points = "document.querySelectorAll('#table tbody tr').length"
        before = self.page.run(points)
        self.assertEqual(self.page.run("document.getElementById('z').value"), "")
        self.page.run("(() => { const s = document.getElementById('z'); s.value = 'errors.fixed.all.share';"
                      " s.dispatchEvent(new Event('change')); })()")
        self.assertIn("mislabelled voxels", self.page.run("document.querySelector('#table thead').textContent"))
        self.assertGreaterEqual(self.page.run(points), before)


if __name__ == "__main__":
    GNOMON = sys.argv.pop(1)
    CHROMIUM = devtools.find_chromium()
    if CHROMIUM is None:
        print("skipped: no browser (Debian package chromium)")
        sys.exit(77)
    unittest.main(verbosity=2)
