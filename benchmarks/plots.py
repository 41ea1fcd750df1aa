# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the results of `grainproof bench`: plots.py RESULTS.json FOLDER. One SVG a picture."""
import json
import pathlib
import sys

import matplotlib.pyplot as plt
import numpy as np

from plot_accuracy import accuracy
from plot_long import long_runs
from plot_stability import stability
from plot_style import COLOURS, engine_label, groups, save, style


def scaling(rows, results, folder):
    for (scene,), of_scene in groups(rows, "scene").items():
        figure, axes = plt.subplots()
        for curve in groups(of_scene, "engine", "precision").values():
            points = sorted((row["particles"], row["step_s"] / row["particles"]) for row in curve)
            exponent = [fit["exponent"] for fit in results.get("fits", [])
                        if fit["suite"] == "scaling" and fit["over"] == "all sizes" and "exponent" in fit
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


def counted(number, one, more):
    return f"{number} {one if number == 1 else more}"


def cundall(rows, _, folder):
    for (scene,), of_scene in groups(rows, "scene").items():
        figure, axes = plt.subplots(figsize=(7.0, 1.2 + 0.35 * len(of_scene)))
        bars(axes, of_scene, lambda row: f"{engine_label(row)}, {counted(row['threads'], 'thread', 'threads')}")
        axes.set_title(f"Speed: {scene}")
        save(figure, folder, f"cundall_{scene}")


def curves(axes, rows, x, y, label, **more):
    for curve in groups(rows, "engine", "precision", *more.get("by", ())).values():
        points = sorted((row[x], row[y]) for row in curve if row.get(y, 0) > 0)
        if points:
            axes.plot(*zip(*points), label=label(curve[0]), **style(curve[0]))


def neighbours(rows, _, folder):
    figure, axes = plt.subplots()
    searches = [row for row in rows if row["what"] != "skin"]
    for (_, _, way), curve in groups(searches, "engine", "precision", "way").items():
        for key, name in (("update_s", "an update"), ("step_s", "a step")):
            points = sorted((row["particles"], row[key]) for row in curve if key in row)
            if points:
                axes.plot(*zip(*points), "o-" if key == "update_s" else "s:", markersize=4,
                          label=f"{name}: {engine_label(curve[0])}, {way}")
    axes.set(xscale="log", yscale="log", xlabel="particles", ylabel="seconds", title="Searching neighbours: gas")
    axes.legend(fontsize=7)
    save(figure, folder, "neighbours_size")
    for (scene,), of_scene in groups([row for row in rows if row["what"] == "skin"], "scene").items():
        figure, axes = plt.subplots()
        curves(axes, of_scene, "skin", "step_s", engine_label)
        axes.set(yscale="log", xlabel="skin / diameters", ylabel="seconds a step", title=f"Best skin: {scene}")
        axes.legend()
        save(figure, folder, f"neighbours_skin_{scene}")


def ratio_bars(ratios, title, x_label, label):
    """Medians with their range over the rounds, and a line at 1."""
    figure, axes = plt.subplots(figsize=(7.5, 1.2 + 0.3 * len(ratios)))
    values = np.array([ratio["median"] for ratio in ratios])
    ranges = np.abs(np.array([[ratio["min"], ratio["max"]] for ratio in ratios]).T - values)
    colours = [COLOURS.get(ratio["engine"], COLOURS["other"]) for ratio in ratios]
    axes.barh(np.arange(len(ratios)), values, xerr=ranges, color=colours, ecolor="#666666", height=0.7)
    axes.set_yticks(np.arange(len(ratios)), [label(ratio) for ratio in ratios], fontsize=8)
    axes.axvline(1.0, color="#444444", linewidth=1)
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.set(xlabel=x_label, title=title)
    return figure


def features(_, results, folder):
    for (scene,), ratios in groups([ratio for ratio in results.get("ratios", []) if ratio["suite"] == "features"],
                                   "scene").items():
        figure = ratio_bars(ratios, f"What features cost: {scene}", "time with over time without",
                            lambda ratio: f"{ratio['feature']}, {engine_label(ratio)}")
        save(figure, folder, f"features_{scene}")


def layout(rows, _, folder):
    figure, axes = plt.subplots(figsize=(7.0, 1.2 + 0.35 * len(rows)))
    axes.barh(np.arange(len(rows)), [row["ns_a_particle"] for row in rows], color=COLOURS["opencl"], height=0.7)
    axes.set_yticks(np.arange(len(rows)), [f"{row['what']}: {row['way']}" for row in rows])
    axes.set_xscale("log")
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.set(xlabel="nanoseconds a particle", title="Layouts")
    save(figure, folder, "layout")


def peers(rows, results, folder):
    for (scene,), of_scene in groups(rows, "scene").items():
        figure, axes = plt.subplots(figsize=(7.0, 1.2 + 0.35 * len(of_scene)))
        bars(axes, of_scene, lambda row: f"{engine_label(row)}, {counted(row['processes'], 'process', 'processes')}")
        axes.set_title(f"Beside the peers: {scene}")
        save(figure, folder, f"peers_{scene}")
    ratios = [ratio for ratio in results.get("ratios", []) if ratio["suite"] == "peers"]
    if ratios:
        save(ratio_bars(ratios, "Speed over the peers'", "ratio of Cundall numbers", lambda ratio: ratio["what"]),
             folder, "peers_ratios")


PICTURES = {
    "scaling": scaling,
    "cundall": cundall,
    "neighbours": neighbours,
    "features": features,
    "layout": layout,
    "peers": peers,
    "accuracy": accuracy,
    "stability": stability,
    "long": long_runs,
}


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
