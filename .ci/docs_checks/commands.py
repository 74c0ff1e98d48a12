"""Commands in pages: all are validated against the program's help, those without a mark are run, page by page."""
import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import tempfile
from pathlib import Path

from .pages import ROOT

SHELL = ("sh", "bash", "console")
RUN_LIMIT_S = 600


class Program:
    """What `dobbench` knows: subcommands, their options, scenarios, observers."""

    def __init__(self, binary):
        self.binary = binary
        self.options = {"": self.help_options()}
        for sub in self.subcommands:
            self.options[sub] = self.help_options(sub)
        self.names = {what: [entry["name"] if isinstance(entry, dict) else entry for entry in listed]
                      for what, listed in self.listing().items() if isinstance(listed, list)}

    def say(self, *arguments):
        return subprocess.run([self.binary, *arguments], check=True, text=True, capture_output=True).stdout

    def help_options(self, *sub):
        text = self.say(*sub, "--help")
        if not sub:
            self.subcommands = re.findall(r"^  (\w+)\s{2,}", text.partition("Subcommands:")[2], re.M)
        return set(re.findall(r"(?<![\w-])(--?[\w-]+)", text.partition("Options:")[2]))

    def listing(self):
        return json.loads(self.say("list", "--json"))


def statements(text):
    """Commands of a block with the offset of their line; continued lines are one, comments are left out."""
    lines, start = [], None
    for offset, line in enumerate(text.splitlines()):
        start = offset if start is None else start
        lines.append(line.rstrip().removesuffix("\\"))
        if line.rstrip().endswith("\\"):
            continue
        joined, lines, at, start = " ".join(lines), [], start, None
        try:
            words = shlex.split(joined, comments=True)
        except ValueError:
            continue  # a quotation over several lines: left to the shell
        if words:
            yield at, words


def invalid(words, program):
    """Why one command cannot be right, or None."""
    while words and re.fullmatch(r"[A-Z_]+=.*", words[0]):
        words = words[1:]
    if not words:
        return None
    name, arguments = words[0], words[1:]
    for stop in ("|", "&&", "||", ";", ">", "2>"):
        if stop in arguments:
            arguments = arguments[:arguments.index(stop)]
    if name.endswith("/dobbench") or name == "dobbench":
        return invalid_arguments(arguments, program)
    if name == "make":
        targets = re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text(), re.M)
        wrong = [a for a in arguments if "=" not in a and not a.startswith("-") and a not in targets]
        return f"make has no target {wrong[0]}" if wrong else None
    if name in ("cmake", "ctest") and "--preset" in arguments:
        presets = re.findall(r'"name": "([\w-]+)"', (ROOT / "CMakePresets.json").read_text())
        wanted = arguments[arguments.index("--preset") + 1]
        return None if wanted in presets else f"no preset {wanted}"
    if name.split("/")[0] in ("bench", ".ci", "test"):
        return None if os.access(ROOT / name, os.X_OK) else f"{name} cannot be run"
    return None


def invalid_arguments(arguments, program):
    if arguments and arguments[0].startswith("-"):
        return None if arguments[0] in program.options[""] else f"dobbench has no option {arguments[0]}"
    if not arguments or arguments[0] not in program.subcommands:
        return f"dobbench has no subcommand {arguments[0] if arguments else ''}"
    sub = arguments[0]
    for i, word in enumerate(arguments[1:], 1):
        if word.startswith("-") and word.split("=")[0] not in program.options[sub]:
            return f"dobbench {sub} has no option {word}"
        if arguments[i - 1] == "--observer" and re.fullmatch(r"\w+", word.split(":")[0]):
            if word.split(":")[0] not in program.names["observers"]:
                return f"no observer {word}"
    return None


def check_commands(pages, program):
    for page in pages:
        for block in page.blocks:
            if block.language == "indented" and re.search(r"^(\S*bin/dobbench|make |cmake |\S+=\S+ \S*bin/)", block.text, re.M):
                yield f"{page.path}:{block.line}: commands stand in a block ```sh, so that they are checked"
            if block.language in SHELL:
                for offset, words in statements(block.text):
                    reason = invalid(words, program)
                    if reason:
                        yield f"{page.path}:{block.line + offset}: {reason}"


def check_lists(page, program):
    """Every scenario and every observer of the program has a place on its page."""
    for what, path in (("scenarios", "docs/scenarios.md"), ("observers", "docs/observers.md")):
        text = "\n".join(line for _, line in page[path].prose)
        for name in sorted({entry.split("/")[0] for entry in program.names[what]}):
            if not re.search(rf"(`{name}`|^\| {name} \|)", text, re.M):
                yield f"{path}: says nothing about {name}"


def scratch_copy(binary, files):
    """A copy of the tree whose build/bin is the given one: what a reader has after `make build`."""
    scratch = Path(tempfile.mkdtemp(prefix="check-docs-"))
    for name in files:
        target = scratch / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / name, target)
    (scratch / "build").mkdir()
    (scratch / "build" / "bin").symlink_to(Path(binary).resolve().parent)
    return scratch


def run_page(page, binary, files):
    """Runs the blocks of one page in order, in a copy of its own. Yields what went wrong."""
    work = [b for b in page.blocks if b.language in SHELL + ("python",) and "no-run" not in b.marks]
    if not work:
        return
    scratch = scratch_copy(binary, files)
    output = ""
    try:
        for block in page.blocks:
            where = f"{page.path}:{block.line}"
            if "no-run" in block.marks:
                continue
            if "file" in block.marks:
                (scratch / block.marks["file"]).write_text(block.text)
            elif "output" in block.marks:
                yield from missing_lines(block, output, page.path)
            elif block in work:
                try:
                    done = run_block(block, scratch)
                except subprocess.TimeoutExpired:
                    yield f"{where}: not done after {RUN_LIMIT_S} s: mark it no-run"
                    return
                output = done.stdout
                expected = int(block.marks.get("exit", 0))
                if done.returncode != expected:
                    tail = "\n    ".join(done.stdout.splitlines()[-15:])
                    yield f"{where}: exit code {done.returncode} instead of {expected}:\n    {tail}"
                    return
    finally:
        shutil.rmtree(scratch)


def run_block(block, scratch):
    if block.language == "python":
        command = ["python3", "-c", block.text]
    else:
        command = ["bash", "-euo", "pipefail", "-c", block.text]
    environment = {**os.environ, "HOME": str(scratch)}
    environment.pop("DOBBENCH_SCENARIOS", None)
    process = subprocess.Popen(command, cwd=scratch, env=environment, text=True, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, start_new_session=True)
    try:
        output, _ = process.communicate(timeout=RUN_LIMIT_S)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)  # what the shell has started, too
        process.wait()
        raise
    return subprocess.CompletedProcess(command, process.returncode, output)


def missing_lines(block, output, path):
    printed = [" ".join(line.split()) for line in output.splitlines()]
    for offset, line in enumerate(block.text.splitlines()):
        wanted = " ".join(line.split())
        if wanted and "..." not in wanted and wanted not in printed:
            yield f"{path}:{block.line + offset}: the program does not print: {wanted}"
