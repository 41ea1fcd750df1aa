# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
"""A whole DEM code for docs/external.md: frictionless spheres without walls or fields, velocity Verlet.

    head_on_pair.py SCENE.json FOLDER
"""
import json
import math
import pathlib
import sys

scene = json.loads(pathlib.Path(sys.argv[1]).read_text())
normal = scene["contacts"][0]["normal"]
if scene["walls"] or scene["flow"] or scene["contacts"][0]["friction"] or scene["contacts"][0]["cohesion"]:
    sys.exit("this code knows frictionless spheres only")

bodies = scene["particles"]
x = [body["position"] for body in bodies]
v = [body["velocity"] for body in bodies]
inverse_mass = [0.0 if b["fixed"] else 6 / (scene["materials"][b["material"]]["density"] * math.pi * b["diameter"]**3)
                for b in bodies]


def accelerations():
    a = [[0.0, 0.0, 0.0] for _ in bodies]
    for j in range(len(bodies)):
        for i in range(j):
            r = [q - p for p, q in zip(x[i], x[j])]
            distance = math.sqrt(sum(c * c for c in r))
            overlap = (bodies[i]["diameter"] + bodies[j]["diameter"]) / 2 - distance
            if overlap <= 0 or inverse_mass[i] + inverse_mass[j] == 0:
                continue
            mass, log = 1 / (inverse_mass[i] + inverse_mass[j]), math.log(normal["restitution"])
            eta = -2 * log * math.sqrt(mass * normal["stiffness"] / (math.pi**2 + log**2))
            n = [c / distance for c in r]
            speed = sum(c * (q - p) for c, p, q in zip(n, v[i], v[j]))
            force = normal["stiffness"] * overlap - eta * speed
            for axis in range(3):
                a[i][axis] -= force * n[axis] * inverse_mass[i]
                a[j][axis] += force * n[axis] * inverse_mass[j]
    return a


h, wanted = scene["run"]["step"], set(scene["run"]["frame_steps"])
with open(pathlib.Path(sys.argv[2]) / "frames.csv", "w") as out:
    print("time,id,x,y,z,vx,vy,vz", file=out)
    a = accelerations()
    for step in range(scene["run"]["steps"] + 1):
        if step in wanted:
            for body, place, velocity in zip(bodies, x, v):
                print(step * h, body["id"], *place, *velocity, sep=",", file=out)
        v = [[c + h / 2 * d for c, d in zip(*pair)] for pair in zip(v, a)]
        x = [[c + h * d for c, d in zip(*pair)] for pair in zip(x, v)]
        a = accelerations()
        v = [[c + h / 2 * d for c, d in zip(*pair)] for pair in zip(v, a)]
