# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs one suite of `grainproof bench` with tiny sizes and checks what it leaves: suites.py PROGRAM SUITE CACHE.

No time that was measured decides anything here.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

# Of each suite: what a row names, what it measures, the pictures that must be there.
SUITES = {
    "scaling": ({"scene", "engine", "precision", "size"}, {"particles", "step_s", "cundall_number",
                "bytes_per_particle"}, {"scaling_bed", "scaling_gas"}),
    "cundall": ({"scene", "engine", "precision", "threads"}, {"particles", "steps", "cundall_number", "cundall_min",
                "cundall_max", "bytes_per_particle", "bandwidth_share", "flops_share"},
                {"cundall_bed_900", "cundall_gas_900"}),
    "neighbours": ({"what", "engine", "precision"}, set(), {"neighbours_size", "neighbours_skin_bed_900",
                   "neighbours_skin_gas_900"}),
    "features": ({"scene", "engine", "precision", "feature", "with"}, {"step_s", "cundall_number"},
                 {"features_bed_900", "features_gas_900"}),
    "costs": ({"scene", "engine", "precision", "cost", "with"}, {"particles", "steps", "step_s", "cpu_step_s",
              "cundall_number", "bar"}, set()),
    "layout": ({"what", "way"}, {"particles", "ns_a_particle"}, {"layout"}),
    "peers": ({"scene", "engine", "precision", "processes"}, {"particles", "steps", "cundall_number", "cundall_min",
              "cundall_max", "bytes_per_particle"}, {"peers_bed_900", "peers_gas_900", "peers_ratios"}),
    "accuracy": ({"scene", "engine", "precision", "integrator"}, set(),
                 {f"accuracy_{scene}" for scene in ("head_on", "elastic", "hertz", "oblique", "cohesive", "drag",
                                                    "pair_gas", "packing", "gas", "bed")}),
    "stability": ({"scene", "engine", "precision", "integrator"}, set(), {"stability_agreement", "stability_settling",
                  "stability_euler_trapezoid", "stability_velocity_verlet"}),
    "long": ({"scene", "engine", "precision", "integrator", "quantity"}, {"steps", "measured", "bound"},
             {"long_bounces", "long_pile"}),
}
PEERS = {"lammps", "liggghts"}


def check(holds, what):
    if not holds:
        sys.exit(f"FAIL {what}")


def check_row(row, names, measured):
    check(names <= row.keys(), f"a row lacks {sorted(names - row.keys())}: {row}")
    if row["status"].startswith(("unsupported", "unstable")):
        check(row.get("integrator") not in ("velocity_verlet", "leapfrog_verlet") or "steps_per_contact" not in row,
              f"the field's scheme failed: {row}")
        return
    check(row["status"] == "completed", f"not measured: {row}")
    for key in measured:
        value = row.get(key)
        check(isinstance(value, (int, float)) and math.isfinite(value) and value >= 0.0, f"{key} is {value}: {row}")
    if "cundall_min" in measured:
        check(0.0 < row["cundall_min"] <= row["cundall_number"] <= row["cundall_max"], f"no range: {row}")


def check_accuracy(rows):
    """The closed forms must be met: an error that does not fall with the step is no error of the step."""
    measured = {"step", "steps", "error", "wall_s", "force_evaluations", "steps_per_contact"}
    for row in rows:
        if row["status"] != "completed" or row["scene"].startswith("known_"):
            continue
        check(measured <= row.keys(), f"a row lacks {sorted(measured - row.keys())}: {row}")
        if row["integrator"] == "velocity_verlet":
            most = 1.0 if row["scene"] == "bed" else 0.4  # whose scale is the slow motion that it settles with
            check(row["error"] < most / row["steps_per_contact"], f"too far from the exact solution: {row}")


def check_known_errors(results):
    """Live peers make the errors that they are known to make, or they are not what they are taken for."""
    known = {row["engine"]: row for row in results["known_errors"]}
    check(known.keys() == PEERS | {"reference"}, f"not held against the known errors: {known}")
    for row in known.values():
        check(row["reproduced"] and row["largest_deviation"] <= 0.05, f"other errors than known: {row}")


def check_work_precision(results):
    decades = {(row["scene"], row["side"]) for row in results["decades"]}
    check({("pair_gas", side) for side in PEERS | {"ours"}} <= decades, f"decades lack a side: {decades}")
    times = [row for row in results["times_to_error"] if row["wall_s"] is not None]
    check(times, "nothing reaches the error that is compared")
    for row in results["failed"]:
        check(row["status"] != "completed", f"not failed: {row}")


def check_orders(results):
    """First order with a dashpot, at least: the field's scheme."""
    orders = [row for row in results["orders"] if row["integrator"] == "velocity_verlet"]
    check(orders, "no orders")
    for row in orders:
        check(row["order"] > 0.7, f"an order below the scheme's: {row}")


def check_stability(rows, results):
    """Every limit is where it was predicted, on both engines, and what `run` permits is not above it."""
    limits = [row for row in rows if "predicted_s" in row]
    check({row["engine"] for row in limits} == {"reference", "opencl"}, "limits of one engine only")
    for row in limits:
        check(row["error"] <= row["bar"], f"not where predicted: {row}")
        check(row["permitted_s"] <= row["limit_s"] * (1.0 + row["bar"]), f"run permits more: {row}")
    undamped = [row for row in limits if row["integrator"] == "euler_trapezoid" and row["restitution"] == "none"]
    check(undamped, "the source's scheme was not tried without damping")
    for row in undamped:
        check(row["limit_s"] == 0.0 and row["growth_a_step"] > 0.0, f"stable without damping: {row}")
    settled = {row["step"]: row["overlap_error"] for row in rows
               if row["scene"] == "settling" and row["integrator"] == "euler_trapezoid" and row["engine"] == "reference"}
    check(settled[2e-4] < 1e-6 < 1.0 < settled[9.7e-4], f"the settling figure has another shape: {settled}")
    check(all(one["beyond"] == 0 for one in results["agreement"]), "the conclusion says otherwise")


def check_costs(results):
    """Each bound follows from its pairs, and the verdict from the bound: not from here."""
    seen = {(row["cost"], row["scene"], row["engine"]) for row in results["costs"]}
    check(("sentinels", "bed_900", "opencl") in seen and ("ledger", "gas_900", "reference") in seen, f"lacking: {seen}")
    check(not any(cost == "mixed" for cost, _, _ in seen), f"mixed is held against single alone: {seen}")
    for row in results["costs"]:
        check(row["pairs"] == 2 and 0.0 < row["bar"] < 1.0, f"no pairs or no bar: {row}")
        check(math.isfinite(row["mean"]) and row["mean"] <= row["bound"], f"no bound: {row}")
        check(row["verdict"] == ("yes" if row["bound"] <= row["bar"] else "no"), f"another verdict: {row}")
        check(row["cpu_mean"] <= row["cpu_bound"], f"no processor time: {row}")


def check_long(rows):
    """Every bound is held, the source's scheme is lost when it must be, and the default one has a curve."""
    for row in rows:
        if row["status"] == "completed":
            check(row["verdict"] == "held" and row["held"] == 1, f"not held: {row}")
            check(row["because"], f"a bound without a reason: {row}")
            check(row["quantity"] == "end" or sum(key.startswith("at_") for key in row) > 5, f"no curve: {row}")
    done = {(row["scene"], row["integrator"], row["quantity"]) for row in rows if row["status"] == "completed"}
    for needed in (("bounces", "velocity_verlet", "energy"), ("bounces", "euler_trapezoid", "end"),
                   ("pile", "velocity_verlet", "speed"), ("pile", "euler_trapezoid", "speed")):
        check(needed in done, f"not measured: {needed}")


def check_engines(suite, rows):
    engines = {row["engine"] for row in rows if row["status"] == "completed"} if suite != "layout" else {"opencl"}
    check("opencl" in engines, f"opencl was not measured: {engines}")
    if suite in ("peers", "accuracy"):
        check(PEERS <= engines, f"peers were not measured: {engines}")


def check_pictures(out, pictures):
    for name in pictures:
        picture = out / f"{name}.svg"
        check(picture.is_file(), f"there is no {picture.name}")
        drawn = xml.parse(picture).getroot()
        check(len(list(drawn.iter("{http://www.w3.org/2000/svg}path"))) > 5, f"{picture.name} is empty")


def main(program, suite, cache):
    names, measured, pictures = SUITES[suite]
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder)
        most = {"stability": "2", "long": "50"}.get(suite, "900")
        command = [program, "bench", suite, "--quick", "--most", most, "--rounds", "2", "--seconds", "0.002",
                   "--engines", "reference,opencl:double", "--cache", cache, "--out", folder]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        check(done.returncode == 0, f"{' '.join(command)} ended with {done.returncode}:\n{done.stderr}")
        check(suite in done.stdout, f"no table:\n{done.stdout}")
        results = json.loads((out / "results.json").read_text(encoding="utf-8"))
        check(results["schema"] == 1 and results["machine"]["processor"], "no schema or machine")
        check(results["complete"] is True, "the results say that they are not complete")
        rows = [row for row in results["results"] if row["suite"] == suite]
        check(rows, "no rows")
        for row in rows:
            check_row(row, names, measured)
        check_engines(suite, rows)
        if suite == "accuracy":
            check_accuracy(rows)
            check_orders(results)
            check_known_errors(results)
            check_work_precision(results)
        if suite == "stability":
            check_stability(rows, results)
        if suite == "costs":
            check_costs(results)
        if suite == "long":
            check_long(rows)
        check_pictures(out, pictures)
        page = (out / "index.html").read_text(encoding="utf-8")
        for name in pictures:
            check(f'<img id="{name}"' in page, f"index.html lacks {name}")
        check('src="http' not in page and 'href="http' not in page, "index.html needs the network")


if __name__ == "__main__":
    main(*sys.argv[1:])
