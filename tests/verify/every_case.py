# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
"""The main job as a user runs it while working: every quick case on every engine.

Usage: every_case.py PROGRAM SCENES. Fails unless all rows hold, every quick case was judged on the reference and
on OpenCL in single and double (or is what they are held against), those with a claim for mixed alone on that too, and
the peers have judged what they can.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

OUR_ENGINES = {"reference", "opencl:single", "opencl:double"}
PEERS = {"liggghts", "lammps"}
CASES_FOR_PEERS = {"normal_collision", "normal_collision_wall", "settling", "sliding_dynamic", "drag"}


def judged(results, case, engine):
    return [row for row in results if row["case"] == case and row["engine"] == engine and row["verdict"] == "pass"]


def engine_of(row):
    name = row["engine"]
    return name if ":" in name or row["precision"] in ("", None) or name != "opencl" else f"opencl:{row['precision']}"


def complaints(results, cases, cases_for_mixed):
    for row in results:
        row["engine"] = engine_of(row)
        if row["verdict"] == "fail":
            yield f"{row['case']}, {row['engine']}, {row['quantity']} at {row['step']}: {row['reason']}"
        if row["verdict"] == "unsupported" and row["engine"] in OUR_ENGINES:
            yield f"{row['case']} is not supported by {row['engine']}: {row['reason']}"
    for case in cases:
        held_against = {row.get("against") for row in results if row["case"] == case}
        for engine in OUR_ENGINES:
            if not judged(results, case, engine) and f"engine:{engine}" not in held_against:
                yield f"{case} was not judged on {engine}"
    for case in cases_for_mixed:
        if not judged(results, case, "opencl:mixed"):
            yield f"{case} was not judged on opencl:mixed"
    for case in CASES_FOR_PEERS:
        for peer in PEERS:
            if not judged(results, case, peer):
                yield f"{case} was not judged on {peer}"


def is_quick(path):
    return tomllib.loads(path.read_text()).get("tier", "quick") == "quick"


def is_for_mixed(path):
    return any(claim.get("engines") == ["opencl:mixed"] for claim in tomllib.loads(path.read_text()).get("expect", []))


def main(program, scenes):
    files = [path for path in pathlib.Path(scenes).rglob("*.toml") if is_quick(path)]
    cases = sorted(path.stem for path in files)
    cases_for_mixed = sorted(path.stem for path in files if is_for_mixed(path))
    with tempfile.TemporaryDirectory() as folder:
        results_file = pathlib.Path(folder) / "results.json"
        run = subprocess.run([program, "verify", "--quick", "--quiet", "--json", results_file], stdout=subprocess.PIPE, text=True)
        results = json.loads(results_file.read_text())["results"]
    found = list(complaints(results, cases, cases_for_mixed))
    print("\n".join(run.stdout.splitlines()[-len(cases) - 4:]))
    print("\n".join(found))
    return 1 if found or run.returncode != 0 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
