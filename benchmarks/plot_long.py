# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
"""What drifts in long runs, against steps: a picture a scene, a panel a quantity."""
import matplotlib.pyplot as plt

from plot_style import engine_label, groups, save, style

SHADES = {"velocity_verlet": 1.0, "onset_corrected": 0.6, "euler_trapezoid": 0.35}


def curve(row):
    return sorted((int(key[3:]), row[key]) for key in row if key.startswith("at_"))


def panel(axes, rows, quantity):
    """Each row's drift; its bound is a thin line of the same colour. Means that stay are no drift: no logarithm."""
    of_means = rows[0]["scene"] == "vibrated"
    for row in rows:
        points = [(step, value if of_means else max(abs(value), 1e-18)) for step, value in curve(row)]
        if not points:
            continue
        look = style(row) | {"markersize": 3, "alpha": SHADES.get(row["integrator"], 0.5)}
        axes.plot(*zip(*points), label=f"{engine_label(row)}, {row['integrator']}", **look)
        if not of_means and row["bound"] > 0:
            axes.axhline(row["bound"], color=look["color"], linestyle=look["linestyle"], linewidth=0.6)
    axes.set(xscale="log", xlabel="steps", title=quantity)
    if not of_means:
        axes.set_yscale("log")


def long_runs(rows, _, folder):
    for (scene,), of_scene in groups(rows, "scene").items():
        panels = [(name, drifting) for (name,), drifting in groups(of_scene, "quantity").items()
                  if any(curve(row) for row in drifting)]
        if not panels:
            continue
        figure, axes = plt.subplots(1, len(panels), figsize=(4.2 * len(panels), 4.4), squeeze=False)
        for place, (name, drifting) in zip(axes[0], panels):
            panel(place, drifting, name)
        axes[0][0].legend(fontsize=6)
        figure.suptitle(f"Long runs: {scene}")
        save(figure, folder, f"long_{scene}")
