# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all pictures of `grainproof bench` have in common."""
import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402  (after the backend is chosen)

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
