# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
"""The largest stable steps, measured and predicted."""
import matplotlib.pyplot as plt
import numpy as np

from plot_style import engine_label, groups, save, style


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
