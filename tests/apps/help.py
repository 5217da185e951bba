# SPDX-License-Identifier: MIT
"""Tests what the command says about itself and about files: completions and manual pages are those of its
own options, `info` and `--json` say what the files and certificates say, hints name what helps."""
import itertools
import json
import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import sys
import unittest

import command

COMMANDS = ["mesh", "verify", "certify", "check", "adapt", "metric", "transfer", "eval", "challenge", "surface",
            "deviation", "convert", "draw", "info", "completion", "help", "man"]


class Help(command.CommandTest):
    def options_of(self, name):
        """Returns the options that help lists. Options in examples do not count."""
        listed = self.run_command(name, "--help").stdout
        return set(re.findall(r"^  (?:-\w,)?(--[a-z][a-z-]*)", listed, re.M))

    def test_all_commands_are_known_here(self):
        listed = self.run_command("--help").stdout.split("Subcommands:")[1].split("Exit status:")[0]
        self.assertEqual(set(re.findall(r"^  (\w+) ", listed, re.M)), set(COMMANDS))

    def test_every_option_is_completed_in_every_shell(self):
        scripts = {shell: self.run_command("completion", shell).stdout for shell in ("bash", "zsh", "fish")}
        for name in COMMANDS:
            for option in self.options_of(name):
                self.assertRegex(scripts["bash"], rf"(?s)\n    {name}\).*?options='[^']*{option}[ ']")
                self.assertRegex(scripts["zsh"], rf"(?s)\n    {name}\)\n.*?\*{option}=?\[")
                self.assertRegex(scripts["fish"], rf"seen_subcommand_from {name}'.* -l {option[2:]} ")
        self.assertEqual(self.run_command("completion", "tcsh").returncode, 2)
        for shell in ("zsh", "fish"):
            if shutil.which(shell):
                self.write("script", scripts[shell])
                subprocess.run([shell, "-n", self.folder / "script"], check=True)

    def test_options_are_in_groups(self):
        for name in ("mesh", "adapt", "metric", "certify", "verify", "surface", "deviation", "draw", "convert"):
            ungrouped = self.run_command(name, "--help").stdout.split("Options:\n")[1].split("\n\n")[0]
            self.assertEqual(re.findall(r"^  (\S+)", ungrouped, re.M), ["-h,--help"], name)

    def test_paragraphs_are_broken_where_the_line_is_full(self):
        for name in COMMANDS:
            for columns in (72, 100, 140):
                text = self.run_command(name, "--help", environment={"COLUMNS": str(columns)}).stdout
                for line, after in itertools.pairwise(text.split("\nExit status:")[0].split("\n")):
                    is_text = line and after and " " not in (line[0], after[0]) and not after.startswith("Usage:")
                    if is_text:
                        self.assertGreater(len(line) + 1 + len(after.split()[0]), columns, f"{name}: {line}")

    def test_each_list_of_values_begins_a_line(self):
        for name, words in (("mesh", ("DOMAIN", "SPEC", "OUT")), ("convert", ("IN", "OUT"))):
            for columns in (72, 100, 140):
                text = self.run_command(name, "--help", environment={"COLUMNS": str(columns)}).stdout
                for word in words:
                    self.assertRegex(text, rf"(?m)^{word}  +\S", f"{name}, {columns} columns")

    def complete(self, *words):
        self.write("script", self.run_command("completion", "bash").stdout)
        call = (f"source ./script; COMP_WORDS=({' '.join(repr(w) for w in words)}); COMP_CWORD={len(words) - 1}; "
                "_asterism; printf '%s\\n' \"${COMPREPLY[@]}\"")
        done = subprocess.run(["bash", "-c", call], cwd=self.folder, capture_output=True, text=True, check=True)
        self.assertEqual(done.stderr, "")
        return done.stdout.splitlines() if done.stdout.strip() else []

    def test_bash_completes_commands_options_choices_and_files(self):
        self.write("lake.poly", "")
        self.assertEqual(self.complete("asterism", "ver"), ["verify"])
        self.assertEqual(self.complete("asterism", "mesh", "--angle"), ["--angle-bound"])
        self.assertEqual(set(self.complete("asterism", "mesh", "--refine", "")), {"fill", "voronoi", "darts"})
        self.assertEqual(self.complete("asterism", "mesh", "la"), ["lake.poly"])
        self.assertEqual(self.complete("asterism", "mesh", "sq"), ["square"])
        self.assertEqual(self.complete("asterism", "mesh", "square", "--metric", "sh"), ["shock"])
        self.assertEqual(self.complete("asterism", "completion", ""), ["bash", "zsh", "fish"])
        self.assertEqual(self.complete("asterism", "man", "tr"), ["transfer"])
        self.assertEqual(self.complete("asterism", "mesh", "x", "-o", "la"), ["lake.poly"])
        self.assertEqual(self.complete("asterism", "mesh", "square", "--size", ""), [], "no file is a size")
        self.write("my lake.poly", "")
        self.assertEqual(self.complete("asterism", "mesh", "my"), ["my lake.poly"], "one file, not two words")

    def ask_fish(self, line):
        self.write("script", self.run_command("completion", "fish").stdout)
        done = subprocess.run(["fish", "--no-config", "-c", f"source script; complete -C '{line}'"], cwd=self.folder,
                              capture_output=True, text=True, check=True,
                              env={**os.environ, "HOME": str(self.folder)})
        return {one.split("\t")[0] for one in done.stdout.splitlines()}

    def ask_zsh(self, line, setting="fpath=(functions $fpath); autoload -Uz compinit; compinit -u -D"):
        """Returns what zsh shows after two tabs: the first lists the completions, the second takes the first of
        them."""
        (self.folder / "functions").mkdir(exist_ok=True)
        self.write("functions/_asterism", self.run_command("completion", "zsh").stdout)
        process, terminal = pty.fork()
        if process == 0:
            os.chdir(self.folder)
            os.environ.update(TERM="dumb", COLUMNS="200", LINES="60")
            os.execvp("zsh", ["zsh", "-f", "-i"])
        os.write(terminal, setting.encode() + b"; LISTMAX=0; unset zle_bracketed_paste; "
                           b"PS1='> '; asterism-wait() { zle -I; print -r -- \"done:$BUFFER:\"; }; zle -N asterism-wait; "
                           b"bindkey '^X' asterism-wait; print rea''dy\n")
        said = self.read_until(terminal, "ready\r\n")
        os.write(terminal, line.encode() + b"\t\t\x18")
        said = self.read_until(terminal, "done:", ":\r\n")
        os.close(terminal)
        os.waitpid(process, 0)
        shown, buffer = said.rsplit("done:", 1)
        return set(re.split(r"\s+", shown)) | {buffer.split(":")[0]}

    def read_until(self, terminal, *wanted):
        said = ""
        for word in wanted:
            at = len(said) if word == wanted[0] else said.rindex(wanted[0])
            while word not in said[at:]:
                self.assertTrue(select.select([terminal], [], [], 30)[0], f"nothing more after {said!r}")
                said += os.read(terminal, 65536).decode(errors="replace")
        return said

    def check_shell(self, ask):
        for name in ("lake.poly", "x.mesh"):
            self.write(name, "")
        self.assertGreaterEqual(ask("asterism me"), {"mesh", "metric"})
        self.assertGreaterEqual(ask("asterism mesh --re"), {"--refine", "--regions", "--repair-domain", "--repair-distance"})
        self.assertGreaterEqual(ask("asterism mesh --refine "), {"darts", "fill", "voronoi"})
        self.assertGreaterEqual(ask("asterism completion "), {"bash", "zsh", "fish"})
        self.assertGreaterEqual(ask("asterism mesh --metric s"), {"shock", "sink", "swirl"})
        self.assertTrue(any("lake.poly" in one for one in ask("asterism mesh l")))
        self.assertTrue(any("x.mesh" in one for one in ask("asterism verify x")))
        self.assertFalse(any("x.mesh" in one for one in ask("asterism mesh square --size ")), "no file is a size")
        self.assertTrue(any(one.endswith("--refine=voronoi") or one == "voronoi" for one in ask("asterism mesh --refine=")))

    @unittest.skipUnless(shutil.which("fish"), "fish is not installed")
    def test_fish_completes_commands_options_choices_and_files(self):
        self.check_shell(self.ask_fish)

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_completes_commands_options_choices_and_files(self):
        self.check_shell(self.ask_zsh)
        sourced = self.ask_zsh("asterism mesh --refine ", "autoload -Uz compinit; compinit -u -D; source functions/_asterism")
        self.assertGreaterEqual(sourced, {"darts", "fill", "voronoi"})

    def test_manual_pages_have_every_option_and_are_set_without_a_warning(self):
        for name in [None, *COMMANDS]:
            page = self.run_command("man", *([name] if name else [])).stdout
            plain = page.replace("\\-", "-")
            self.assertRegex(page, r"^\.\\\" Written by .*\n\.TH ASTERISM")
            for option in self.options_of(name) if name else ["--version"]:
                self.assertIn(f"\\fB{option}\\fR", plain)
            if shutil.which("groff"):
                done = subprocess.run(["groff", "-man", "-ww", "-z", "-Tutf8"], input=page, text=True,
                                      capture_output=True, check=True)
                self.assertEqual(done.stderr, "")
        self.assertEqual(self.run_command("man", "nothing").returncode, 2)

    def test_a_summary_for_programs_is_one_object(self):
        done = self.run_command(*command.JOB, "-o", "m.mesh", "-o", "m.vtu", "--json")
        said, written = json.loads(done.stdout), self.certificate("m")
        self.assertEqual((done.returncode, said["status"], said["certified"], said["complete"]), (0, 0, True, True))
        self.assertEqual(said["worst_angle"], written["audit"]["worst_angle"])
        self.assertEqual((said["vertices"], said["triangles"]), (written["mesh"]["vertices"], written["mesh"]["triangles"]))
        self.assertEqual(sorted(said["files"]), self.files())
        self.assertIsNone(said["next"])
        for name in ("verify", "certify"):
            judged = self.run_command(name, "m.mesh", "--json")
            verdict = json.loads(judged.stdout)
            self.assertEqual((judged.returncode, verdict["status"], verdict["command"]), (0, 0, name))
            self.assertEqual(verdict["worst_angle"], said["worst_angle"])
        self.assertEqual(self.run_command(*command.JOB, "-o", "m.mesh", "--json", "--quiet").returncode, 2)

    def certificate(self, name):
        return json.loads((self.folder / f"{name}.certificate.json").read_text())

    def test_info_says_what_files_hold(self):
        self.run_command(*command.JOB, "-o", "m.mesh")
        said = json.loads(self.run_command("info", "m.mesh", "--json").stdout)
        written = self.certificate("m")
        self.assertEqual((said["kind"], said["vertices"]), ("mesh", written["mesh"]["vertices"]))
        self.assertRegex(said["certificate"], "certified, says it")
        self.assertEqual(json.loads(self.run_command("info", "m.certificate.json", "--json").stdout)["fingerprint"],
                         written["mesh"]["fingerprint"])
        told = json.loads(self.run_command("info", "m.sol", "--json").stdout)
        self.assertEqual((told["kind"], told["vertices"]), ("metric", said["vertices"]))
        self.write("m.bb", f"2 1 {said['vertices']} 2\n" + "".join(f"{i}.5\n" for i in range(said["vertices"])))
        self.assertRegex(self.run_command("info", "m.bb").stdout, r"field 1 +scalar, numbers from 0.5 to \d+.5")
        self.write("alone.sol", "")
        self.assertIn("alone.mesh", self.run_command("info", "alone.sol").stderr)
        self.assertIn("certificates", self.run_command("info", "notes.txt").stderr)
        self.write("cross.poly", "4 2 0 0\n1 0 0\n2 4 0\n3 0 3\n4 4 3.5\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n")
        lines = self.run_command("info", "cross.poly").stdout
        self.assertRegex(lines, r"can be meshed +no: cross.poly:10: segment 4 .*crosses")
        self.assertRegex(lines, r"with --repair-domain +yes")
        (self.folder / "m.sol").unlink()
        self.assertRegex(self.run_command("info", "m.mesh").stdout, r"metric +none: m\.sol")
        self.assertEqual(self.run_command("info", "nothing.poly").returncode, 2)

    def test_info_of_a_vtu_a_mtr_and_of_what_is_written_alone(self):
        self.run_command(*command.JOB, "-o", "m.mesh", "-o", "m.su2")
        count = json.loads(self.run_command("info", "m.mesh", "--json").stdout)["vertices"]
        self.write("m.mtr", f"{count} 1\n" + "0.5\n" * count)
        self.assertRegex(self.run_command("info", "m.mtr").stdout, r"kind +metric")
        self.write("m.vtu", '<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="%d"><PointData>'
                   '<DataArray type="Float64" Name="heat" format="ascii">%s</DataArray></PointData></Piece>'
                   '</UnstructuredGrid></VTKFile>' % (count, " 7.5" * count))
        self.assertRegex(self.run_command("info", "m.vtu").stdout, "field heat +scalar, numbers from 7.5 to 7.5")
        self.assertIn("written here, not read", self.run_command("info", "m.edge").stderr)

    def test_a_drawing_is_a_picture(self):
        self.run_command(*command.JOB, "-o", "m.mesh")
        for name in ("x.su2", "x.node", "x.msh", "x.vtu", "x.mesh"):
            done = self.run_command("draw", "m.mesh", "-o", name)
            self.assertEqual(done.returncode, 2)
            self.assertIn("not a picture", done.stderr)
        self.assertFalse([name for name in self.files() if name.startswith("x.")])

    def test_what_did_not_end_well_names_what_to_try(self):
        for arguments, hint in [
                (["square", "--size", "0.01", "--max-sites", "500"], r"try --max-sites \d+00, or a larger --size"),
                (["airfoil", "--angle-bound", "40", "--max-sites", "500"], "try --angle-bound 20, or a larger --max-sites"),
                (["square", "--metric", "expr:1+1e6*(x>0.1);0;1", "--metric-tolerance", "0", "--max-sites", "2000"],
                 r"try --metric-tolerance \d")]:
            done = self.run_command("mesh", *arguments, "-o", "m.mesh")
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, "asterism: " + hint)

    def test_a_slip_of_the_keyboard_is_told_with_what_was_meant(self):
        for words, told in [(["msh", "square"], "no command 'msh'; did you mean mesh?"),
                            (["mesh", "square", "--sise", "0.1", "-o", "m.mesh"],
                             "mesh has no option --sise; did you mean --size?"),
                            (["mesh", "square", "--metrik=swirl", "-o", "m.mesh"], "did you mean --metric?"),
                            (["verify", "m.mesh", "--xyzzy"], "verify has no option --xyzzy\n")]:
            done = self.run_command(*words)
            self.assertEqual(done.returncode, 2)
            self.assertIn(told, done.stderr)
            self.assertRegex(done.stderr, "'asterism (mesh |verify )?--help' lists")

    def test_options_of_other_meshers_are_told_by_their_name_here(self):
        for word, told in (("-hmax", "-hmax; here it is --size|-hmax; did you mean --hmax"), ("--min-angle", "--angle-bound"),
                           ("-q30", "-q30; here it is --angle-bound"), ("-a.1", "-a.1; here it is --size"),
                           ("--clmax", "--size"), ("-j", "-j; here it is --threads"), ("-nt", "--threads")):
            done = self.run_command("mesh", "square", word, "0.1", "-o", "m.mesh")
            self.assertEqual(done.returncode, 2, word)
            self.assertRegex(done.stderr, told)
            self.assertEqual(self.files(), [])
        self.assertIn("did you mean mesh?", self.run_command("mehs", "square").stderr)

    def test_help_of_a_command_is_wrapped_and_grouped(self):
        for words in (("help", "mesh"), ("mesh", "--help"), ("help",), ("--help",)):
            for columns in ("60", "80", "100"):
                done = subprocess.run([command.PROGRAM, *words], capture_output=True, text=True, check=True,
                                      env={**os.environ, "COLUMNS": columns})
                prose = [line for line in done.stdout.splitlines() if not line.startswith(("  asterism ", "Usage:"))]
                most = max(len(line) for line in prose)
                self.assertLessEqual(most, int(columns), [line for line in prose if len(line) == most])
        self.assertEqual(self.run_command("help").stdout, self.run_command("--help").stdout)
        said = self.run_command("help", "mesh").stdout
        for heading in ("What is wanted:", "Domain:", "Files and words:", "Limits:", "Examples:"):
            self.assertIn("\n" + heading + "\n", said)
        self.assertEqual(said, self.run_command("mesh", "--help").stdout)
        self.assertIn("asterism mesh square", self.run_command("--help").stdout)
        done = self.run_command("help", "mehs")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("did you mean mesh?", done.stderr)

    def test_the_manual_lists_what_help_lists(self):
        script = pathlib.Path(__file__).resolve().parents[2] / "scripts/make-options-page"
        done = subprocess.run([sys.executable, script, command.PROGRAM, "--check"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_list_without_blanks_is_broken_too(self):
        done = self.run_command("help", "man", environment={"COLUMNS": "60"})
        self.assertLessEqual(max(map(len, done.stdout.splitlines())), 60)

    def test_a_mesh_that_is_not_certified_may_be_repaired(self):
        self.run_command("mesh", "square", "--size", "0.3", "-o", "m.mesh")
        done = self.run_command("certify", "m.mesh", "--metric", "swirl:12")
        self.assertEqual(done.returncode, 1)
        self.assertIn("try --repair", done.stderr)

    def at_terminal(self, **environment):
        """Returns standard output of a run at a terminal."""
        try:
            ours, theirs = pty.openpty()
        except OSError as no_terminal:  # a system without /dev/pts
            self.skipTest(str(no_terminal))
        subprocess.run([command.PROGRAM, "mesh", "square", "-o", "m.mesh"], cwd=self.folder, stdout=theirs,
                       stderr=subprocess.DEVNULL, check=True,
                       env={**{k: v for k, v in os.environ.items() if k != "NO_COLOR"}, **environment})
        os.close(theirs)
        text = b""
        try:
            while part := os.read(ours, 100000):
                text += part
        except OSError:  # Linux: no process has the terminal open any more
            pass
        os.close(ours)
        return text.decode()

    def test_colours_are_for_terminals_that_want_them(self):
        green = "\x1b[1;32mcertified\x1b[0m"
        self.assertIn(green, self.at_terminal(TERM="xterm"))
        self.assertNotIn("\x1b", self.at_terminal(TERM="xterm", NO_COLOR="1"))
        self.assertNotIn("\x1b", self.at_terminal(TERM="dumb"))
        self.assertNotIn("\x1b", self.run_command("mesh", "square", "-o", "m.mesh").stdout)


if __name__ == "__main__":
    unittest.main()
