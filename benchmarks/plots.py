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


def cundall(rows, _, folder):
    for (scene,), of_scene in groups(rows, "scene").items():
        figure, axes = plt.subplots(figsize=(7.0, 1.2 + 0.35 * len(of_scene)))
        bars(axes, of_scene, lambda row: f"{engine_label(row)}, {row['threads']} threads")
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
        bars(axes, of_scene, lambda row: f"{engine_label(row)}, {row['processes']} processes")
        axes.set_title(f"Beside the peers: {scene}")
        save(figure, folder, f"peers_{scene}")
    ratios = [ratio for ratio in results.get("ratios", []) if ratio["suite"] == "peers"]
    if ratios:
        save(ratio_bars(ratios, "Speed over the peers'", "ratio of Cundall numbers", lambda ratio: ratio["what"]),
             folder, "peers_ratios")


def pareto(points):
    """Of (time, error) those that no other beats in both."""
    front = []
    for seconds, error in sorted(points):
        if not front or error < front[-1][1]:
            front.append((seconds, error))
    return front


SIDES = {"lammps": "LAMMPS", "liggghts": "LIGGGHTS"}
SIDE_COLOURS = {"ours": COLOURS["opencl"], "LAMMPS": COLOURS["lammps"], "LIGGGHTS": COLOURS["liggghts"]}


def errors_against_steps(axes, rows):
    """A colour an integrator, a marker a precision; peers in their own colours."""
    integrators = sorted({row["integrator"] for row in rows if row["engine"] not in SIDES})
    shades = dict(zip(integrators, plt.get_cmap("tab10").colors))
    for curve in groups(rows, "engine", "precision", "integrator").values():
        first = curve[0]
        peer = first["engine"] in SIDES
        look = style(first) | ({"linewidth": 3, "alpha": 0.5} if peer else {"color": shades[first["integrator"]]})
        label = SIDES[first["engine"]] if peer else f"{engine_label(first)}, {first['integrator']}"
        points = sorted((row["steps_per_contact"], row["error"]) for row in curve)
        axes.plot(*zip(*points), label=label, **look)
    uncertainty = max((row.get("uncertainty", 0.0) for row in rows), default=0.0)
    if uncertainty > 0:
        axes.axhline(uncertainty, color="#888888", linestyle=":", label="error of the solution compared with")


def times_against_errors(axes, rows):
    """Every point, and of each side those that no other beats in both."""
    sides = {}
    for row in rows:
        sides.setdefault(SIDES.get(row["engine"], "ours"), []).append((row["wall_s"], row["error"]))
    for side, points in sides.items():
        axes.plot(*zip(*points), ".", color=SIDE_COLOURS[side], alpha=0.35)
        axes.plot(*zip(*pareto(points)), "-", color=SIDE_COLOURS[side], linewidth=2, drawstyle="steps-post",
                  label=side)


def accuracy(rows, _, folder):
    for (scene,), of_scene in groups(rows, "scene").items():
        of_scene = [row for row in of_scene if row["error"] > 0]
        if scene.startswith("known_") or not of_scene:
            continue
        figure, (left, right) = plt.subplots(1, 2, figsize=(12.0, 5.4), sharey=True)
        errors_against_steps(left, of_scene)
        times_against_errors(right, of_scene)
        left.set(xscale="log", yscale="log", xlabel="steps a contact", ylabel="rms error of the velocity",
                 title=f"Error against step: {scene}")
        left.legend(fontsize=6)
        right.set(xscale="log", xlabel="run time / s", title="Run time against error, Pareto fronts")
        right.legend()
        save(figure, folder, f"accuracy_{scene}")


def stability_settling(rows, folder):
    figure, axes = plt.subplots()
    for curve in groups(rows, "engine", "precision", "integrator", "end").values():
        first = curve[0]
        look = style(first) | {"alpha": 1.0 if first["integrator"] == "euler_trapezoid" else 0.4}
        look["markerfacecolor"] = "none" if first["end"] < 10 else look["color"]
        points = sorted((row["step"], max(row["overlap_error"], 1e-17)) for row in curve)
        axes.plot(*zip(*points), label=f"{engine_label(first)}, {first['integrator']}, {first['end']} s", **look)
    axes.axvline(9.17098e-4, color="#444444", linewidth=1)
    axes.text(9.1e-4, 1e-8, "2 η/k", rotation=90, ha="right")
    axes.set(yscale="log", xlabel="step / s", ylabel="|overlap − m g/k| / (m g/k)", title="Settling overlap against step")
    axes.legend(fontsize=7)
    save(figure, folder, "stability_settling")


RESTITUTIONS = ["none", "1", "0.95", "0.8", "0.5", "0.1", "0", "overdamped"]


def stability_map(rows, integrator, folder):
    """Stable share of a contact: a line an arrangement, a column a restitution."""
    lines = list(groups(rows, "scene", "mass_ratio", "stiffness_ratio", "friction"))
    columns = [one for one in RESTITUTIONS if any(str(row["restitution"]) == one for row in rows)]
    values = np.full((len(lines), len(columns)), np.nan)
    for row in rows:
        line = lines.index((row["scene"], row["mass_ratio"], row["stiffness_ratio"], row["friction"]))
        values[line, columns.index(str(row["restitution"]))] = row["share_of_contact"]
    figure, axes = plt.subplots(figsize=(3.5 + 0.7 * len(columns), 1.2 + 0.22 * len(lines)))
    image = axes.imshow(values, aspect="auto", cmap="viridis", vmin=0.0, vmax=0.65)
    for (line, column), value in np.ndenumerate(values):
        if not np.isnan(value):
            axes.text(column, line, f"{value:.3f}", ha="center", va="center", fontsize=7,
                      color="white" if value < 0.4 else "black")
    axes.set_xticks(range(len(columns)), columns)
    axes.set_yticks(range(len(lines)), [f"{scene}, m {mass}, k {stiff}" + (", friction" if friction == "history" else "")
                                        for scene, mass, stiff, friction in lines], fontsize=7)
    axes.grid(visible=False)
    axes.set(xlabel="restitution", title=f"Largest stable step, shares of a contact: {integrator}")
    figure.colorbar(image, ax=axes, shrink=0.6)
    save(figure, folder, f"stability_{integrator}")


def stability_agreement(rows, folder):
    figure, axes = plt.subplots()
    for place, ((scene,), of_scene) in enumerate(groups(rows, "scene").items()):
        for (_, _), curve in groups(of_scene, "engine", "precision").items():
            jitter = place + np.linspace(-0.3, 0.3, len(curve))
            axes.plot(jitter, [100 * row["error"] for row in curve], **(style(curve[0]) | {"linestyle": "", "markersize": 3}))
    names = list(groups(rows, "scene"))
    axes.set_xticks(range(len(names)), [name for (name,) in names], rotation=20)
    axes.set(ylabel="measured against predicted / %", title="Largest stable steps: prediction and measurement")
    save(figure, folder, "stability_agreement")


def stability(rows, _, folder):
    settling = [row for row in rows if row["scene"] == "settling"]
    if settling:
        stability_settling(settling, folder)
    limits = [row for row in rows if "predicted_s" in row]
    for (integrator,), of_one in groups([row for row in limits if row["engine"] == "reference"], "integrator").items():
        stability_map(of_one, integrator, folder)
    if limits:
        stability_agreement(limits, folder)


PICTURES = {
    "scaling": scaling,
    "cundall": cundall,
    "neighbours": neighbours,
    "features": features,
    "layout": layout,
    "peers": peers,
    "accuracy": accuracy,
    "stability": stability,
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
