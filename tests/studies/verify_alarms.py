#!/usr/bin/env python3
"""Does `goniolux verify` keep its rate of false alarms, and does it see what it must?

    tests/studies/verify_alarms.py unchanged [--runs 1000] [--accuracy "5 %"] [--projects R1,R2,...] [--store DIR]
    tests/studies/verify_alarms.py planted   [--baseline "1 %"] [--store DIR]
    tests/studies/verify_alarms.py batch     [--count 100] [--store DIR]

unchanged: baselines of the sample projects (grids only), then re-runs of the batch with other seeds and thread counts;
each is a line of the store (JSON), so that the command can be stopped and started again. Prints alarms, batches and the
stated rate with the interval of the rate found (Clopper-Pearson would need scipy; the Poisson bound is given).

planted: one reflectance changed by 1 %, one luminaire dimmed by 3 %, one luminaire turned, one spectrum swapped, each
alone in a copy of a small room made for it; the baseline at the accuracy named. Prints what verify flags, first
without the input hashes (they are taken out of the baseline), then what it names with them.

batch: that many copies of a small room in one command, killed in the middle, resumed; one project corrupted. Prints times and verdicts.
"""
import argparse
import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("GONIOLUX", str(ROOT / "build/release/bin/goniolux"))
SAMPLES = ["small-office", "gallery", "corridor-fluorescent", "validation/R1", "validation/R2", "validation/R3", "validation/R4",
           "validation/cube", "validation/room-a", "validation/room-b", "validation/room-c"]

# One coloured wall, one luminaire off the middle with a distribution that is not rotational, fluorescent light.
ROOM = {
    "format": "goniolux-project", "version": 1, "name": "Planted changes", "units": "m",
    "materials": {"paint": {"model": "lambert", "diffuse": 0.70}, "floor": {"model": "lambert", "diffuse": 0.20},
                  "red": {"model": "lambert", "diffuse": "red-paint.spd"}},
    "objects": [{"name": "room", "shape": "box", "min": [0, 0, 0], "max": [5, 4, 2.8], "facing": "inward",
                 "materials": {"floor": "floor", "walls": "paint", "ceiling": "paint", "xmin": "red"}}],
    "luminaires": [
        {"name": "A", "photometry": "batten-t8.ldt", "position": [1.5, 2, 2.6], "spectrum": "CIE FL11"},
        {"name": "B", "photometry": "batten-t8.ldt", "position": [3.5, 2, 2.6], "spectrum": "CIE FL11"}],
    "grids": [{"name": "work plane", "origin": [0.5, 0.5, 0.8], "u": [4, 0, 0], "v": [0, 3, 0], "counts": [12, 9],
               "normal": [0, 0, 1], "quantity": "illuminance"}],
}


def goniolux(*arguments, check=None):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    if check is not None and done.returncode not in check:
        sys.exit(f"goniolux {' '.join(map(str, arguments))}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done


def unchanged(options):
    store = Path(options.store)
    projects = store / "projects"
    names = options.projects.split(",") if options.projects else SAMPLES
    key = {"accuracy": options.accuracy, "projects": names}
    keyfile = store / "key.json"
    if keyfile.exists() and json.loads(keyfile.read_text()) != key:
        sys.exit(f"{store} holds other runs; name another --store or remove it")
    if not keyfile.exists():
        for name in names:
            source = next(p for p in (ROOT / "projects" / name, ROOT / "projects/validation" / name) if p.is_dir())
            target = projects / name.replace("/", "-")
            shutil.copytree(source, target, ignore=shutil.ignore_patterns("results", "expected.json"))
        goniolux("verify", projects, "-o", store / "out", "--update", "--accuracy", options.accuracy, "--quiet", check=(0,))
        keyfile.write_text(json.dumps(key))
    log = store / "runs.jsonl"
    done = [json.loads(line) for line in log.read_text().splitlines()] if log.exists() else []
    for seed in range(1000 + len(done), 1000 + options.runs):
        run = goniolux("verify", projects, "-o", store / "out", "--json", "--quiet", "--seed", seed, "-j", 1 + seed % 2,
                       "--threads", 1 + seed % 2, check=(0, 1))
        document = json.loads(run.stdout)
        alarms = [d["text"] for p in document["projects"] for d in p["differences"]]
        done.append({"seed": seed, "projects": len(document["projects"]), "values": document["values"], "alarms": alarms})
        with open(log, "a") as file:
            file.write(json.dumps(done[-1]) + "\n")
    batches = len(done)
    alarmed = [d for d in done if d["alarms"]]
    reruns = sum(d["projects"] for d in done)
    print(f"{batches} batches of {len(names)} projects, {reruns} re-runs, {done[0]['values'] if done else 0} values a batch")
    print(f"batches with an alarm: {len(alarmed)} ({100 * len(alarmed) / max(1, batches):.2f} %); stated: at most 1 %")
    if not alarmed and batches:
        print(f"none found: with 95 % confidence the rate is below {300 / batches:.2g} %")
    for d in alarmed:
        print(f"  seed {d['seed']}: " + "; ".join(d["alarms"]))


def planted(options):
    def reflectance(p):
        p["materials"]["paint"]["diffuse"] = 0.707

    def dimmed(p):
        p["luminaires"][0]["dimming"] = 0.97

    def turned(p):
        p["luminaires"][0]["turn"] = 90

    def spectrum(p):
        for luminaire in p["luminaires"]:
            luminaire["spectrum"] = "CIE A"

    store = Path(options.store)
    folder = store / "planted"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "project.json").write_text(json.dumps(ROOM))
    goniolux("verify", folder, "-o", store / "out", "--update", "--accuracy", options.baseline, "--quiet", check=(0,))
    expected = json.loads((folder / "expected.json").read_text())
    mean = next(v for v in expected["values"] if v["quantity"] == "mean")
    print(f"baseline: mean {mean['value']:.2f} ± {mean['half_width']:.2f} lx ({100 * mean['half_width'] / mean['value']:.2f} %)")
    blind = {k: v for k, v in expected.items() if k not in ("inputs", "entries")}
    missed = 0
    for name, change in [("1 % of one reflectance", reflectance), ("a luminaire dimmed to 97 %", dimmed),
                         ("a luminaire turned by 90 degrees", turned), ("spectrum FL11 -> A", spectrum)]:
        project = json.loads(json.dumps(ROOM))
        change(project)
        (folder / "project.json").write_text(json.dumps(project))
        (folder / "expected.json").write_text(json.dumps(blind))
        found = json.loads(goniolux("verify", folder, "-o", store / "out", "--json", "--quiet", "--seed", 77, "--accuracy",
                                    options.baseline, check=(0, 1)).stdout)["projects"][0]
        (folder / "expected.json").write_text(json.dumps(expected))
        named = json.loads(goniolux("verify", folder, "-o", store / "out", "--json", "--quiet", "--seed", 77, check=(0, 1)).stdout)["projects"][0]
        ok = found["verdict"] == "fail" and named["changed_inputs"] and named["verdict"] == "fail"
        missed += not ok
        print(f"{'caught' if ok else 'MISSED'}: {name}\n  named: {'; '.join(named['changed_inputs'])}")
        for difference in found["differences"]:
            print("  " + difference["text"])
    sys.exit(1 if missed else 0)


def batch(options):
    store = Path(options.store)
    projects = store / "many"
    shutil.rmtree(store, ignore_errors=True)
    for i in range(options.count):
        folder = projects / f"p{i:03}"
        folder.mkdir(parents=True)
        project = json.loads(json.dumps(ROOM))
        project["name"] = f"Room {i}"
        (folder / "project.json").write_text(json.dumps(project))
    begin = time.time()
    goniolux("verify", projects, "-o", store / "out", "--update", "--accuracy", "5 %", "--quiet", check=(0,))
    took = time.time() - begin
    print(f"{options.count} baselines in {took:.1f} s")
    (projects / "p007/project.json").write_text('{ "format": "goniolux-project", "version": 1,')
    command = [PROGRAM, "verify", str(projects), "-o", str(store / "out2"), "--seed", "5"]
    first = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    time.sleep(0.5 * took)
    first.send_signal(signal.SIGKILL)
    first.wait()
    kept = len(list((store / "out2/projects").glob("*/outcome.json")))
    begin = time.time()
    second = subprocess.run(command + ["--resume", "--json"], capture_output=True, text=True)
    document = json.loads(second.stdout)
    verdicts = {}
    for project in document["projects"]:
        verdicts[project["verdict"]] = verdicts.get(project["verdict"], 0) + 1
    print(f"killed with {kept} finished; resumed in {time.time() - begin:.1f} s, exit code {second.returncode}: {verdicts}")
    print("the corrupted one: " + next(p["error"] for p in document["projects"] if p["verdict"] == "error"))
    lines = [line for line in first.stderr.read().splitlines() if "left" in line]
    print("progress: " + (lines[-1] if lines else "(too short for a line)"))
    ok = 0 < kept < options.count and verdicts.get("pass") == options.count - 1 and verdicts.get("error") == 1
    sys.exit(0 if ok else 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["unchanged", "planted", "batch"])
    parser.add_argument("--runs", type=int, default=1000)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--accuracy", default="5 %")
    parser.add_argument("--baseline", default="1 %")
    parser.add_argument("--projects", default="")
    parser.add_argument("--store", default="")
    options = parser.parse_args()
    options.store = options.store or f"/var/tmp/goniolux-verify-{options.what}"
    {"unchanged": unchanged, "planted": planted, "batch": batch}[options.what](options)


if __name__ == "__main__":
    main()
