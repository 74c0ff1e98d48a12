#!/usr/bin/env python3
"""Throughput and cost of the batch runner, for docs/scale.md: cells per second, overhead per cell, memory, merging.

    bench/throughput.py OUT [speed] [memory] [merge]      OUT: an empty or new directory; default: all three

Prints Markdown tables. A quiet machine, an hour; `speed` alone takes three minutes. Needs build/bin/dobbench.
"""
import os
import pathlib
import sqlite3
import statistics
import subprocess
import sys
import time

PROGRAM = str(pathlib.Path(__file__).resolve().parent.parent / "build/bin/dobbench")
MERGED_ROWS = 1_000_000
SHARDS = 4


def run(*arguments, watch=lambda child: None):
    """(wall time [s], processor time [s], largest resident set [MB]) of dobbench and its processes; watch(child) meanwhile."""
    start = time.monotonic()
    child = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.DEVNULL)
    watch(child)
    _, status, usage = os.wait4(child.pid, 0)
    if os.waitstatus_to_exitcode(status) not in (0, 3):
        sys.exit(f"dobbench {' '.join(map(str, arguments))}: exit code {os.waitstatus_to_exitcode(status)}")
    return time.monotonic() - start, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def in_trials(directory):
    """Wall time [s] that the trials themselves took, of all cells."""
    with sqlite3.connect(directory / "run.sqlite") as database:
        return database.execute("SELECT SUM(wall_s) FROM result").fetchone()[0]


def speed(out):
    """The same batch in one job and in two, three times in turn, so that both meet the same neighbours."""
    what = ["run", "case3/left_10", "--observer", "none", "--observer", "momentum_com", "--profile", "tuned", "--seeds",
            "20", "--keep", "none"]
    cells = 40
    walls, overheads = {1: [], 2: []}, []
    for repeat in range(3):
        for jobs in (1, 2):
            directory = out / f"speed_{jobs}_{repeat}"
            wall, _, _ = run(*what, "--jobs", jobs, "--out", directory)
            walls[jobs].append(wall)
            if jobs == 1:
                overheads.append((wall - in_trials(directory)) / in_trials(directory))
    print("| jobs | cells per second | per job | wall, median of 3 [s] |\n|---:|---:|---:|---:|")
    for jobs in (1, 2):
        wall = statistics.median(walls[jobs])
        print(f"| {jobs} | {cells / wall:.2f} | {cells / wall / jobs:.2f} | {wall:.1f} |")
    ratios = [one / two for one, two in zip(walls[1], walls[2])]
    print(f"\nTwo jobs against one: {statistics.median(ratios):.2f} times as fast (of each pair: "
          f"{', '.join(f'{r:.2f}' for r in ratios)}). Beyond the trials themselves, one job: "
          f"{100 * statistics.median(overheads):.1f} % ({', '.join(f'{100 * o:.1f}' for o in overheads)}).")


def finished(directory):
    """Rows that are in the database of a run, which may not be there yet."""
    try:
        with sqlite3.connect(f"file:{directory}/run.sqlite?mode=ro", uri=True, timeout=10) as database:
            return database.execute("SELECT COUNT(*) FROM result").fetchone()[0]
    except sqlite3.OperationalError:
        return 0


def largest_while_running(child, directory, cells):
    """Largest resident set [MB] of a batch until its last cells, after which it reads the rows for its table."""
    resident = 0
    while os.waitid(os.P_PID, child.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is None and finished(directory) < cells - 2:
        with open(f"/proc/{child.pid}/status") as status:
            resident = max([resident] + [int(line.split()[1]) for line in status if line.startswith("VmHWM")])
        time.sleep(max(0.02, cells / 1e5))
    return resident / 1024


def memory(out):
    """Trials of two milliseconds, so that there can be many."""
    print("| cells | wall [s] | cells per second | largest resident set, running [MB] | with the table at the end [MB] | "
          "run.sqlite [MB] |\n|---:|---:|---:|---:|---:|---:|")
    for cells in (100, 1_000, 10_000, 100_000):
        directory = out / f"memory_{cells}"
        running = []
        wall, _, resident = run("run", "undisturbed", "--observer", "none", "--set", "duration_s=0.002", "--seeds", cells,
                                "--keep", "none", "--jobs", "2", "--out", directory,
                                watch=lambda child: running.append(largest_while_running(child, directory, cells)))
        size = (directory / "run.sqlite").stat().st_size / 1e6
        print(f"| {cells} | {wall:.1f} | {cells / wall:.0f} | {running[0]:.0f} | {resident:.0f} | {size:.1f} |",
              flush=True)


def fill(directory, number):
    """A quarter of a million rows in a shard of a few: copies of its first one under other seeds."""
    with sqlite3.connect(directory / "run.sqlite") as database:
        def columns(table, without):
            return [row[1] for row in database.execute(f"PRAGMA table_info({table})") if row[1] not in without]
        numbers = (f"WITH RECURSIVE n(i) AS (SELECT 10 UNION ALL SELECT i + 1 FROM n WHERE i < {MERGED_ROWS // SHARDS + 9})")
        cell = f"(i * {SHARDS} + {number})"
        first = database.execute("SELECT MIN(cell) FROM result").fetchone()[0]
        keys = ", ".join(columns("cell", ("id", "seed")))
        database.execute(f"INSERT INTO cell(id, seed, {keys}) {numbers} SELECT {cell}, {cell}, {keys} FROM n, cell "
                         f"WHERE id = {first}")
        for table in ("result", "checkpoint"):
            rest = ", ".join(columns(table, ("cell",)))
            database.execute(f"INSERT INTO {table}(cell, {rest}) {numbers} SELECT {cell}, {rest} FROM n, {table} "
                             f"WHERE cell = {first}")


def merge(out):
    parts = []
    for number in range(1, SHARDS + 1):
        parts.append(out / f"shard_{number}")
        run("run", "undisturbed", "--observer", "none", "--set", "duration_s=2", "--seeds", SHARDS, "--keep", "none",
            "--shard", f"{number}/{SHARDS}", "--out", parts[-1])
        fill(parts[-1], number)
    wall, processor, resident = run("merge", *parts, "--out", out / "merged")
    with sqlite3.connect(out / "merged" / "run.sqlite") as database:
        rows = database.execute("SELECT COUNT(*) FROM result").fetchone()[0]
    size = (out / "merged" / "run.sqlite").stat().st_size / 1e6
    print("| rows | shards | wall [s] | processor [s] | largest resident set [MB] | merged [MB] |\n|---:|---:|---:|---:|---:|---:|")
    print(f"| {rows} | {SHARDS} | {wall:.1f} | {processor:.1f} | {resident:.0f} | {size:.0f} |")


def main():
    if len(sys.argv) < 2 or not set(sys.argv[2:]) <= {"speed", "memory", "merge"}:
        sys.exit(__doc__)
    out = pathlib.Path(sys.argv[1])
    out.mkdir(parents=True, exist_ok=True)
    if any(out.iterdir()):
        sys.exit(f"{out}: is not empty")
    for part in sys.argv[2:] or ["speed", "memory", "merge"]:
        print(f"\n{part}\n")
        {"speed": speed, "memory": memory, "merge": merge}[part](out)


if __name__ == "__main__":
    main()
