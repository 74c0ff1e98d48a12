#!/usr/bin/env python3
"""Mutation check: breaks one equation at a time in a copy of the sources and looks which tests notice.

    test/mutation/mutate.py [--work build/mutation] [--jobs N] [--only ID ...]   exit code 1: a mutant survived

Each mutant is built and its rooms' tests are run to the first failure. A mutant that does not compile counts as an error of
the list, not as caught. The result is printed as the Markdown table of docs/quality.md.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import time
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TEST_TIMEOUT = 600  # [s] a broken solver may not come back


def run(command, **options):
    return subprocess.run(command, text=True, capture_output=True, **options)


def copy_sources(work):
    """The files that git knows, as they are now; those that have not changed since the last call keep their time stamps."""
    names = run(["git", "ls-files", "-z"], cwd=ROOT, check=True).stdout.split("\0")
    for name in filter(None, names):
        source, target = ROOT / name, work / "source" / name
        if not target.exists() or source.read_bytes() != target.read_bytes():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, target)


def configure(work):
    done = run(["cmake", "-S", work / "source", "-B", work / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"])
    if done.returncode != 0:
        sys.exit(done.stdout + done.stderr)


def build(work, jobs, test):
    return run(["cmake", "--build", work / "build", "-j", str(jobs), "--target", test])


def first_failure(work, test):
    """Name of the first test that fails, None if all pass."""
    try:
        done = run([work / "build" / "bin" / test, "--gtest_brief=1", "--gtest_fail_fast"], timeout=TEST_TIMEOUT)
    except subprocess.TimeoutExpired:
        return "(time limit)"
    if done.returncode == 0:
        return None
    failed = re.search(r"\[  FAILED  \] ([\w/.]+)", done.stdout)
    return failed.group(1) if failed else f"(exit code {done.returncode})"


def mutate(mutation, work, jobs):
    """(verdict, the test that caught it)"""
    path = work / "source" / mutation["file"]
    original = path.read_text()
    count = original.count(mutation["before"])
    if count != 1:
        return "error", f"`before` occurs {count} times in {mutation['file']}"
    path.write_text(original.replace(mutation["before"], mutation["after"]))
    try:
        for test in mutation["tests"]:
            built = build(work, jobs, test)
            if built.returncode != 0:
                return "error", "does not compile"
            failure = first_failure(work, test)
            if failure:
                return "caught", f"{test}: {failure}"
        return "survived", ""
    finally:
        path.write_text(original)


def baseline(mutations, work, jobs):
    """The tests pass on what is not mutated, or nothing that follows means anything."""
    for test in sorted({test for mutation in mutations for test in mutation["tests"]}):
        built = build(work, jobs, test)
        if built.returncode != 0:
            sys.exit(built.stdout)
        failure = first_failure(work, test)
        if failure:
            sys.exit(f"{test} fails without any mutation: {failure}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "mutation")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", nargs="+", metavar="ID", help="only these mutations")
    options = parser.parse_args()
    mutations = tomllib.loads((HERE / "mutations.toml").read_text())["mutation"]
    if options.only:
        unknown = set(options.only) - {m["id"] for m in mutations}
        if unknown:
            sys.exit(f"no such mutation: {', '.join(sorted(unknown))}")
        mutations = [m for m in mutations if m["id"] in options.only]
    copy_sources(options.work)
    configure(options.work)
    baseline(mutations, options.work, options.jobs)

    print("| mutation | what it breaks | file | verdict | caught by |\n|---|---|---|---|---|")
    counts = {"caught": 0, "survived": 0, "error": 0}
    start = time.monotonic()
    for mutation in mutations:
        verdict, detail = mutate(mutation, options.work, options.jobs)
        counts[verdict] += 1
        print(f"| {mutation['id']} | {mutation['what']} | `{mutation['file']}` | {verdict} | {detail} |", flush=True)
    minutes = (time.monotonic() - start) / 60
    print(f"\n{len(mutations)} mutations: {counts['caught']} caught, {counts['survived']} survived, "
          f"{counts['error']} errors of the list; {minutes:.0f} min")
    return 1 if counts["survived"] or counts["error"] else 0


if __name__ == "__main__":
    sys.exit(main())
