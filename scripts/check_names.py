#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""No two files define a type or concept of one qualified name: the linker would take one for the other without a word.

Reads the formatted sources in quoin/: what begins in the first column is a member of the namespaces that are open there.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "cmake"))

from open_namespaces import members  # noqa: E402

TYPE = re.compile(r"^(?:struct|class|union|enum(?: class)?) ([A-Z]\w*)(?: final)?(?: :(?!:).*| \{.*)?$")
CONCEPT = re.compile(r"^concept ([A-Z]\w*) =")


def definitions(lines):
    """(qualified name, line number) of every type that is neither declared only, nor a specialization, nor of one file."""
    for line, number, namespaces in members(lines):
        if (found := TYPE.match(line) or CONCEPT.match(line)) and None not in namespaces:
            yield "::".join([*namespaces, found[1]]), number


def main():
    places = {}
    for path in sorted([*ROOT.glob("quoin/**/*.h"), *ROOT.glob("quoin/**/*.cc")]):
        for name, number in definitions(path.read_text(encoding="utf-8").splitlines()):
            places.setdefault(name, {}).setdefault(str(path.relative_to(ROOT)), number)
    shared = {name: where for name, where in places.items() if len(where) > 1}
    for name, where in sorted(shared.items()):
        print(f"{name} is defined in " + " and in ".join(f"{file}:{line}" for file, line in where.items()))
    return 1 if shared else 0


if __name__ == "__main__":
    sys.exit(main())
