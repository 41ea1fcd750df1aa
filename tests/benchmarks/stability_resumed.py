# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
"""The map of stable steps is killed, started again, and must come out as if nothing had been: stability_resumed.py PROGRAM.

With two threads, which must give what one gives.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import time

OPTIONS = ["--quick", "--engines=reference", "--scenes=pair,wall,settling", "--benchmark_out_format=json"]
TIMES = {"wall_s", "cpu_time", "run_time"}  # what may differ


def check(holds, what):
    if not holds:
        sys.exit(f"FAIL {what}")


def started(program, cache, report, threads):
    return subprocess.Popen([program, *OPTIONS, f"--cache={cache}", f"--benchmark_out={report}", f"--threads={threads}"],
                            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)


def rows_of(report):
    rows = json.loads(report.read_text(encoding="utf-8"))["benchmarks"]
    return [{key: value for key, value in row.items() if key not in TIMES} for row in rows]


def kept_in(file):
    return file.read_text(encoding="utf-8").count("\n") - 1 if file.exists() else 0


def killed_once_it_has(rows, kept, program, cache, report):
    running = started(program, cache, report, 2)
    until = time.monotonic() + 60.0
    while kept_in(kept) < rows and running.poll() is None and time.monotonic() < until:
        time.sleep(0.001)
    running.kill()
    running.communicate()
    check(running.returncode == -9, f"it had ended before it was killed: {running.returncode}")
    return kept_in(kept)


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        kept = folder / "killed" / "stability" / "quick.jsonl"
        before = killed_once_it_has(10, kept, program, folder / "killed", folder / "killed.json")
        check(before >= 10, f"{before} rows were kept")
        again = started(program, folder / "killed", folder / "killed.json", 2)
        text, _ = again.communicate()
        check(again.returncode == 0, f"it ended with {again.returncode}:\n{text}")
        check("note: stability goes on after" in text, f"it began anew:\n{text}")
        check(not kept.exists(), "what was kept is still there")
        whole = started(program, folder / "whole", folder / "whole.json", 1)
        text, _ = whole.communicate()
        check(whole.returncode == 0 and "goes on" not in text, f"the whole one: {text}")
        found, expected = rows_of(folder / "killed.json"), rows_of(folder / "whole.json")
        check(len(expected) > 50, f"{len(expected)} rows")
        for one, other in zip(found, expected, strict=True):
            check(one == other, f"not the same:\n{one}\n{other}")


if __name__ == "__main__":
    main(*sys.argv[1:])
