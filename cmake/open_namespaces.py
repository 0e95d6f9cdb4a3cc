# SPDX-License-Identifier: Apache-2.0
"""Which namespaces are open at a line of a formatted source: what begins in the first column is a member of them."""
import re

OPENED = re.compile(r"^(?:inline )?namespace ?([\w:]*) \{")
CLOSED = re.compile(r"^\}  // (?:inline )?namespace")


def members(lines):
    """(line, its number from 1, names of the namespaces open there, None for one without) of all that open or close none."""
    open_namespaces = []
    for number, line in enumerate(lines, 1):
        if opened := OPENED.match(line):
            open_namespaces.append(opened[1] or None)
        elif not CLOSED.match(line):
            yield line, number, tuple(open_namespaces)
        elif open_namespaces:
            open_namespaces.pop()
