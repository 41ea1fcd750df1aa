#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plants every mistake and counts those that the cases notice: caught out of planted, by which case, and how long.

    tests/faults/score.py BUILD [--quick] [--panel]

BUILD is a build folder. --quick plants only the kernels' faults of every day; --panel asks of every host fault for
the cheapest case that catches it. Exit code 1 where a fault escaped.
"""
import argparse
import collections
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def planted_by(program, gtest_filter):
    """(name, file, case, caught, seconds) of each fault of one program."""
    with tempfile.TemporaryDirectory() as folder:
        results = pathlib.Path(folder) / "results.json"
        subprocess.run([program, f"--gtest_filter={gtest_filter}", f"--gtest_output=json:{results}"], cwd=ROOT,
                       stdout=subprocess.DEVNULL, check=False)
        suites = json.loads(results.read_text())["testsuites"]
    for suite in suites:
        for test in suite["testsuite"]:
            if "of" in test and test["result"] == "COMPLETED":
                name = test["name"].split("/")[1]
                yield name, test["of"], test["case"], "failures" not in test, float(test["time"].rstrip("s"))


def cheapest_cases(program):
    run = subprocess.run([program, "--gtest_also_run_disabled_tests", "--gtest_filter=Panel.*"], cwd=ROOT,
                         stdout=subprocess.PIPE, text=True, check=True)
    return dict(line.split()[1:3] for line in run.stdout.splitlines() if line.startswith("panel "))


def cpu_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--panel", action="store_true")
    options = parser.parse_args()
    programs = options.build.resolve() / "tests" / "faults"
    kernels = "Quick/*" if options.quick else "Quick/*:Planted/*"
    faults = list(planted_by(programs / "host_faults_test", "Planted/*"))
    faults += planted_by(programs / "kernel_faults_test", kernels)
    cpu = cpu_seconds()
    cheapest = cheapest_cases(programs / "host_faults_test") if options.panel else {}
    for name, file, case, caught, seconds in sorted(faults, key=lambda fault: (fault[3], fault[1], fault[0])):
        print(f"{'caught ' if caught else 'ESCAPED'} {name:36} {file:52} {case:28} {seconds:7.2f} s {cheapest.get(name, '')}")
    catches = collections.Counter(case for _, _, case, caught, _ in faults if caught)
    print("\nby case: " + ", ".join(f"{case} {count}" for case, count in catches.most_common()))
    caught = sum(fault[3] for fault in faults)
    wall = sum(fault[4] for fault in faults)
    print(f"caught {caught} of {len(faults)} planted; {wall:.0f} s, {cpu:.0f} s of CPU")
    return 0 if faults and caught == len(faults) else 1


if __name__ == "__main__":
    sys.exit(main())
