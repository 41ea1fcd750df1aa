# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the results of `grainproof bench`: plots.py RESULTS.json FOLDER. One SVG a picture."""
import json
import pathlib
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402  (after the backend is chosen)
import numpy as np  # noqa: E402

# Okabe and Ito's colours, told apart by everyone; an engine has one everywhere.
COLOURS = {
    "reference": "#000000",
    "opencl": "#0072b2",
    "liggghts": "#d55e00",
    "lammps": "#009e73",
    "other": "#cc79a7",
}
MARKERS = {"double": "o", "single": "s", "mixed": "D"}
LINES = {"double": "-", "single": "--", "mixed": "-."}

plt.rcParams.update({
    "svg.fonttype": "none",
    "svg.hashsalt": "grainproof",
    "font.size": 10,
    "axes.grid": True,
    "grid.color": "#dddddd",
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "figure.figsize": (7.0, 4.4),
    "figure.constrained_layout.use": True,
    "legend.frameon": False,
})


def style(row):
    precision = row.get("precision", "double")
    return {
        "color": COLOURS.get(row.get("engine"), COLOURS["other"]),
        "marker": MARKERS.get(precision, "^"),
        "linestyle": LINES.get(precision, ":"),
        "markersize": 5,
    }


def engine_label(row):
    return row["engine"] + (f" {row['precision']}" if row["engine"] == "opencl" else "")


def groups(rows, *keys):
    """Rows by what they have under `keys`, in the order in which they first come."""
    found = {}
    for row in rows:
        found.setdefault(tuple(row.get(key) for key in keys), []).append(row)
    return found


def save(figure, folder, name):
    figure.savefig(folder / f"{name}.svg", metadata={"Date": None})
    plt.close(figure)


def scaling(rows, results, folder):
    for (scene,), of_scene in groups(rows, "scene").items():
        figure, axes = plt.subplots()
        for curve in groups(of_scene, "engine", "precision").values():
            points = sorted((row["particles"], row["step_s"] / row["particles"]) for row in curve)
            exponent = [fit["exponent"] for fit in results.get("fits", [])
                        if fit["suite"] == "scaling" and fit["over"] == "all" and "exponent" in fit
                        and all(fit[key] == curve[0][key] for key in ("scene", "engine", "precision"))]
            label = engine_label(curve[0]) + "".join(f", time ~ N^{value:.3f}" for value in exponent)
            axes.plot(*zip(*points), label=label, **style(curve[0]))
        axes.set(xscale="log", yscale="log", xlabel="particles", ylabel="seconds a particle-step",
                 title=f"Run time against size: {scene}")
        axes.legend()
        save(figure, folder, f"scaling_{scene}")


def bars(axes, rows, label):
    """C of each row with its range over the rounds."""
    places = np.arange(len(rows))
    values = np.array([row["cundall_number"] for row in rows]) / 1e6
    ranges = np.abs(np.array([[row["cundall_min"], row["cundall_max"]] for row in rows]).T / 1e6 - values)
    colours = [COLOURS.get(row["engine"], COLOURS["other"]) for row in rows]
    axes.barh(places, values, xerr=ranges, color=colours, ecolor="#666666", height=0.7)
    axes.set_yticks(places, [label(row) for row in rows])
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("million particle-steps a second")


def cundall(rows, _, folder):
    for (scene,), of_scene in groups(rows, "scene").items():
        figure, axes = plt.subplots(figsize=(7.0, 1.2 + 0.35 * len(of_scene)))
        bars(axes, of_scene, lambda row: f"{engine_label(row)}, {row['threads']} threads")
        axes.set_title(f"Speed: {scene}")
        save(figure, folder, f"cundall_{scene}")


PICTURES = {"scaling": scaling, "cundall": cundall}


def main(results_file, folder):
    results = json.loads(pathlib.Path(results_file).read_text(encoding="utf-8"))
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    measured = [row for row in results["results"] if row["status"] == "completed"]
    for (suite,), rows in groups(measured, "suite").items():
        if suite in PICTURES:
            PICTURES[suite](rows, results, folder)


if __name__ == "__main__":
    main(*sys.argv[1:])
