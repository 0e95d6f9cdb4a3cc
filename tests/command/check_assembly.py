# SPDX-License-Identifier: Apache-2.0
"""quoin assembly: known assemblies, limits, files, and what is refused.

    check_assembly.py QUOIN
"""
import json
import pathlib
import subprocess
import sys
import zipfile

from command import DONE, FILE_TROUBLE, OUT_OF_TIME, REFUSED, USAGE, CommandTest, box, corners, main, off, CUBE_FACES

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "assembly"


def obj(objects):
    """Objects of boxes: {name: [(low, high), ...]}, a group for each box."""
    lines, first = [], 1
    for name, boxes in objects.items():
        lines.append(f"o {name}")
        for k, (low, high) in enumerate(boxes):
            lines.append(f"g piece{k}")
            lines += ["v {} {} {}".format(*v) for v in corners(low, high)]
            lines += ["f " + " ".join(str(first + i) for i in face) for face in CUBE_FACES]
            first += 8
    return "\n".join(lines) + "\n"


RELATIONSHIPS = """<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Id="m" Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>"""


def mesh_3mf(low, high):
    triangles = [t for a, b, c, d in CUBE_FACES for t in ((a, b, c), (a, c, d))]
    return ("<mesh><vertices>" + "".join('<vertex x="{}" y="{}" z="{}"/>'.format(*v) for v in corners(low, high)) +
            "</vertices><triangles>" + "".join('<triangle v1="{}" v2="{}" v3="{}"/>'.format(*t) for t in triangles) +
            "</triangles></mesh>")


def write_3mf(path, resources, build, attributes=""):
    model = ('<?xml version="1.0" encoding="UTF-8"?>\n'
             f'<model {attributes} xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">\n'
             f"<resources>\n{resources}\n</resources>\n<build>\n{build}\n</build>\n</model>\n")
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("_rels/.rels", RELATIONSHIPS)
        archive.writestr("3D/3dmodel.model", model)


class Assembly(CommandTest):
    def example(self, name, *words):
        return self.json_of("assembly", str(EXAMPLES / f"{name}.obj"), *words)

    def test_split_star(self):
        report = self.example("split_star", "--sequence")
        self.assertEqual(report["sums"], {"total": 270, "facet": 48, "edge": 48, "vertex": 66, "separated": 108})
        self.assertEqual(report["motion_space"], {"vertices": 14, "edges": 36, "faces": 24})
        names = {(0, 1): "yellow", (0, -1): "turquoise", (1, 1): "purple", (1, -1): "blue", (2, 1): "red",
                 (2, -1): "green"}
        found = {tuple(s["direction"]): set(s["move"]) for s in report["solutions"]}
        self.assertEqual(len(report["solutions"]), 8)
        for x in (-1, 1):
            for y in (-1, 1):
                for z in (-1, 1):
                    self.assertEqual(found[x, y, z], {names[axis, sign] for axis, sign in enumerate((x, y, z))})
        for solution in report["solutions"]:
            self.assertEqual(solution["cell"], "vertex")
            self.assertEqual([float(c) for c in solution["exact"]], solution["direction"])
        self.assertTrue(report["sequence"]["complete"])
        self.assertEqual(len(report["sequence"]["steps"]), 5)
        self.assertEqual(report["infinitesimal"]["stopped"], [])
        self.assert_keys(report["seconds"], "maps reflections sums projections unions motion_space processing")

    def test_pegs(self):
        blind = {(s["move"][0], tuple(s["direction"])) for s in self.example("peg_blind")["solutions"]}
        self.assertEqual(blind, {("peg", (0, 0, 1)), ("block", (0, 0, -1))})
        through = {(s["move"][0], tuple(s["direction"])) for s in self.example("peg_through")["solutions"]}
        self.assertEqual(through, {(name, (0, 0, z)) for name in ("peg", "block") for z in (-1, 1)})

    def test_hooks_are_interlocked_but_loose(self):
        report = self.example("hooks", "--sequence")
        self.assertTrue(report["interlocked"])
        self.assertEqual(report["solutions"], [])
        self.assertEqual(report["sequence"]["interlocked"], [["first", "second"]])
        self.assertFalse(report["sequence"]["complete"])
        stopped = report["infinitesimal"]["stopped"]
        self.assertEqual(len(stopped), report["infinitesimal"]["solution_count"])
        self.assertIn(["first", "second"], stopped[0]["stopped_by"])
        self.assertIn("interlocked", self.run_quoin("assembly", str(EXAMPLES / "hooks.obj")).stdout)

    def test_burr_and_others_come_apart(self):
        self.assertEqual(self.example("burr", "--sequence")["sequence"]["steps"][0]["move"], ["key"])
        for name, steps in (("bracket", 5), ("gearbox", 29)):
            sequence = self.example(name, "--sequence-only")["sequence"]
            self.assertTrue(sequence["complete"])
            self.assertEqual(len(sequence["steps"]), steps)

    def test_limits(self):
        path = str(EXAMPLES / "stack.obj")
        report = self.json_of("assembly", path, "--direction", "0,0,1")
        self.assertNotIn("solutions", report)
        self.assertEqual([s["move"] for s in report["sequence"]["steps"]], [[f"box_{k:02}"] for k in range(10, 1, -1)])
        report = self.json_of("assembly", path, "--sequence-only", "--base", "box_10", "--one-part")
        for step in report["sequence"]["steps"]:
            self.assertEqual(len(step["move"]), 1)
            self.assertNotIn("box_10", step["move"])
        self.assertTrue(report["sequence"]["complete"])
        report = self.json_of("assembly", path, "--limit", "50")
        self.assertFalse(report["all_listed"])
        self.assertLessEqual(len(report["solutions"]), 50)
        self.assertIn("--limit", report["warnings"][0])
        report = self.json_of("assembly", path, "--infinitesimal", "--limit", "3")
        self.assertFalse(report["infinitesimal"]["all_listed"])
        self.assertIn("not all sets that can begin to move are listed", report["warnings"][0])
        text = self.run_quoin("assembly", path, "--infinitesimal", "--limit", "3").stdout
        self.assertIn("can begin to move: more than", text)
        self.assertIn("no part", self.run_quoin("assembly", path, "--base", "lid", code=REFUSED).stderr)
        for mistake in (["--direction", "0,0,0"], ["--direction", "1,2"], ["--direction", "x,0,0"], ["--limit", "-1"],
                        ["--limit", "x"], ["--base"]):
            self.run_quoin("assembly", path, *mistake, code=USAGE)

    def test_pruning_loses_nothing(self):
        for name in ("split_star", "burr"):
            def solutions(report):
                return sorted((s["direction"], s["move"]) for s in report["solutions"])
            self.assertEqual(solutions(self.example(name, "--prune")), solutions(self.example(name)))

    def test_examples_are_what_their_script_makes(self):
        subprocess.run([sys.executable, str(EXAMPLES / "make.py"), str(self.folder)], check=True)
        for path in EXAMPLES.glob("*.obj"):
            self.assertEqual(self.read(path.name), path.read_bytes(), path.name)

    def test_infinitesimal_alone(self):
        report = self.example("split_star", "--infinitesimal")
        self.assertNotIn("solutions", report)
        self.assertEqual(report["infinitesimal"]["solution_count"], 8)

    def test_files_are_parts(self):
        self.write("top.off", box((0, 0, 2), (2, 2, 3)))
        report = self.json_of("assembly", "a.off", "top.off", "--sequence")
        self.assertEqual([p["name"] for p in report["parts"]], ["a", "top"])
        self.assertEqual(report["sequence"]["steps"][0]["move"], ["top"])
        alone = self.json_of("assembly", "a.off", "--sequence")
        self.assertEqual((alone["solutions"], alone["interlocked"], alone["sequence"]["complete"]), ([], False, True))
        self.run_quoin("union", "a.off", "far.off", "-o", "both.qsolid")
        report = self.json_of("assembly", "both.qsolid", "top.off")
        self.assertEqual([p["pieces"] for p in report["parts"]], [2, 1])

    def test_objects_and_groups(self):
        self.write("two.obj", obj({"one": [((0, 0, 0), (1, 1, 1)), ((1, 0, 0), (2, 1, 1))], "two": [((0, 0, 1), (1, 1, 2))]}))
        report = self.json_of("assembly", "two.obj")
        self.assertEqual([(p["name"], p["pieces"]) for p in report["parts"]], [("one", 2), ("two", 1)])
        # A bent part, its pieces as groups, or cut by the command.
        bent = [((0, 0, 0), (2, 1, 1)), ((0, 1, 0), (1, 2, 1))]
        self.write("bent.obj", obj({"bent": bent}))
        self.assertEqual(self.json_of("assembly", "bent.obj")["parts"][0]["pieces"], 2)
        whole = "\n".join(line for line in obj({"bent": bent}).splitlines() if not line.startswith("g "))
        self.write("whole.obj", whole)
        self.assertEqual(self.json_of("assembly", "whole.obj")["parts"][0]["pieces"], 2)
        # Groups that only name faces.
        lines = obj({"box": [((0, 0, 0), (1, 1, 1))]}).splitlines()
        self.write("named.obj", "\n".join(lines[:-2] + ["g lid"] + lines[-2:]))
        self.assertEqual(self.json_of("assembly", "named.obj")["parts"][0]["pieces"], 1)

    def test_3mf_is_as_obj(self):
        boxes = {"low": [((0, 0, 0), (2, 2, 1))], "top": [((0, 0, 1), (1, 2, 2))],
                 "bent": [((1, 0, 1), (2, 2, 2)), ((1, 0, 2), (2, 1, 3))]}
        self.write("three.obj", obj(boxes))
        write_3mf(self.folder / "three.3mf",
                  f'<object id="1" name="low">{mesh_3mf((0, 0, 0), (2, 2, 1))}</object>\n'
                  f'<object id="2" name="top">{mesh_3mf((0, 0, 0), (1, 2, 1))}</object>\n'
                  f'<object id="3">{mesh_3mf((0, 0, 0), (1, 1, 1))}</object>\n'
                  '<object id="4" name="bent"><components>'
                  '<component objectid="2" transform="1 0 0 0 1 0 0 0 1 1 0 0"/>'
                  '<component objectid="3" transform="-1 0 0 0 1 0 0 0 1 2 0 1"/></components></object>',
                  '<item objectid="1"/><item objectid="2" transform="1 0 0 0 1 0 0 0 1 0 0 1"/>'
                  '<item objectid="4" transform="1 0 0 0 1 0 0 0 1 0 0 1"/>')
        plans = [self.json_of("assembly", name, "--sequence") for name in ("three.obj", "three.3mf")]
        self.assertEqual([(p["name"], p["pieces"]) for p in plans[1]["parts"]], [("low", 1), ("top", 1), ("bent", 2)])
        self.assertEqual(plans[1]["warnings"], [])
        for key in ("sums", "motion_space", "solutions", "interlocked", "infinitesimal"):
            self.assertEqual(plans[0][key], plans[1][key], key)
        self.assertEqual(plans[0]["sequence"]["steps"], plans[1]["sequence"]["steps"])
        # Any other command takes it as one mesh.
        self.assertEqual(self.json_of("info", "three.3mf")["volume"], 4 + 2 + 2 + 1)
        self.run_quoin("convert", "three.3mf", "-o", "three.off")
        self.assertIn("not written", self.run_quoin("convert", "a.off", "-o", "out.3mf", code=USAGE).stderr)
        self.assertFalse((self.folder / "out.3mf").exists())

    def test_3mf_that_is_refused(self):
        box_3mf = f'<object id="1">{mesh_3mf((0, 0, 0), (1, 1, 1))}</object>'
        write_3mf(self.folder / "flat.3mf", box_3mf, '<item objectid="1" transform="1 0 0 0 1 0 0 0 0 0 0 0"/>')
        refusal = self.run_quoin("assembly", "flat.3mf", code=REFUSED).stderr
        self.assertIn("flat.3mf: 3D/3dmodel.model:7: the transform flattens space", refusal)
        write_3mf(self.folder / "inch.3mf", box_3mf, '<item objectid="1"/>', 'unit="inch"')
        self.assertIn("the unit of coordinates is inch", self.json_of("assembly", "inch.3mf")["warnings"][0])
        self.assertIn("inch", self.run_quoin("check", "inch.3mf").stderr)
        whole = self.read("inch.3mf")
        for size in (4, 30, len(whole) // 2, len(whole) - 1):
            (self.folder / "cut.3mf").write_bytes(whole[:size])
            self.assertIn("cut.3mf: ", self.run_quoin("info", "cut.3mf", code=REFUSED).stderr)
        # Nothing but zeros, which a small part unpacks to.
        with zipfile.ZipFile(self.folder / "bomb.3mf", "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("3D/3dmodel.model", b"0" * 10**7)
        self.assertIn("there is no element", self.run_quoin("info", "bomb.3mf", code=REFUSED).stderr)

    def test_what_is_wrong_with_a_part_is_said(self):
        inside_out = obj({"a": [((0, 0, 0), (1, 1, 1)), ((0, 0, 8), (1, 1, 9))], "b": [((0, 0, 3), (1, 1, 4))]}).splitlines()
        lid = [k for k, line in enumerate(inside_out) if line.startswith("f ")][6:12]
        for k in lid:
            inside_out[k] = "f " + " ".join(reversed(inside_out[k].split()[1:]))
        for name, lines in (("grouped.obj", inside_out),
                            ("whole.obj", [line for line in inside_out if not line.startswith("g ")])):
            self.write(name, "\n".join(lines))
            warnings = self.json_of("assembly", name, "--sequence")["warnings"]
            self.assertEqual(len(warnings), 1)
            self.assertIn("object 'a': 1 components are inside out", warnings[0])
        # Of a body that is a group of its own, and of a file.
        twice = obj({"a": [((0, 0, 0), (1, 1, 1))], "b": [((0, 0, 3), (1, 1, 4))]}).splitlines()
        twice.insert(twice.index("o b"), "f 1 1 2")
        self.write("twice.obj", "\n".join(twice))
        self.assertIn("degenerate", self.json_of("assembly", "twice.obj")["warnings"][0])
        two = corners((0, 0, 0), (1, 1, 1)) + corners((0, 0, 8), (1, 1, 9))
        self.write("two.off", off(two, [*CUBE_FACES, *(tuple(8 + v for v in reversed(f)) for f in CUBE_FACES)]))
        report = self.json_of("assembly", "two.off", "far.off")
        self.assertIn("two.off: 1 components are inside out", report["warnings"][0])
        self.assertEqual(report["parts"][0]["pieces"], 1)

    def test_the_wall_of_a_cavity_may_be_a_group(self):
        lines = obj({"shell": [((0, 0, 0), (3, 3, 3)), ((1, 1, 1), (2, 2, 2))], "core": [((1, 1, 1), (2, 2, 2))]}).splitlines()
        for k in [k for k, line in enumerate(lines) if line.startswith("f ")][6:12]:
            lines[k] = "f " + " ".join(reversed(lines[k].split()[1:]))
        self.write("hollow.obj", "\n".join(lines))
        report = self.json_of("assembly", "hollow.obj")
        self.assertTrue(report["interlocked"])
        self.assertEqual((report["warnings"], report["parts"][1]["pieces"]), ([], 1))

    def test_bad_parts(self):
        refusal = self.run_quoin("assembly", "a.off", "b.off", code=REFUSED).stderr
        self.assertIn("a and b overlap in a volume of 1", refusal)
        self.assertIn("given twice", self.run_quoin("assembly", "a.off", "./a.off", code=REFUSED).stderr)
        self.assertIn("does not bound a solid", self.run_quoin("assembly", "open.off", code=REFUSED).stderr)
        self.run_quoin("csg", "!a", "a=a.off", "-o", "outside.qsolid")
        self.assertIn("unbounded", self.run_quoin("assembly", "outside.qsolid", code=REFUSED).stderr)
        self.run_quoin("difference", "a.off", "a.off", "-o", "nothing.qsolid")
        self.assertIn("empty", self.run_quoin("assembly", "nothing.qsolid", code=REFUSED).stderr)
        self.run_quoin("assembly", "missing.off", code=FILE_TROUBLE)
        (self.folder / "deep").mkdir()
        self.write("deep/a.off", box((5, 0, 0), (6, 1, 1)))
        self.assertIn("two parts have the name 'a'", self.run_quoin("assembly", "a.off", "deep/a.off", code=REFUSED).stderr)
        report = self.json_of("assembly", "a.off", "b.off", code=REFUSED)
        self.assertEqual(report["exit_code"], REFUSED)

    def test_out_of_time(self):
        self.run_quoin("assembly", str(EXAMPLES / "gearbox.obj"), "--timeout", "0.05", code=OUT_OF_TIME)

    def test_outputs(self):
        path = str(EXAMPLES / "burr.obj")
        self.run_quoin("assembly", path, "--sequence", "-o", "plan.json")
        self.assertEqual(len(json.loads(self.read("plan.json"))["parts"]), 6)
        done = self.run_quoin("assembly", path, "-o", "-")
        self.assertEqual(len(json.loads(done.stdout)["solutions"]), 4)
        self.assertIn("6 parts", done.stderr)
        self.run_quoin("assembly", path, "-o", "plan.stl", code=USAGE)
        self.run_quoin("assembly", path, "-o", "-", "--format", "off", code=USAGE)
        self.run_quoin("assembly", path, "-o", "missing/plan.json", code=FILE_TROUBLE)
        done = self.run_quoin("assembly", path, "--sequence", "-o", "plan.html", code=None)
        if done.returncode != DONE:
            self.assertIn("was not built", done.stderr)
            return
        page = self.read("plan.html")
        for part in (b"quoin-plan", b"quoin-sphere", b"quoin-map", b"stick_x1"):
            self.assertIn(part, page)
        self.run_quoin("assembly", path, "--sequence", "-o", "again.html")
        self.assertEqual(page.replace(b"plan", b""), self.read("again.html").replace(b"plan", b""))


if __name__ == "__main__":
    main()
