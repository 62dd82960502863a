#!/usr/bin/env python3
"""Do the intervals hold? Runs grids with fresh seeds and counts how often the reference lies inside.

    tests/studies/coverage.py [--seeds 200] [--accuracies 5,2,1] [--rooms R1,R2] [--solver auto] [--program PATH]
                              [--store FILE] [--set KEY=VALUE]

Each run is a line of the store (JSON); runs that are there already are not repeated, so the command can be stopped
and started again. References: ../shared/validation/rooms beside the repository (or GONIOLUX_SHARED); rooms without a
reference are listed as skipped. A reference's own error is added in quadrature.

The table: share of all points inside their 95 % interval (pooled), of the means, minima and uniformities, the RMS and
the largest error of the points, the mean error, CPU seconds of one run (one thread, start included), and the RMS over
what was asked.
"""
import argparse
import csv
import json
import math
import os
import resource
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def shared_folder():
    for place in (os.environ.get("GONIOLUX_SHARED"), ROOT.parent / "shared"):
        if place and Path(place).is_dir():
            return Path(place)
    return None


def read_reference(room):
    """{(x, y): (lx, standard error)} of a room, or None."""
    shared = shared_folder()
    path = shared / "validation" / "rooms" / f"{room}.csv" if shared else None
    if path is None or not path.is_file():
        return None
    with open(path) as file:
        return {
            (round(float(r["x"]), 3), round(float(r["y"]), 3)): (float(r["E_total_lx"]), float(r["se_total_lx"]))
            for r in csv.DictReader(file)
        }


# One sigma of the references' common error, relative (their README states it for the mean).
REFERENCE_MEAN = 0.0004


def run(program, room, accuracy, seed, solver, extra):
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "illuminate", str(ROOT / "projects/validation" / room), "--threads", "1", "--solver", solver,
                   "--accuracy", f"{accuracy} %", "--seed", str(seed), "-o", folder]
        for item in extra:
            command += ["--set", item]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        grids = Path(folder) / "grids.json"
        if not grids.is_file():
            sys.exit(f"{' '.join(command)} ended with {os.waitstatus_to_exitcode(status)} and wrote no grids.json")
        grid = json.loads(grids.read_text())["grids"][0]
    return grid, usage.ru_utime + usage.ru_stime


def judge(grid, reference):
    """What one run says against the reference: counts and sums."""
    inside = count = 0
    squares = largest = mean_ref = mean = 0.0
    lowest = math.inf
    for point, value, half in zip(grid["points"], grid["values"], grid["half_widths"]):
        if value is None:
            continue
        expected, error = reference[(round(point[0], 3), round(point[1], 3))]
        count += 1
        inside += abs(value - expected) <= math.hypot(half, 1.96 * error)
        relative = value / expected - 1
        squares += relative * relative
        largest = max(largest, abs(relative))
        mean_ref += expected
        mean += value
        if expected < lowest:
            lowest, lowest_error = expected, error
    mean_ref /= count
    mean /= count

    def holds(entry, truth, error):
        return int(abs(entry["value"] - truth) <= math.hypot(entry["half_width"], 1.96 * error))

    return {
        "points": count, "inside": inside, "squares": squares, "largest": largest,
        "mean_error": mean / mean_ref - 1,
        "mean": holds(grid["mean"], mean_ref, REFERENCE_MEAN * mean_ref),
        "min": holds(grid["min"], lowest, lowest_error),
        "u0": holds(grid["u0"], lowest / mean_ref, lowest_error / mean_ref),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=200)
    parser.add_argument("--first-seed", type=int, default=1001, help="fresh seeds: nothing was tuned on them")
    parser.add_argument("--accuracies", default="5,2,1")
    parser.add_argument("--rooms", default="R1,R2,R3,R4")
    parser.add_argument("--solver", default="auto")
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/goniolux"))
    parser.add_argument("--store", default=str(ROOT / "build/coverage.jsonl"))
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()

    store = Path(options.store)
    store.parent.mkdir(parents=True, exist_ok=True)
    done = {}
    if store.is_file():
        for line in store.read_text().splitlines():
            entry = json.loads(line)
            done[tuple(entry["key"])] = entry
    wanted = []
    references = {}
    for room in options.rooms.split(","):
        references[room] = read_reference(room)
        if references[room] is None or not (ROOT / "projects/validation" / room).is_dir():
            print(f"{room}: skipped, no reference (or no project) here")
            continue
        for accuracy in options.accuracies.split(","):
            for seed in range(options.first_seed, options.first_seed + options.seeds):
                wanted.append((room, accuracy, seed, options.solver, ";".join(options.set)))

    def work(key):
        grid, cpu = run(options.program, key[0], key[1], key[2], key[3], options.set)
        entry = {"key": key, "cpu": cpu, **judge(grid, references[key[0]])}
        return entry

    missing = [key for key in wanted if key not in done]
    with ThreadPoolExecutor(options.jobs) as pool, open(store, "a") as file:
        for number, entry in enumerate(pool.map(work, missing), 1):
            done[tuple(entry["key"])] = entry
            file.write(json.dumps(entry) + "\n")
            file.flush()
            if sys.stderr.isatty():
                print(f"\r{number} of {len(missing)} runs", end="", file=sys.stderr)

    print(f"{'room':6}{'asked':>7}{'runs':>6}{'points in':>11}{'means':>8}{'minima':>8}{'U0':>8}{'RMS %':>9}"
          f"{'RMS/asked':>11}{'largest %':>11}{'mean err %':>12}{'CPU s':>8}")
    for room in options.rooms.split(","):
        for accuracy in options.accuracies.split(","):
            rows = [done[k] for k in wanted if k[0] == room and k[1] == accuracy]
            if not rows:
                continue
            points = sum(r["points"] for r in rows)
            rms = 100 * math.sqrt(sum(r["squares"] for r in rows) / points)
            share = lambda name: f"{100 * sum(r[name] for r in rows) / len(rows):.1f}"
            cpu = sorted(r["cpu"] for r in rows)[len(rows) // 2]
            print(f"{room:6}{accuracy + ' %':>7}{len(rows):6}{100 * sum(r['inside'] for r in rows) / points:11.2f}"
                  f"{share('mean'):>8}{share('min'):>8}{share('u0'):>8}{rms:9.3f}{rms / float(accuracy):11.2f}"
                  f"{100 * max(r['largest'] for r in rows):11.2f}"
                  f"{100 * sum(r['mean_error'] for r in rows) / len(rows):12.4f}{cpu:8.3f}")


if __name__ == "__main__":
    main()
