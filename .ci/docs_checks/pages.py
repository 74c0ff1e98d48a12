"""Markdown pages as what the checks ask about: links, anchors, code spans, and blocks of code with their marks.

A mark is an HTML comment on the lines before a block, so that no reader sees it:
    <!-- no-run: REASON -->      the commands are only validated: they take too long or need another machine
    <!-- exit: N -->             the block ends with this exit code (default 0)
    <!-- file: NAME -->          the block is the contents of that file, written before what follows is run
    <!-- output -->              a `text` block: its lines are in the output of the block before (a line with ... is not asked for)
and, standing alone, commands that are run but not shown:
    <!-- setup
    COMMANDS
    -->
"""
import re
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


@dataclass
class Block:
    language: str
    line: int  # of its first line of code, from 1
    text: str
    marks: dict = field(default_factory=dict)


@dataclass
class Page:
    path: str  # in the repository
    blocks: list
    prose: list  # (line number, text), without fenced and indented code
    anchors: set

    def links(self):
        for number, line in self.prose:
            bare = re.sub(r"`[^`]*`", lambda span: " " * len(span[0]), line)
            for target in re.findall(r"\]\(([^()\s]+)\)", bare):
                yield number, target

    def code_spans(self):
        for number, line in self.prose:
            for span in re.findall(r"`([^`]+)`", line):
                yield number, span


def slug(heading):
    """The anchor that GitHub makes of a heading."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading.strip()).lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def read_page(path):
    blocks, prose, anchors, marks = [], [], set(), {}
    lines = (ROOT / path).read_text().splitlines()
    i = 0
    after_blank = True
    while i < len(lines):
        line = lines[i]
        fence = re.match(r"(\s*)```(\w*)", line)
        if fence:
            indent, end = fence[1], i + 1
            while end < len(lines) and lines[end].strip() != "```":
                end += 1
            code = "\n".join(l.removeprefix(indent) for l in lines[i + 1:end]) + "\n"
            blocks.append(Block(fence[2], i + 2, code, marks))
            marks, i = {}, end + 1
            continue
        if line.startswith("<!--"):
            end = i
            while "-->" not in lines[end]:
                end += 1
            text = "\n".join(lines[i:end + 1])[4:].split("-->")[0].strip()
            if text.startswith("setup\n"):
                blocks.append(Block("sh", i + 2, text.removeprefix("setup\n") + "\n", {"setup": ""}))
            else:
                key, _, value = text.partition(":")
                marks[key.strip()] = value.strip()
            i = end + 1
            continue
        if line.startswith("    ") and after_blank:
            end = i
            while end < len(lines) and (lines[end].startswith("    ") or not lines[end].strip()):
                end += 1
            blocks.append(Block("indented", i + 1, "\n".join(l[4:] for l in lines[i:end]).rstrip() + "\n"))
            i = end
            continue
        if line.strip():
            marks = {}
        heading = re.match(r"#+ (.*)", line)
        if heading:
            anchors.add(slug(heading[1]))
        prose.append((i + 1, line))
        # What is indented below an item of a list belongs to it and is no code.
        after_blank = not line.strip() and not (after_blank is None)
        if re.match(r"\s*([-*]|\d+\.) ", line):
            after_blank = None
        elif line and not line.startswith(" "):
            after_blank = False
        i += 1
    return Page(str(path), blocks, prose, anchors)


def tracked_files():
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True, text=True,
                            capture_output=True)
    return [name for name in listed.stdout.splitlines() if (ROOT / name).exists()]
