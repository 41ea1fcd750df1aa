# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rules of the tree that a compiler can't keep: who may include whom, headers, lengths.

    tree_rules.py ROOT includes|spdx|length|self-test
"""
import pathlib
import re
import sys

FOLDERS = {"model", "input", "analytic", "reference_cpu", "opencl", "kernels", "comparisons", "report", "app",
           "tests", "benchmarks"}
EVERYTHING = FOLDERS
MAY_INCLUDE = {
    "model": set(),
    "analytic": {"model"},
    "reference_cpu": {"model"},
    "opencl": {"model"},
    "kernels": set(),
    "comparisons": {"model"},
    "input": {"model", "analytic"},
    "report": {"model", "comparisons"},
    "app": EVERYTHING,
    "tests": EVERYTHING,
    "benchmarks": EVERYTHING,
}
PEERS = {"liggghts", "lammps", "yade", "external"}  # folders of comparisons/, none of which knows another
CODE = {".cpp", ".hpp", ".h", ".cl", ".py", ".sh", ".cmake"}
MAX_LINES = 300
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def code_files(root):
    for folder in sorted(FOLDERS | {"scripts", "cmake"}):
        for path in sorted((root / folder).rglob("*")):
            if path.is_file() and (path.suffix in CODE or path.name == "CMakeLists.txt"):
                yield path.relative_to(root), path.read_text(encoding="utf-8")


def include_faults(path, text):
    own = path.parts[0]
    if own not in MAY_INCLUDE:
        return
    for target in INCLUDE.findall(text):
        parts = pathlib.PurePosixPath(target).parts
        if parts[0] in FOLDERS and parts[0] != own and parts[0] not in MAY_INCLUDE[own]:
            yield f"{path}: includes {target}; {own}/ may include {sorted(MAY_INCLUDE[own]) or 'nothing of ours'}"
        if own == parts[0] == "comparisons" and parts[1] in PEERS - {path.parts[1]}:
            yield f"{path}: includes {target}; only the peer itself may"


def spdx_faults(path, text):
    head = "\n".join(text.splitlines()[:4])
    for tag in ("SPDX-FileCopyrightText:", "SPDX-License-Identifier: BSD-3-Clause"):
        if tag not in head:
            yield f"{path}: its first lines lack '{tag}'"


def length_faults(path, text):
    lines = text.count("\n")
    if lines > MAX_LINES:
        yield f"{path}: {lines} lines, at most {MAX_LINES}"


RULES = {"includes": include_faults, "spdx": spdx_faults, "length": length_faults}


def self_test():
    """Each rule must catch a planted fault and let a good file pass."""
    at = pathlib.PurePosixPath
    planted = {
        "includes": (at("opencl/engine.cpp"), '#include "reference_cpu/engine.hpp"\n'),
        "spdx": (at("model/scene.hpp"), "#pragma once\n"),
        "length": (at("model/scene.hpp"), "\n" * (MAX_LINES + 1)),
    }
    header = "// SPDX-FileCopyrightText: 2026 The Grainproof authors\n// SPDX-License-Identifier: BSD-3-Clause\n"
    good = (at("opencl/engine.cpp"), header + '#include "model/engine.hpp"\n#include "opencl/device.hpp"\n')
    peers = (at("comparisons/liggghts/deck.cpp"), '#include "comparisons/external/engine.hpp"\n')
    caught = [list(RULES[rule](*fault)) for rule, fault in planted.items()] + [list(include_faults(*peers))]
    return all(caught) and not any(list(rule(*good)) for rule in RULES.values())


def main(root, rule):
    if rule == "self-test":
        return 0 if self_test() else "a rule does not catch its planted fault, or refuses a good file"
    files = list(code_files(pathlib.Path(root)))
    if not any(path.parts[0] == "model" for path, _ in files):
        return f"no source files under {root}"
    faults = [fault for path, text in files for fault in RULES[rule](path, text)]
    return "\n".join(faults) or 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
