#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the sentinels cost in a bed: pairs of runs with and without them, in turn, and the upper bound of their ratio.

    benchmarks/sentinels.py PROGRAM [--scene FILE] [--end SECONDS] [--pairs N] [--engine NAME]

PROGRAM is a built grainproof. The bound is one-sided, of 95 per cent, by Student's t. Exit code 1 where it is above 2 %.
"""
import argparse
import json
import math
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
BAR = 0.02
# Student's t of 95 per cent, one-sided, by degrees of freedom; between them the one before, which is the wider.
STUDENT = {1: 6.314, 2: 2.920, 3: 2.353, 4: 2.132, 6: 1.943, 9: 1.833, 14: 1.761, 19: 1.729, 29: 1.699, 59: 1.671}


def seconds(options, scene, folder, without):
    summary = folder / "summary.json"
    command = [options.program, "run", scene, "--engine", options.engine, "--no-ledger", "--no-self-test", "--quiet",
               "--json", summary]
    subprocess.run(command + (["--no-sentinels"] if without else []), check=True, stdout=subprocess.DEVNULL,
                   env={**os.environ, "GRAINPROOF_DATA": str(ROOT)})
    return json.loads(summary.read_text())["wall_s"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--scene", type=pathlib.Path, default=ROOT / "benchmarks/scenes/bed_100k.toml")
    parser.add_argument("--end", type=float, default=1e-2)
    parser.add_argument("--pairs", type=int, default=30)
    parser.add_argument("--engine", default="opencl:single")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        scene = folder / "bed.toml"
        text, ends = re.subn(r"(?m)^end = \S+", f"end = {options.end}", options.scene.read_text())
        if ends != 1:
            sys.exit(f"{options.scene} has no line 'end = …' of its own")
        scene.write_text(text)
        seconds(options, scene, folder, True)  # compiles
        costs = []
        for pair in range(options.pairs):
            first = seconds(options, scene, folder, pair % 2 == 0)
            second = seconds(options, scene, folder, pair % 2 == 1)
            costs.append(math.log(second / first) * (1 if pair % 2 == 0 else -1))
            print(f"pair {pair + 1}: {first:.3f} s, {second:.3f} s, cost {math.expm1(costs[-1]):+.2%}", file=sys.stderr)
    mean, few = statistics.fmean(costs), len(costs) - 1
    if few < 1:
        sys.exit("at least two pairs are needed for a bound")
    student = STUDENT[max(known for known in STUDENT if known <= few)]
    bound = math.expm1(mean + student * statistics.stdev(costs) / math.sqrt(len(costs)))
    print(f"sentinels cost {math.expm1(mean):+.2%}, at most {bound:+.2%} (95 %, {len(costs)} pairs)")
    return 0 if bound <= BAR else 1


if __name__ == "__main__":
    sys.exit(main())
