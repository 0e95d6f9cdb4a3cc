# SPDX-License-Identifier: Apache-2.0
"""What the scripts share that run our programs beside their peers: builds, processes, the best of rounds, tables."""
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "peers"


def add_options(parser, rounds=3, limit=100):
    parser.add_argument("--rounds", type=int, default=rounds, help="processes of each program")
    parser.add_argument("--limit", type=int, default=limit, help="seconds for one process")
    parser.add_argument("--no-build", action="store_true")
    parser.add_argument("--write-readme", action="store_true", help="put the table between its marks in README.md")


def build(ours, peers):
    """Peers are built where their libraries are found."""
    subprocess.run(["cmake", "--preset", "peers"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", BUILD, "--target", *ours], check=True, stdout=subprocess.DEVNULL)
    for peer in peers:
        subprocess.run(["cmake", "--build", BUILD, "--target", peer], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def run(program, words, limit):
    """What a program printed, or a word that says why there is nothing."""
    path = BUILD / "bench" / program
    if not path.exists():
        return "not built"
    try:
        done = subprocess.run([path, *map(str, words)], capture_output=True, text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return f"> {limit} s"
    if done.returncode != 0:
        print(done.stderr, file=sys.stderr)
        return "failed"
    return json.loads(done.stdout.strip().splitlines()[-1])


def best_of_rounds(commands, rounds, limit, keys=("seconds",)):
    """For each command, a program and its words, what it printed in the first round, with the least of `keys` over all
    rounds; or a word, where it failed once or did not end. Rounds alternate between the commands."""
    results = [None] * len(commands)
    for _ in range(rounds):
        for i, (program, words) in enumerate(commands):
            if isinstance(results[i], str):
                continue
            result = run(program, words, limit)
            if results[i] is None or isinstance(result, str):
                results[i] = result
                continue
            for key in (key for key in keys if key in result):
                results[i][key] = min(results[i][key], result[key])
    return results


def bytes_per_point(result):
    """Of the peak, beyond what the process held with its input."""
    return (result["peak_kb"] - result["before_kb"]) * 1024 / result["points"]


def print_table(lines, name, is_for_readme):
    """Prints each line as it comes; then puts them into the README, between the marks of this name."""
    printed = []
    for line in lines:
        printed.append(line)
        print(line, flush=True)
    if not is_for_readme:
        return
    begin, end = f"<!-- {name}:begin -->", f"<!-- {name}:end -->"
    readme = ROOT / "README.md"
    old = readme.read_text()
    if old.count(begin) != 1 or old.count(end) != 1:
        sys.exit(f"README.md has no block between {begin} and {end}")
    head, rest = old.split(begin)
    readme.write_text(head + begin + "\n" + "\n".join(printed) + "\n" + end + rest.split(end)[1])
