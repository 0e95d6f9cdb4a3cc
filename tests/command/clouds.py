# SPDX-License-Identifier: Apache-2.0
"""What tests of commands about points share: clouds, and VTK read back."""
import random

CUBE = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]


def text_of(points, separator=" "):
    return "".join(separator.join(map(repr, p)) + "\n" for p in points)


def cloud(count, dimension, seed=1, grid=None):
    source = random.Random(seed)
    number = (lambda: source.randrange(grid)) if grid else source.random
    return [tuple(number() for _ in range(dimension)) for _ in range(count)]


def determinant(rows):
    if len(rows) == 1:
        return rows[0][0]
    return sum((-1) ** k * rows[0][k] * determinant([r[:k] + r[k + 1:] for r in rows[1:]]) for k in range(len(rows)))


def read_vtk(text):
    """Points, cells with their types, and the arrays by name."""
    words = text.split("\n", 4)[4].split()
    at = 0
    count = int(words[1])
    assert words[0] == "POINTS" and words[2] == "double"
    numbers = [float(w) for w in words[3:3 + 3 * count]]
    points = list(zip(numbers[0::3], numbers[1::3], numbers[2::3]))
    at = 3 + 3 * count
    assert words[at] == "CELLS"
    count, size = int(words[at + 1]), int(words[at + 2])
    raw = [int(w) for w in words[at + 3:at + 3 + size]]
    cells, i = [], 0
    for _ in range(count):
        cells.append(raw[i + 1:i + 1 + raw[i]])
        i += 1 + raw[i]
    assert i == size
    at += 3 + size
    assert words[at] == "CELL_TYPES" and int(words[at + 1]) == count
    types = [int(w) for w in words[at + 2:at + 2 + count]]
    at += 2 + count
    arrays = {}
    length = 0
    while at < len(words):
        if words[at] in ("POINT_DATA", "CELL_DATA"):
            length = int(words[at + 1])
            assert length == (len(points) if words[at] == "POINT_DATA" else count)
            at += 2
        elif words[at] == "SCALARS":
            arrays[words[at + 1]] = [float(w) for w in words[at + 6:at + 6 + length]]
            at += 6 + length
        elif words[at] in ("NORMALS", "COLOR_SCALARS"):
            width = 3 if words[at] == "NORMALS" else 4
            numbers = [float(w) for w in words[at + 3:at + 3 + width * length]]
            arrays[words[at + 1]] = [tuple(numbers[k:k + width]) for k in range(0, len(numbers), width)]
            at += 3 + width * length
        else:
            raise AssertionError(words[at])
    return points, list(zip(types, cells)), arrays
