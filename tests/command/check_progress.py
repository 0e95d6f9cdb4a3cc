# SPDX-License-Identifier: Apache-2.0
"""Progress is shown on a terminal, erased before anything else is said, and leaves no escape codes in pipes.

    check_progress.py QUOIN
"""
import os
import pty
import re
import signal
import subprocess
import time

from command import REFUSED, CommandTest, main

STAGE = r"quoin: [a-z -]+"


def drain(terminal):
    pieces = []
    while True:
        try:
            piece = os.read(terminal, 65536)
        except OSError:  # the other end is closed
            break
        if not piece:
            break
        pieces.append(piece)
    return b"".join(pieces).decode().replace("\r\n", "\n")


def seen(text):
    """What stays on the screen: a carriage return goes back, ESC [ K erases the rest of the line."""
    lines = []
    for line in text.split("\n"):
        shown, at = "", 0
        for token in re.findall(r"\r|\x1b\[K|[^\r\x1b]+", line):
            if token == "\r":
                at = 0
            elif token == "\x1b[K":
                shown = shown[:at]
            else:
                shown = shown[:at] + token + shown[at + len(token):]
                at += len(token)
        lines.append(shown)
    return "\n".join(lines)


class Progress(CommandTest):
    def on_terminal(self, *words, stdout_too=True, code=0):
        terminal, other = pty.openpty()
        with subprocess.Popen([self.quoin, *words], stdin=subprocess.DEVNULL, stderr=other, cwd=self.folder,
                              stdout=other if stdout_too else subprocess.PIPE) as process:
            os.close(other)
            text = drain(terminal)
            output = "" if stdout_too else process.stdout.read().decode()
            self.assertEqual(process.wait(timeout=60), code, text)
        os.close(terminal)
        return text, output

    def test_nothing_of_it_stays_on_the_screen(self):
        for words in (["union", "a.off", "b.off", "-o", "x.off"], ["union", "a.off", "b.off", "--json"],
                      ["info", "a.off", "b.off"], ["check", "a.off"], ["classify", "a.off", "--point", "1,1,1"],
                      ["section", "a.off", "--plane", "0,0,1,1"], ["interfere", "a.off", "b.off"],
                      ["convert", "a.off", "-o", "-"], ["union", "a.off", "--weld", "0.1", "-v"]):
            text, _ = self.on_terminal(*words)
            self.assertIn("\x1b[K", text, words)
            self.assertNotRegex(re.sub(r"quoin: warning", "", seen(text)), STAGE, words)
            self.assertTrue(seen(text).strip(), words)

    def test_errors_stand_alone(self):
        text, _ = self.on_terminal("union", "a.off", "open.off", code=REFUSED)
        self.assertTrue(seen(text).startswith("quoin: open.off: does not bound a solid\n"), seen(text))

    def test_the_part_that_is_done(self):
        text, _ = self.on_terminal("union", "a.off", "b.off", "far.off", "a.off")
        self.assertIn("quoin: operands 25 %", text)
        self.assertIn("quoin: operands 75 %", text)

    def test_quiet_shows_none(self):
        self.assertEqual(self.on_terminal("union", "a.off", "b.off", "-q")[0], "")

    def test_standard_output_holds_results_only(self):
        text, output = self.on_terminal("union", "a.off", "b.off", "--json", stdout_too=False)
        self.assertNotIn("\x1b", output)
        self.assertTrue(output.startswith("{"))
        self.assertEqual(seen(text), "")

    def test_no_escape_codes_in_pipes(self):
        for words in (["union", "a.off", "b.off"], ["info", "a.off"], ["check", "open.off", "a.off"]):
            for more in ([], ["-v"], ["--json"], ["-v", "--json"]):
                done = self.run_quoin(*words, *more, code=1 if words[0] == "check" else 0)
                self.assertNotRegex(done.stdout + done.stderr, r"[\r\x1b]")
                self.assertEqual("quoin: reading\n" in done.stderr, "-v" in more, done.stderr)

    def interrupted(self, *words, pipe):
        """What stays on the screen when an interruption comes while quoin waits for a pipe."""
        os.mkfifo(self.folder / pipe)
        terminal, other = pty.openpty()
        with subprocess.Popen([self.quoin, *words], stderr=other, stdout=other, cwd=self.folder) as process:
            os.close(other)
            with open(self.folder / pipe, "w", encoding="ascii"):
                time.sleep(0.1)
                process.send_signal(signal.SIGINT)
                time.sleep(0.1)
            shown = seen(drain(terminal))
            self.assertEqual(process.wait(timeout=60), 4, shown)
        os.close(terminal)
        return shown

    def test_time_is_up_while_it_waits(self):
        command = [self.quoin, "delaunay", "-", "--timeout", "0.2"]
        with subprocess.Popen(command, stdin=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.folder) as process:
            process.stdin.write(b"0 0 0\n")
            process.stdin.flush()
            self.assertEqual(process.wait(timeout=60), 4)

    def test_files_are_replaced_when_the_new_one_is_whole(self):
        points = "".join(f"{x} {x * x} {x * x * x}\n" for x in range(20))
        target = self.folder / "t.vtk"
        target.write_text("before")
        target.chmod(0o640)
        (self.folder / "link.vtk").symlink_to("t.vtk")
        self.run_quoin("delaunay", "-", "-o", "t.vtk", stdin="0 0 0\nx\n", code=1)
        self.assertEqual(target.read_text(), "before")
        self.run_quoin("delaunay", "-", "-o", "t.vtk", stdin=points)
        self.assertIn("DATASET", target.read_text())
        self.assertEqual(target.stat().st_mode & 0o777, 0o640)
        target.write_text("before")
        self.run_quoin("delaunay", "-", "-o", "link.vtk", stdin=points)
        self.assertTrue((self.folder / "link.vtk").is_symlink())
        self.assertIn("DATASET", target.read_text())
        self.assertEqual([path.name for path in self.folder.iterdir() if ".part" in path.name], [])

    def test_interruption_leaves_a_clean_line(self):
        shown = self.interrupted("classify", "a.off", "--points", "points", pipe="points")
        self.assertEqual(shown, "quoin: cancelled\n")
        shown = self.interrupted("info", "a.off", "mesh", "b.off", pipe="mesh")
        self.assertIn("quoin: cancelled\n", shown)
        self.assertNotIn("b.off", shown)


if __name__ == "__main__":
    main()
