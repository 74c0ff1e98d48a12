"""What pages refer to: links and anchors, files, tests, and the published tables whose figures they print."""
import json
import re
from pathlib import PurePosixPath

from .pages import ROOT

ROOMS = ("robot", "observers", "controller", "sim", "scenarios", "results", "bench", "test", "docs", "examples", "cmake", ".ci")


def resolve(page, target):
    """Path in the repository that a relative link of the page means."""
    parts = []
    for part in (PurePosixPath(page.path).parent / target).parts:
        if part == ".." and parts:
            parts.pop()
        elif part not in (".",):
            parts.append(part)
    return "/".join(parts)


def check_links(pages):
    by_path = {page.path: page for page in pages}
    for page in pages:
        for line, target in page.links():
            if re.match(r"(https?|mailto):", target):
                continue
            path, _, anchor = target.partition("#")
            where = f"{page.path}:{line}"
            file = resolve(page, path) if path else page.path
            if not (ROOT / file).exists():
                yield f"{where}: link to {target}: no such file"
            elif anchor and file in by_path and anchor not in by_path[file].anchors:
                yield f"{where}: link to {target}: no such heading"


def check_reachable(pages):
    """From the README every page and picture under docs/."""
    by_path = {page.path: page for page in pages}
    reached, todo = set(), ["README.md"]
    while todo:
        path = todo.pop()
        if path in reached:
            continue
        reached.add(path)
        if path in by_path:
            for _, target in by_path[path].links():
                todo.append(resolve(by_path[path], target.partition("#")[0]))
    for file in sorted(p.relative_to(ROOT).as_posix() for p in (ROOT / "docs").rglob("*")):
        if file.endswith((".md", ".svg", ".png")) and file not in reached:
            yield f"{file}: no link from README.md leads here"


def check_files(pages, files):
    """Code spans that look like a file or a directory of the repository, with * and {h,cc} for several."""
    for page in pages:
        for line, span in page.code_spans():
            name = re.sub(r":[\w:~]+$|:\d+$", "", span.removeprefix("./"))
            room = name.split("/")[0]
            if "/" not in name or room not in ROOMS or not re.fullmatch(r"[\w./*{},-]+", name) or name.isupper():
                continue
            if re.search(r"/[A-Z]+(\.|/|$)", name):  # a place holder: observers/NAME.h
                continue
            if not re.search(r"(\.\w+|\*|/|\})$", name) and not (ROOT / name).exists():
                continue  # case1/tip_lateral and the like: names of the program
            found = [f for alternative in expand(name) for f in [next(matching(alternative, files), None)]]
            if None in found:
                yield f"{page.path}:{line}: `{span}`: no such file"


def expand(name):
    braces = re.search(r"\{([^}]*)\}", name)
    return [name.replace(braces[0], a) for a in braces[1].split(",")] if braces else [name]


def matching(name, files):
    pattern = re.escape(name).replace(r"\*", "[^/]*")
    pattern += ".*" if name.endswith("/") else "(/.*)?"
    return (f for f in files if re.fullmatch(pattern, f))


def check_tests(pages, files):
    """Code spans Suite.Test are tests of that name."""
    tests = set()
    for file in files:
        if file.startswith("test/") and file.endswith((".cc", ".h")):
            for suite, test in re.findall(r"\bTEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\)", (ROOT / file).read_text()):
                tests.add(f"{suite}.{test}")
            for suite, test in re.findall(r"\bTYPED_TEST(?:_P)?\(\s*(\w+),\s*(\w+)\)", (ROOT / file).read_text()):
                tests.add(f"{suite}.{test}")
    for page in pages:
        for line, span in page.code_spans():
            if re.fullmatch(r"[A-Z]\w+\.[A-Z]\w+", span):
                if span not in tests:
                    yield f"{page.path}:{line}: `{span}`: no such test"


def words(text):
    return re.sub(r"\s+", " ", text.replace("\\", "")).strip()


def check_printed_table(page, published):
    """Rows of the summary that a page prints are those of the published table."""
    rows = set()
    for line in (ROOT / published).read_text().splitlines():
        if line.startswith("|"):
            rows.add(words(" ".join(cell for cell in line.strip("|").split("|"))))
    printed = [b for b in page.blocks if b.text.startswith("summary:")]
    if not printed:
        yield f"{page.path}: prints no summary; it should show that of {published}"
    for block in printed:
        for offset, line in enumerate(block.text.splitlines()):
            row = words(line)
            if re.match(r"\w+ (\S+) ([\d.]+|bound) ", row) and row not in rows:
                yield f"{page.path}:{block.line + offset}: no such row in {published}: {row}"


def check_counts(page, published):
    """The numbers of claims that hold, as the headings of the published table have them."""
    counts = re.findall(r"Profile (\w+),.*: (\d+) hold, (\d+) do not, (\d+) without data", (ROOT / published).read_text())
    total = {profile: sum(map(int, n)) for profile, *n in counts}
    held = {profile: n[0] for profile, *n in counts}
    text = words(" ".join(line for _, line in page.prose))
    said = re.search(r"Of (\d+) questions that .*?, (\d+) .*? (\d+) of (\d+) with tuned ones", text)
    if not said or said.groups() != (str(total["paper"]), held["paper"], held["tuned"], str(total["tuned"])):
        yield f"{page.path}: the claims that hold are {held} of {total} ({published})"


def check_claims(page, claims, published):
    """The page has every claim of the paper, and the figures that it gives for one are those of the published table."""
    ids = {i.split("/")[0] for i in re.findall(r'^id = "([^"]+)"', (ROOT / claims).read_text(), re.M)}
    measured = {i: set() for i in ids}
    for claim in json.loads((ROOT / published).read_text()):
        texts = [claim[key] or "" for key in ("measured", "ours_measured", "note", "paper")]
        measured[claim["id"].split("/")[0]].update(re.findall(r"\d+\.\d+", " ".join(texts)))
    seen = set()
    for line, text in page.prose:
        cells = text.split("|")
        named = [i for i in re.findall(r"`([\w-]+)`", cells[1] if len(cells) > 3 else "") if i in ids]
        seen.update(named)
        for figure in re.findall(r"\d+\.\d+", cells[3]) if named else ():
            if not any(figure in measured[i] for i in named):
                yield f"{page.path}:{line}: {figure} is not in {published} for {', '.join(named)}"
    for missing in sorted(ids - seen):
        yield f"{page.path}: has no row for the claim `{missing}`"
