# SPDX-License-Identifier: Apache-2.0
"""What the tests of the command share: running it in a folder of its own, and small solids as files."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

DONE, REFUSED, USAGE, FILE_TROUBLE, OUT_OF_TIME = range(5)
CUBE_FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def corners(low, high):
    return [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]


def off(vertices, faces):
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0"]
    lines += [" ".join(repr(c) for c in v) for v in vertices]
    lines += [" ".join(map(str, (len(f), *f))) for f in faces]
    return "\n".join(lines) + "\n"


def box(low, high):
    return off(corners(low, high), CUBE_FACES)


def open_box():
    return off(corners((0, 0, 0), (1, 1, 1)), CUBE_FACES[:5])


class CommandTest(unittest.TestCase):
    """A folder with a.off = [0, 2]^3, b.off = [1, 3]^3, far.off, open.off (no lid), rubbish.off, and a.txt, an edge that
    grows."""

    quoin = ""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.write("a.off", box((0, 0, 0), (2, 2, 2)))
        self.write("b.off", box((1, 1, 1), (3, 3, 3)))
        self.write("far.off", box((9, 9, 9), (10, 10, 10)))
        self.write("open.off", open_box())
        self.write("a.txt", "0 0\n0 1\n1 0 1\n")
        self.write("rubbish.off", "OFF\n3 1 0\n0 0 0\n")

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def read(self, name):
        return (self.folder / name).read_bytes()

    def run_quoin(self, *words, stdin=None, code=DONE):
        """The finished process; its output is text. The exit code must be `code`, if that is not None."""
        done = subprocess.run([self.quoin, *words], input=stdin, capture_output=True, text=True, timeout=120,
                              cwd=self.folder)
        if code is not None:
            self.assertEqual(done.returncode, code, f"{words}: {done.stdout[:500]}{done.stderr[:500]}")
        return done

    def json_of(self, *words, stdin=None, code=DONE):
        return json.loads(self.run_quoin(*words, "--json", stdin=stdin, code=code).stdout)

    def info(self, name):
        return self.json_of("info", name)

    def assert_keys(self, json_object, keys):
        self.assertEqual([k for k in keys.split() if k not in json_object], [], f"missing in {list(json_object)}")


def main():
    CommandTest.quoin = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main(verbosity=1)
