# SPDX-License-Identifier: Apache-2.0
"""bash and zsh offer the commands and, after each command, the long options that --help prints. Exits with 77 without zsh.

    check_completion.py QUOIN SOURCE_DIR
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

quoin, source = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
FOLDER = source / "scripts/completion"
SKIPPED = 77
TELL_MATCHES = r'source "$1"; COMP_WORDS=("${@:2}"); COMP_CWORD=$(($# - 2)); _quoin; printf "%s\n" "${COMPREPLY[@]}"'


def output_of(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True, **options)
    return done.stdout


def help_of(*words):
    return output_of(quoin, *words, "--help")


def offered_by_bash(cases, folder):
    return [set(output_of("bash", "-c", TELL_MATCHES, "bash", FOLDER / "quoin.bash", "quoin", *words, cwd=folder).split())
            for words in cases]


def offered_by_zsh(cases, folder):
    lines = [" ".join(["quoin", *words]) for words in cases]
    text = output_of("zsh", "-f", source / "tests/completion/matches.zsh", FOLDER, *lines, cwd=folder)
    return [set(part.split()) for part in re.findall(r"((?:.+\n)*)\n", text)]


def differences(shell, offered, folder):
    commands = set(re.findall(r"^  ([a-z][a-z-]*) {2,}", help_of().split("Subcommands:")[1], re.M))
    cases = [(("",), commands), (("in",), {c for c in commands if c.startswith("in")})]
    for name in sorted(commands):
        cases.append(((name, "--"), set(re.findall(r"--[a-z-]+", help_of(name).split("Options:")[1]))))
    cases.append((("info", ""), {"cube.off"}))
    found_of = offered([words for words, _ in cases], folder)
    assert len(found_of) == len(cases), f"{shell} answers {len(found_of)} of {len(cases)} lines"
    for (words, expected), found in zip(cases, found_of):
        if words == ("",):
            found = {f for f in found if not f.startswith("-")}
        if found != expected:
            yield f"{shell}, {' '.join(words)!r}: missing {sorted(expected - found)}, too many {sorted(found - expected)}"


def main():
    shells = {"bash": offered_by_bash, "zsh": offered_by_zsh}
    there = [shell for shell in shells if shutil.which(shell)]
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "cube.off").touch()
        wrong = [text for shell in there for text in differences(shell, shells[shell], folder)]
    print("\n".join(wrong) or f"right in {' and '.join(there)}")
    if wrong:
        return 1
    return 0 if len(there) == len(shells) else SKIPPED


sys.exit(main())
