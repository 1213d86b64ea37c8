#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The generator of the register views: what it writes, what it finds stale, what it refuses."""
import subprocess
import tempfile
import unittest
from pathlib import Path

REGISTERS = Path(__file__).resolve().parents[3] / "sim" / "registers"
VIEWS = ["rtl/system/gnomon_registers_pkg.sv", "sim/registers/registers.hpp", "firmware/driver/gnomon_registers.h", "docs/registers.md"]

TWO_REGISTERS = """
[[block]]
name = "b"
title = "B"
base = 0
doc = ""
[[block.register]]
name = "A"
offset = 0
access = "rw"
reset = 0
doc = ""
field = [{name = "X", bits = "3:0", doc = ""}, {name = "Y", bits = "7:4", doc = ""}]
[[block.register]]
name = "B"
offset = 4
access = "ro"
reset = 0
doc = ""
"""


class Generator(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)

    def run_generator(self, *options):
        return subprocess.run([REGISTERS / "generate", "--root", self.root, *options], capture_output=True, text=True)

    def refused(self, old, new):
        self.assertIn(old, TWO_REGISTERS)
        source = self.root / "source.toml"
        source.write_text(TWO_REGISTERS.replace(old, new, 1))
        result = self.run_generator("--source", source)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        return result.stderr

    def test_writes_what_it_finds_up_to_date(self):
        self.assertEqual(self.run_generator().returncode, 0)
        self.assertEqual(self.run_generator("--check").returncode, 0)

    def test_names_each_stale_or_missing_view(self):
        self.assertEqual(self.run_generator().returncode, 0)
        for view in VIEWS:
            text = (self.root / view).read_text()
            for change in (lambda p: p.write_text(text + " "), lambda p: p.unlink()):
                change(self.root / view)
                result = self.run_generator("--check")
                self.assertEqual(result.returncode, 1)
                self.assertEqual([line.split(":")[0] for line in result.stderr.splitlines()], [view])
            (self.root / view).write_text(text)

    def test_a_changed_source_makes_every_view_stale(self):
        self.assertEqual(self.run_generator().returncode, 0)
        source = self.root / "source.toml"
        source.write_text((REGISTERS / "registers.toml").read_text().replace("offset = 0x04C", "offset = 0x05C", 1))
        result = self.run_generator("--check", "--source", source)
        self.assertEqual(len(result.stderr.splitlines()), len(VIEWS), result.stderr)

    def test_refuses_sources_that_make_no_sense(self):
        self.assertIn("b.A.Y: overlaps", self.refused('"7:4"', '"7:3"'))
        self.assertIn("31:0", self.refused('"7:4"', '"32:4"'))
        self.assertIn("A is at 0x0", self.refused("offset = 4", "offset = 0"))
        self.assertIn("not a word", self.refused("offset = 4", "offset = 6"))
        self.assertIn("not a word", self.refused("offset = 4", "offset = 4096"))
        self.assertIn("access is one of", self.refused('"ro"', '"wo"'))
        self.assertIn("two registers", self.refused('name = "B"', 'name = "A"'))
        self.assertIn("outside its fields", self.refused("reset = 0", "reset = 256"))
        self.assertIn("unknown key colour", self.refused('reset = 0\ndoc = ""\n', 'reset = 0\ndoc = ""\ncolour = 1\n'))
        self.assertIn("no doc", self.refused('reset = 0\ndoc = ""\n', "reset = 0\n"))

    def test_hardware_tools_read_the_package(self):
        module = self.root / "user.sv"
        module.write_text("module user(output logic [31:0] id);\n  assign id = gnomon_registers_pkg::GNOMON_ID_RESET;\nendmodule\n")
        package = REGISTERS.parents[1] / "rtl" / "system" / "gnomon_registers_pkg.sv"
        commands = (["verilator", "--lint-only", "-Wall", package, module],
                    ["yosys", "-q", "-p", f"read_verilog -sv {package} {module}; prep -top user"])
        for command in commands:
            result = subprocess.run(command, capture_output=True, text=True)
            self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)


if __name__ == "__main__":
    unittest.main()
