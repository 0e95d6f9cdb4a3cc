#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What scripts/tidy looks at, a path a line: every source of quoin/ without its tests, or those that show what has changed.

    scripts/tidy_files.py < CHANGED | --all

CHANGED are changed paths, a line each. A changed source is looked at itself. A changed header is looked at in one source that includes
it, chosen so that few sources show all of them. A source that only instantiates templates has no code of its own: it is looked
at where it shows a header."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s+"(quoin/[^"]+)"', re.MULTILINE)
LEFT_OUT = re.compile(r"//[^\n]*|^\s*#[^\n]*|^(?:\}|(?:inline )?namespace\b[^\n{]*\{)", re.MULTILINE)
INSTANTIATION = re.compile(r"template\b(?!\s*<)|static_assert\b")


def included(path, known):
    """All files of quoin/ that a file reaches."""
    if path not in known:
        known[path] = set()
        for name in INCLUDE.findall((ROOT / path).read_text()):
            if (ROOT / name).exists():
                known[path] |= {name} | included(name, known)
    return known[path]


def only_instantiates(path):
    statements = LEFT_OUT.sub("", (ROOT / path).read_text()).split(";")
    return all(INSTANTIATION.match(s.strip()) for s in statements if s.strip())


def choose(sources, changed):
    known = {}
    chosen = [s for s in sources if s in changed and not only_instantiates(s)]
    shown = set().union(*(included(s, known) for s in chosen))
    rest = {s: included(s, known) & changed - shown for s in sources}
    while any(rest.values()):
        best = max(sources, key=lambda s: (len(rest[s]), not only_instantiates(s)))
        chosen.append(best)
        seen = set(rest[best])
        for left in rest.values():
            left -= seen
    return chosen


def main():
    sources = sorted(str(p.relative_to(ROOT)) for p in (ROOT / "quoin").rglob("*.cc") if not p.name.endswith("_test.cc"))
    if sys.argv[1:] == ["--all"]:
        print("\n".join(sources))
        return
    changed = {line.strip() for line in sys.stdin}
    for path in choose(sources, changed):
        print(path)


if __name__ == "__main__":
    sys.setrecursionlimit(10000)
    main()
