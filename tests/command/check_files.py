# SPDX-License-Identifier: Apache-2.0
"""What the command says about files, and what it writes into them: rounding, polygons, repairs.

    check_files.py QUOIN
"""
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

QUOIN = sys.argv[1]
CUBE = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
failures = []


def expect(holds, what):
    if not holds:
        failures.append(what)


def write_off(path, vertices, faces):
    lines = [f"OFF\n{len(vertices)} {len(faces)} 0"]
    lines += [" ".join(map(repr, v)) for v in vertices]
    lines += [" ".join(map(str, (len(f), *f))) for f in faces]
    path.write_text("\n".join(lines) + "\n")


def write_box(path, lo, hi):
    write_off(path, [tuple((lo, hi)[c][k] for k, c in enumerate(v)) for v in CUBE], QUADS)


def write_prism(path, outline):
    n = len(outline)
    vertices = [(*p, z) for z in (0, 1) for p in outline]
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    write_off(path, vertices, [tuple(reversed(range(n))), tuple(range(n, 2 * n)), *sides])


def run(*words):
    return subprocess.run([QUOIN, *map(str, words)], capture_output=True, text=True)


def report(*words):
    return json.loads(run(*words, "--json").stdout)


def face_sizes(path):
    lines = path.read_text().split("\n")
    vertices, faces = map(int, lines[1].split()[:2])
    return sorted(int(line.split()[0]) for line in lines[2 + vertices:2 + vertices + faces])


def triangles_in_stl(path):
    return struct.unpack("<I", path.read_bytes()[80:84])[0]


def check_rounding(folder):
    write_box(folder / "far.off", (1e9,) * 3, (1e9 + 1,) * 3)
    write_box(folder / "sheet.off", (0, 0, 1), (1, 1, 1 + 1e-9))
    write_box(folder / "cube.off", (0, 0, 0), (1, 1, 1))
    write_box(folder / "near.off", (1 + 1e-9, 0, 0), (2, 1, 1))
    out = folder / "out.stl"
    for words, before, after in [(("convert", "far.off"), 1, 0), (("convert", "sheet.off"), 1, 0),
                                 (("union", "cube.off", "near.off"), 2, 1), (("union", "far.off", "sheet.off"), 2, 0)]:
        words = [words[0], *(folder / name for name in words[1:]), "-o", out]
        refused = run(*words)
        expect(refused.returncode == 1 and not out.exists(), f"{words}: written without a word")
        expect("rounding changes the solid" in refused.stderr, f"{words}: {refused.stderr}")
        taken = report(*words, "--accept-rounding")
        change = taken["topology_changes"][0]
        expect(taken["rounding"] == "accepted" and taken["max_displacement"] > 0, f"{words}: rounding")
        expect((change["before"]["components"], change["after"]["components"]) == (before, after), f"{words}: {change}")
        expect(taken["result"]["components"] == after, f"{words}: the result is not that of the file")
        expect(taken["result"]["triangles"] == triangles_in_stl(out), f"{words}: triangles")
        out.unlink()
    plain = report("convert", folder / "cube.off", "-o", out)
    expect(plain["rounding"] == "exact" and "topology_changes" not in plain, "a cube is exact in an STL file")


def check_polygons(folder):
    write_box(folder / "cube.off", (0, 0, 0), (1, 1, 1))
    write_box(folder / "drill.off", (0.25, 0.25, -1), (0.75, 0.75, 2))
    write_prism(folder / "arrow.off", [(0, 0), (2, 1), (0, 2), (0.75, 1)])
    write_prism(folder / "gear.off", [(4, 0), (1, 1), (0, 4), (-1, 1), (-4, 0), (-1, -1), (0, -4), (1, -1)])
    holed = [3] * 16 + [4] * 8
    for words, sizes in [(("convert", "cube.off"), [4] * 6), (("convert", "arrow.off"), [4] * 6),
                         (("convert", "gear.off"), [4] * 8 + [8] * 2), (("difference", "cube.off", "drill.off"), holed)]:
        words = [words[0], *(folder / name for name in words[1:])]
        made = report(*words, "-o", folder / "out.off", "-o", folder / "out.obj", "-o", folder / "out.ply", "-o",
                      folder / "out.stl")["result"]
        expect(face_sizes(folder / "out.off") == sizes, f"{words}: {face_sizes(folder / 'out.off')}")
        expect(triangles_in_stl(folder / "out.stl") == made["triangles"], f"{words}: an STL file holds triangles")
        for name in ("out.off", "out.obj", "out.ply", "out.stl"):
            read = report("info", folder / name)
            for key in ("vertices", "edges", "faces", "shells", "components", "exact_volume", "area"):
                expect(read[key] == made[key], f"{words}, {name}: {key} is {read[key]}, was {made[key]}")
            expect(report("check", folder / name)["valid"], f"{words}, {name}: not valid")


def check_repairs(folder):
    path = folder / "bad.off"
    write_off(path, [*CUBE, (0, 0, 0.5), (9, 9, 9)], [*QUADS, (0, 1, 8)])
    made = report("repair", path, "-o", folder / "good.off")
    expect([r["faces"] for r in made["repairs"]] == [[6]], f"the face on a line: {made['repairs']}")
    expect(made["result"]["exact_volume"] == "1", "the repaired cube")
    isolated = report("check", path)["diagnosis"]["isolated_vertices"]
    expect(isolated == {"count": 1, "elements": [9]}, f"isolated vertices: {isolated}")
    rows, columns = 5, 4
    vertex = lambda i, j: i % rows * columns + (columns - j if i == rows else j) % columns
    quads = [(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1))
             for i in range(rows) for j in range(columns)]
    write_off(path, [(i, 1.25 * j, (i * i + 3 * j * j) % 7) for i in range(rows) for j in range(columns)], quads)
    expect("fit no orientation" in run("check", path).stdout, "a Klein bottle is named")
    refused = run("repair", path, "-o", folder / "klein_repaired.off")
    expect(refused.returncode == 1 and "no orientation fits" in refused.stderr, f"a Klein bottle: {refused.stderr}")


def main():
    for check in (check_rounding, check_polygons, check_repairs):
        with tempfile.TemporaryDirectory() as folder:
            check(pathlib.Path(folder))
    print("\n".join(failures) or "files hold what the command says")
    return 1 if failures else 0


sys.exit(main())
