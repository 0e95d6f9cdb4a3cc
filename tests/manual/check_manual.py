# SPDX-License-Identifier: Apache-2.0
"""Every command and option that --help prints stands in the man page, the manual and both completions.

    check_manual.py QUOIN SOURCE_DIR
"""
import pathlib
import re
import subprocess
import sys

quoin, source = sys.argv[1], pathlib.Path(sys.argv[2])
DOCUMENTS = ["docs/man/quoin.1", "docs/command.md", "scripts/completion/quoin.bash", "scripts/completion/_quoin"]


def help_of(*words):
    return subprocess.run([quoin, *words, "--help"], capture_output=True, text=True, check=True).stdout


def main():
    commands = re.findall(r"^  ([a-z-]+) {2,}", help_of().split("Subcommands:")[1], re.M)
    options = set()
    for name in commands:
        options |= set(re.findall(r"--[a-z-]+", help_of(name).split("Options:")[1]))
    options.discard("--help")
    missing = []
    for document in DOCUMENTS:
        text = (source / document).read_text().replace("\\-", "-")
        missing += [f"{document}: command {c}" for c in commands if not re.search(rf"\b{c}\b", text)]
        missing += [f"{document}: option {o}" for o in sorted(options)
                    if o not in text and not (document.endswith("command.md") and o in ("--output", "--quiet", "--verbose"))]
    if len(commands) < 10 or len(options) < 10:
        missing.append("the help text was not understood")
    print("\n".join(missing) or f"{len(commands)} commands and {len(options)} options are documented")
    return 1 if missing else 0


sys.exit(main())
