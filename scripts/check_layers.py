#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails when a file includes a room that quoin/layers.txt puts above its own."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s+"quoin/([^/"]+)/')


def rooms_in_order():
    lines = (ROOT / "quoin" / "layers.txt").read_text().splitlines()
    return [line.strip() for line in lines if line.strip() and not line.startswith("#")]


def violations(order):
    rank = {room: i for i, room in enumerate(order)}
    for path in sorted((ROOT / "quoin").rglob("*.*")):
        if path.suffix not in (".h", ".cc"):
            continue
        room = path.relative_to(ROOT / "quoin").parts[0]
        if room not in rank:
            yield f"{path.relative_to(ROOT)}: room '{room}' is not in quoin/layers.txt"
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            if match is None:
                continue
            other = match.group(1)
            # A test may use generators and oracles of higher rooms.
            if path.name.endswith("_test.cc"):
                continue
            if rank.get(other, len(order)) > rank[room]:
                yield f"{path.relative_to(ROOT)}:{number}: '{room}' may not include '{other}'"


found = list(violations(rooms_in_order()))
print("\n".join(found))
sys.exit(1 if found else 0)
