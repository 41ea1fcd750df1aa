# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
"""Error against step, and run time against error: a picture a scene."""
import matplotlib.pyplot as plt

from plot_style import COLOURS, engine_label, groups, save, style


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
