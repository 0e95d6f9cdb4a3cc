#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Which sources can be compiled as one: prints "group:path" a line, for the sources named on standard input, a line each.

    cmake/unity_groups.py DIRECTORY MOST < SOURCES

Sources of one folder of DIRECTORY, at most MOST. No two define the same name for themselves, none defines what a
header defines that another sees, and all have the same using-directives. So each means what it means by itself. Reads
formatted sources: what begins in the first column is a member of the namespaces that are open there."""
import pathlib
import re
import sys

from open_namespaces import members

USING_DIRECTIVE = re.compile(r"^using namespace [^;]*;", re.MULTILINE)
INCLUDE = re.compile(r'^\s*#\s*include\s+"(quoin/[^"]+)"', re.MULTILINE)
OF_THE_FILE = re.compile(r"^(?:using|#\s*define|const|static|namespace \w+ =)")
BROUGHT_IN = re.compile(r"^using [\w:]*::(\w+);")
NAMED = [
    re.compile(r"^(?:template <.*> )?(?:struct|class|union|enum(?: class)?) (?:alignas\(\w+\) )?([A-Za-z]\w*)"),
    re.compile(r"^using ([A-Za-z]\w*) ="),
    BROUGHT_IN,
    re.compile(r"^namespace (\w+) = "),
    re.compile(r"^concept ([A-Za-z]\w*) ="),
    re.compile(r"^#\s*define (\w+)"),
    re.compile(r"^[A-Za-z_\[][^()=]*?\b([A-Za-z_]\w*)(?:\[\w*\])*(?: = |\{|;|\()"),
]
NO_DEFINITION = re.compile(r"^(?:$|[ }#/)]|template\b(?!.*> (?:struct|class))|namespace \{|public:|private:|TEST|INSTANTIATE|static_assert|extern)")


def name_of(line):
    if line.startswith("#") or not NO_DEFINITION.match(line):
        for form in NAMED:
            if found := form.match(line):
                return found[1]
    return None


def names(text, everywhere):
    """Of what is defined in namespaces without a name or, if `everywhere`, in those that have one: with its first line."""
    return {name: line for line, _, namespaces in members(text.splitlines())
            if (everywhere or None in namespaces or OF_THE_FILE.match(line)) and (name := name_of(line))}


class Headers:
    """Of the project: what the ones that a source reaches define."""

    def __init__(self, directory):
        self.root = directory.parent
        self.reached = {}
        self.defined = {}

    def reach(self, text):
        """Paths of all headers that a text includes, one way or another."""
        all_of_them = set()
        for path in INCLUDE.findall(text):
            if path not in self.reached:
                self.reached[path] = set()
                header = self.root / path
                if header.exists():
                    inner = header.read_text(encoding="utf-8")
                    self.defined[path] = names(inner, True)
                    self.reached[path] = {path} | self.reach(inner)
            all_of_them |= self.reached[path]
        return all_of_them

    def names(self, text):
        return {name: line for path in sorted(self.reach(text)) for name, line in self.defined[path].items()}


def differ(some, others):
    """Whether there is a name in both that is not the same alias."""
    return any(some[name] != others[name] or not some[name].startswith("using ") for name in some.keys() & others.keys())


def new_names(own):
    """Without those that only bring in what a header defines."""
    return {name: line for name, line in own.items() if not BROUGHT_IN.match(line)}


def can_stand_with(own, seen, others):
    """Whether a source that defines `own` for itself and sees `seen` of headers can be compiled with those."""
    return not any(differ(own, other_own) or differ(new_names(own), other_seen) or differ(new_names(other_own), seen)
                   for other_own, other_seen in others)


def groups(sources, directory, most):
    """Lists of sources; greedy, so that a change moves few."""
    headers = Headers(directory)
    open_groups = {}
    for source in sources:
        text = (directory / source).read_text(encoding="utf-8")
        own, seen = names(text, False), headers.names(text)
        directives = frozenset(USING_DIRECTIVE.findall(text))
        here = open_groups.setdefault((pathlib.Path(source).parts[0], directives), [])
        for group, contents in here:
            if len(group) < most and can_stand_with(own, seen, contents):
                group.append(source)
                contents.append((own, seen))
                break
        else:
            here.append(([source], [(own, seen)]))
    return [group for here in open_groups.values() for group, _ in here if len(group) > 1]


def main():
    directory, most = pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2])
    sources = [line.strip() for line in sys.stdin if line.strip()]
    for number, group in enumerate(groups(sources, directory, most)):
        for source in group:
            print(f"{number}:{source}")


if __name__ == "__main__":
    main()
