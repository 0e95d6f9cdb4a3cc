# SPDX-License-Identifier: Apache-2.0
"""Exit codes, errors and streams of every command.

    check_usage.py QUOIN
"""
import json
import os
import pathlib
import subprocess
import unittest

from command import FILE_TROUBLE, OUT_OF_TIME, REFUSED, USAGE, CommandTest, main

COMMANDS = {"union": ["a.off", "b.off"], "intersection": ["a.off", "b.off"], "difference": ["a.off", "b.off"],
            "xor": ["a.off", "b.off"], "csg": ["x|y", "x=a.off", "y=b.off"], "info": ["a.off"], "check": ["a.off"],
            "repair": ["a.off"], "convert": ["a.off"], "view": ["a.off", "-o", "v.off"],
            "classify": ["a.off", "--point", "1,1,1"], "section": ["a.off", "--plane", "0,0,1,1"],
            "interfere": ["a.off", "b.off"], "hull": ["a.off", "b.off"], "minkowski": ["a.off", "b.off"],
            "erode": ["a.off", "b.off"], "decompose": ["a.off", "-o", "p.off"],
            "distance": ["a.off", "b.off"], "width": ["a.off"], "gaussian-map": ["a.off"], "assembly": ["a.off", "far.off"],
            "homology": ["a.off"], "persistence": ["a.txt"],
            "delaunay": ["a.off"], "voronoi": ["a.off"], "alpha": ["a.off"],
            "flow": ["a.off", "--stable", "2"]}
DRAWERS = ("section", "persistence")  # which write svg alone
TRIANGULATORS = ("delaunay", "voronoi", "alpha", "flow")  # which write vtk and some meshes
MAKERS = ("union", "intersection", "difference", "xor", "csg", "repair", "convert", "view", "hull", "minkowski", "erode")


def with_file(words, name):
    """The words of a command, about another file."""
    return [w.replace("a.off", name).replace("a.txt", name) for w in words]


class Usage(CommandTest):
    def test_help_names_every_command(self):
        text = self.run_quoin("--help").stdout
        for command in COMMANDS:
            self.assertIn(f"\n  {command} ", text)
            self.run_quoin(command, "--help")
        self.assertRegex(self.run_quoin("--version").stdout, r"^quoin \d+\.\d+\.\d+\n$")

    def test_common_mistakes(self):
        for command, words in COMMANDS.items():
            self.run_quoin(command, code=USAGE)
            for mistake in (["--no-such-option"], ["--weld", "-1"], ["--weld", "nan"], ["--timeout", "nan"],
                            ["--timeout", "0"], ["--timeout", "x"], ["--threads", "-1"], ["--threads", "1.5"],
                            ["--seed", "-1"], ["--seed"]):
                self.run_quoin(command, *words, *mistake, code=USAGE)
        self.run_quoin(code=USAGE)
        self.run_quoin("no-such-command", code=USAGE)

    def test_outputs_are_refused_before_anything_is_read(self):
        for command in MAKERS:
            words = [w.replace("a.off", "missing.off") for w in COMMANDS[command]]
            for mistake in (["-o", "x.foo"], ["-o", "x"], ["-o", "x.svg"], ["-o", "-", "--format", "foo"],
                            ["-o", "x.off", "--format", "off"], ["--format", "off"], ["-o", "-", "-o", "-"]):
                self.run_quoin(command, *words, *mistake, code=USAGE)
        self.assertEqual(sorted(p.name for p in self.folder.glob("x*")), [])

    def test_mistakes_of_csg(self):
        for words in (["x"], ["x", "a.off"], ["x", "=a.off"], ["x", "x="], ["x", "x=a.off", "x=b.off"],
                      ["x|z", "x=missing.off"], ["x|", "x=missing.off"]):
            done = self.run_quoin("csg", *words, code=USAGE)
            self.assertTrue(done.stderr)

    def test_standard_input_named_twice(self):
        for words in (["union", "-", "-"], ["csg", "x|y", "x=-", "y=-"], ["classify", "-", "--points", "-"],
                      ["info", "-", "a.off", "-"], ["interfere", "-", "-"], ["distance", "-", "a.off", "--path", "-"]):
            self.assertIn("named twice", self.run_quoin(*words, stdin="", code=USAGE).stderr)

    def test_errors_as_json(self):
        cases = [(["union", "a.off", "open.off"], REFUSED), (["union", "a.off", "missing.off"], FILE_TROUBLE),
                 (["csg", "x |", "x=a.off"], USAGE), (["union", "a.off", "-o", "x.foo"], USAGE),
                 (["classify", "a.off"], USAGE), (["union"], USAGE), (["section", "a.off", "--plane", "1"], USAGE),
                 (["union", "a.off", "b.off", "--timeout", "1e-9"], OUT_OF_TIME), (["repair", "open.off"], REFUSED)]
        for words, code in cases:
            done = self.run_quoin(*words, "--json", code=code)
            report = json.loads(done.stdout)
            self.assertEqual(report["exit_code"], code)
            self.assertTrue(report["error"])
            self.assertTrue(done.stderr)
        done = self.run_quoin("union", "open.off", "-o", "-", "--json", code=REFUSED)
        self.assertEqual((done.stdout, json.loads(done.stderr)["exit_code"]), ("", REFUSED))


class Codes(CommandTest):
    def test_bad_geometry(self):
        for command, words in COMMANDS.items():
            if command not in ("hull", "homology", *TRIANGULATORS):  # which take what bounds no solid
                self.run_quoin(command, *with_file(words, "open.off"), code=REFUSED)
            self.run_quoin(command, *with_file(words, "rubbish.off"), code=REFUSED)

    def test_missing_files_and_folders(self):
        (self.folder / "folder.off").mkdir()
        for command, words in COMMANDS.items():
            for name in ("missing.off", "missing.qsolid", "folder.off"):
                done = self.run_quoin(command, *with_file(words, name), code=FILE_TROUBLE)
                self.assertIn(name, done.stderr)

    def test_unwritable_outputs(self):
        for command in MAKERS:
            for name in ("no/such/folder.off", "no/such/folder.qsolid"):
                self.run_quoin(command, *COMMANDS[command], "-o", name, code=FILE_TROUBLE)
        for command in DRAWERS:
            self.run_quoin(command, *COMMANDS[command], "-o", "no/such.svg", code=FILE_TROUBLE)
        for command in TRIANGULATORS:
            for name in ("no/such.vtk", "no/such.ply"):
                self.run_quoin(command, *COMMANDS[command], "-o", name, code=FILE_TROUBLE)

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no /dev/full")
    def test_full_devices(self):
        for ending in ("off", "obj", "stl", "ply", "qsolid", "svg", "vtk"):
            (self.folder / f"full.{ending}").symlink_to("/dev/full")
        for command, words in COMMANDS.items():
            endings = (["svg"] if command in DRAWERS else ["off", "obj", "ply", "vtk"] if command in TRIANGULATORS
                       else ["off", "obj", "stl", "ply", "qsolid"])
            if command in (*MAKERS, *DRAWERS, *TRIANGULATORS):
                if command == "voronoi":  # all cells are infinite, and an OBJ of none is empty
                    endings.remove("obj")
                for ending in endings:
                    self.run_quoin(command, *words, "-o", f"full.{ending}", code=FILE_TROUBLE)
            for more in ([], ["--json"], *([["-o", "-"]] if command in (*MAKERS, *DRAWERS, *TRIANGULATORS) else [])):
                with open("/dev/full", "w", encoding="ascii") as full:
                    done = subprocess.run([self.quoin, command, *words, *more], stdout=full, stderr=subprocess.PIPE,
                                          cwd=self.folder, timeout=60, check=False)
                self.assertEqual(done.returncode, FILE_TROUBLE, (command, more, done.stderr))

    def test_out_of_time(self):
        for command, words in COMMANDS.items():
            done = self.run_quoin(command, *words, "--timeout", "1e-9", code=OUT_OF_TIME)
            self.assertIn("out of time", done.stderr)


class Streams(CommandTest):
    def test_meshes_in_and_out(self):
        text = self.read("a.off").decode()
        done = self.run_quoin("union", "-", "b.off", "-o", "-", stdin=text)
        self.assertTrue(done.stdout.startswith("OFF"))
        self.assertIn("rounding", done.stderr)
        self.assertEqual(self.json_of("info", "-", stdin=done.stdout)["volume"], 15)
        done = self.run_quoin("csg", "x-y", "x=a.off", "y=-", "-o", "-", "-q", stdin=self.read("b.off").decode())
        self.assertEqual(self.json_of("info", "-", stdin=done.stdout)["volume"], 7)
        self.assertEqual(done.stderr, "")

    def test_the_report_goes_to_standard_error(self):
        done = self.run_quoin("union", "a.off", "b.off", "-o", "-", "--json")
        self.assertEqual(json.loads(done.stderr)["result"]["volume"], 15)
        self.assertTrue(done.stdout.startswith("OFF"))

    def test_formats_of_standard_output(self):
        for name in ("off", "obj", "stl", "ply", "qsolid", "OFF", "QSOLID"):
            done = subprocess.run([self.quoin, "union", "a.off", "b.off", "-q", "-o", "-", "--format", name],
                                  capture_output=True, cwd=self.folder, timeout=60, check=True)
            self.run_quoin("union", "a.off", "b.off", "-q", "-o", f"u.{name}")
            self.assertEqual(done.stdout, self.read(f"u.{name}"), name)

    def test_exact_text_is_told_by_its_first_word(self):
        self.run_quoin("union", "a.off", "b.off", "-o", "u.qsolid")
        text = "# exact\n\n" + self.read("u.qsolid").decode()
        self.write("u.txt", text)
        self.write("U.QSOLID", text)
        for words in (["info", "{}"], ["repair", "{}"], ["convert", "{}"], ["union", "{}"], ["csg", "x", "x={}"],
                      ["check", "{}"], ["classify", "{}", "--point", "1,1,1"], ["section", "{}", "--plane", "0,0,1,1"],
                      ["interfere", "{}", "a.off"], ["view", "{}", "-o", "v.off"]):
            for name in ("-", "u.txt", "U.QSOLID"):
                report = self.json_of(*[w.format(name) for w in words], stdin=text if name == "-" else "")
                self.assertEqual((report.get("result") or report).get("volume", 15), 15, words)

    def test_a_named_pipe(self):
        os.mkfifo(self.folder / "pipe")
        self.run_quoin("union", "a.off", "b.off", "-o", "u.qsolid")
        for name in ("u.qsolid", "a.off"):
            with subprocess.Popen([self.quoin, "info", "pipe", "--json"], stdout=subprocess.PIPE,
                                  cwd=self.folder) as process:
                pathlib.Path(self.folder / "pipe").write_bytes(self.read(name))
                self.assertEqual(json.loads(process.communicate(timeout=60)[0])["closed"], True)


if __name__ == "__main__":
    main()
