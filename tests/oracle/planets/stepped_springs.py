"""Computes the forces of stepped planets between two or three central gears, as springs, by a slow
minimisation of the energy.

A planet is one body with two gears on one axis. The working flank of each mesh follows from the static
equilibrium of rigid bodies without friction: a negative force changes the flank. No code of the program is
used: no signs of teeth, no speeds, no rows, no Newton steps. scipy minimises Σ ∫F dδ − Σ M φ by BFGS and
Powell's method in turn until the energy does not decrease. The printed numbers are the errors of the sums
of the forces.

    python3 stepped_springs.py          writes all cases to stepped_springs.json (two minutes)

Units and names are those of planet_springs.py. `nominal` is the force of each mesh if all planets share
equally. The moments of the central gears are those on the input, the output and the fixed member.
"""
import json
import math
import pathlib

import numpy as np

from planet_springs import least_energy

DATA = pathlib.Path(__file__).with_suffix(".json")
COSINE = math.cos(math.radians(20))
KINDS = ({"fixed": "ring2", "input": "sun", "output": "carrier", "meshes": [("sun", "planet"), ("planet2", "ring2")]},
         {"fixed": "ring2", "input": "carrier", "output": "sun", "meshes": [("sun", "planet"), ("planet2", "ring2")]},
         {"fixed": "ring", "input": "carrier", "output": "ring2", "meshes": [("planet", "ring"), ("planet2", "ring2")]},
         {"fixed": "sun2", "input": "carrier", "output": "sun", "meshes": [("sun", "planet"), ("sun2", "planet2")]},
         {"fixed": "ring", "input": "sun", "output": "ring2",
          "meshes": [("sun", "planet"), ("planet", "ring"), ("planet2", "ring2")]})


def across(v):
    return np.array([-v[1], v[0]])


class Set:
    def __init__(self, case):
        self.case = case
        self.meshes = [mesh.split("_") for mesh in case["meshes"]]
        self.central = [name for name in ("sun", "sun2", "ring", "ring2") if name in case["teeth"]]
        self.base = {name: case["module"] * z / 2 * COSINE for name, z in case["teeth"].items()}
        self.copies = len(case["angles"])
        self.flank = [1.0] * len(self.meshes)
        forces, self.moments = self.rigid()
        self.flank = [math.copysign(1.0, f) for f in forces]
        forces, self.moments = self.rigid()
        assert all(f > 0 for f in forces)
        self.nominal = [f / self.copies for f in forces]
        self.moving = self.central[:-1]

    def axis(self, name, angle):
        return np.array([math.cos(angle), math.sin(angle)]) * self.case["distance"] * name.startswith("planet")

    def line(self, m, angle):
        """Returns the pitch point of a mesh, and the direction of the force on its second gear."""
        one, two = self.meshes[m]
        a, b = self.axis(one, angle), self.axis(two, angle)
        ring = two.startswith("ring")
        outward = (a if ring else b - a) / self.case["distance"]  # from the first gear to its flank
        r, s = self.base[one], self.base[two]
        distance = self.case["distance"] * r / (s - r if ring else s + r)
        cosine = r / distance
        return a + outward * distance, self.flank[m] * cosine * across(outward) + math.sqrt(1 - cosine ** 2) * outward

    def rigid(self):
        """Returns the forces of all copies of each mesh, and the moments on the members, from the equilibrium of
        rigid bodies. The members are the central gears and the carrier."""
        members, count = self.central + ["carrier"], len(self.meshes)
        rows, right = [], []
        arm = lambda at, centre, force: (at - centre) @ -across(force)  # moment about a centre, > 0 counter-clockwise
        for body in members + ["planet"]:
            row = np.zeros(count + len(members))
            if body in members:
                row[count + members.index(body)] = 1.0
            for m, gears in enumerate(self.meshes):
                at, push = self.line(m, 0.0)
                for name, force in zip(gears, (-push, push)):
                    rides = name.startswith("planet")
                    if rides and body == "planet":
                        row[m] += arm(at, self.axis(name, 0.0), force)
                    elif rides and body == "carrier":
                        row[m] += arm(self.axis(name, 0.0), np.zeros(2), force)
                    elif not rides and name == body:
                        row[m] += arm(at, np.zeros(2), force)
            rows.append(row)
            right.append(0.0)
        for body in members:
            known = {self.case["input"]: self.case["torque"]}
            if body not in (self.case["fixed"], self.case["output"]):
                rows.append(np.eye(count + len(members))[count + members.index(body)])
                right.append(known.get(body, 0.0))
        x, _, rank, _ = np.linalg.lstsq(np.array(rows), np.array(right), rcond=None)
        assert rank == count + len(members)
        assert np.abs(np.array(rows) @ x - right).max() < 1e-9 * self.case["torque"]
        return x[:count], dict(zip(members, x[count:]))

    def approaches(self, x):
        """Returns the approaches of all meshes. x contains the rotations of the central gears that can turn and of
        the planets, times their base radii, and the displacement of the floating body."""
        turned = {name: x[i] / self.base[name] for i, name in enumerate(self.moving)}
        moved = x[-2:] if self.case["floating"] else np.zeros(2)
        found = []
        for i, angle in enumerate(self.case["angles"]):
            row = []
            for m, gears in enumerate(self.meshes):
                pitch, push = self.line(m, angle)
                at = []
                for name in gears:
                    axis = self.axis(name, angle)
                    rides = name.startswith("planet")
                    rotation = x[len(self.moving) + i] / self.base["planet"] if rides else turned.get(name, 0.0)
                    displaced = np.zeros(2)
                    if self.case["floating"] == ("carrier" if rides else name):
                        displaced = displaced + moved
                    if rides:
                        displaced = displaced + self.case["pins"][i] * across(axis) / self.case["distance"]
                    at.append(displaced + rotation * across(pitch - axis))
                row.append((at[0] - at[1]) @ push)
            found.append(row)
        return np.array(found)

    def energy(self, x):
        total = -sum(self.moments[name] * x[i] / self.base[name] for i, name in enumerate(self.moving))
        d = np.maximum(0.0, self.approaches(x) + self.lead)
        return total + (self.stiffness * d * d / 2 + self.bend * d ** 3 / 3).sum()

    def forces(self, x):
        d = np.maximum(0.0, self.approaches(x) + self.lead)
        return self.stiffness * d + self.bend * d * d

    def solve(self):
        self.stiffness, self.bend, self.lead = (np.array(self.case[key]) for key in ("stiffness", "bend", "lead"))
        # The approach of each mesh is linear in x, so the rows are computed once.
        n = len(self.moving) + self.copies + (2 if self.case["floating"] else 0)
        zero = self.approaches(np.zeros(n))
        rows = np.array([self.approaches(e) - zero for e in np.eye(n)])
        self.approaches = lambda v: zero + np.tensordot(v, rows, 1)
        x = np.zeros(n)
        for i, name in enumerate(self.moving):
            x[i] = math.copysign(0.1, self.moments[name])
        return least_energy(self.energy, x, max(self.nominal) * 0.01)


def places(teeth, meshes):
    """Returns the number of places per turn at which a planet meshes, by trying. Rotations are in turns."""
    least = [(name, gear) if gear.startswith("planet") else (gear, name) for name, gear in meshes]
    signed = lambda name: -teeth[name] if name.startswith("ring") else teeth[name]
    (one, p1), (two, p2) = least[0], least[-1]
    grid = abs(signed(one) * teeth[p2] - signed(two) * teeth[p1])

    def fits(n):
        """True if the planet turns by (k + z_one u)/z_p1 with u = n/grid, and all meshes have moved by whole teeth."""
        return any(all((teeth[p] * (k * grid + signed(one) * n) - signed(g) * n * teeth[p1]) % (teeth[p1] * grid) == 0
                       for g, p in least) for k in range(teeth[p1]))
    return sum(fits(n) for n in range(grid))


def random_case(rng, number):
    kind = KINDS[number % len(KINDS)]
    names = {gear for mesh in kind["meshes"] for gear in mesh}
    floating = (None, "carrier", "sun" if "sun" in names else "ring2", "ring2" if "ring2" in names else "sun2")[
        number // len(KINDS) % 4]
    while True:
        copies = int(rng.integers(3, 6)) if floating else int(rng.integers(2, 6))
        p1, p2 = int(rng.integers(17, 40)), int(rng.integers(17, 40))
        half = int(rng.integers(35, 80))  # the sum of the teeth of an external mesh, the difference of a ring mesh
        teeth = {"planet": p1, "planet2": p2, "sun": half - p1, "sun2": half - p2 + int(rng.integers(-1, 2)),
                 "ring": half + p1, "ring2": half + p2 + int(rng.integers(-1, 2))}
        teeth = {name: teeth[name] for name in names}
        if min(teeth.values()) < 15 or p1 == p2 or any(t <= 0 for t in teeth.values()):
            continue
        signed = {name: -z if name.startswith("ring") else z for name, z in teeth.items()}
        one, two = [next(g for g in mesh if not g.startswith("planet")) for mesh in (kind["meshes"][0], kind["meshes"][-1])]
        first = next(g for g in kind["meshes"][0] if g.startswith("planet"))
        last = next(g for g in kind["meshes"][-1] if g.startswith("planet"))
        # A ratio near 1 between both ways around the planet needs great torques and blocks the set with friction.
        ratio = signed[one] * teeth[last] / (signed[two] * teeth[first])
        if 0.8 < ratio < 1.25:
            continue
        if len(kind["meshes"]) == 3 and abs(teeth["ring"] * p2 / (p1 * teeth["ring2"]) - 1) < 0.1:
            continue
        count = places(teeth, kind["meshes"])
        steps = [math.floor(i * count / copies + 0.5) for i in range(copies)]
        if count >= 3 * copies and len(set(steps)) == copies:
            break
    module = float(rng.uniform(1, 8))
    case = {
        "meshes": ["_".join(mesh) for mesh in kind["meshes"]], "teeth": teeth, "module": module,
        "distance": module * half / 2 * float(rng.uniform(1.0, 1.012)),
        "fixed": kind["fixed"], "input": kind["input"], "output": kind["output"],
        "angles": [2 * math.pi * n / count for n in steps],
        "floating": floating, "torque": float(rng.uniform(5e3, 5e5)),
        "pins": [0.0] * copies,
    }
    typical = max(Set(case).nominal) / 5e4
    shape = [range(len(case["meshes"]))] * copies
    case["pins"] = [typical * float(rng.normal()) * (number % 4 > 0) for _ in range(copies)]
    case["stiffness"] = [[float(rng.uniform(3e4, 2e5)) for _ in row] for row in shape]
    case["bend"] = [[(number % 3 == 0) * float(rng.uniform(0, 5e4)) / typical for _ in row] for row in shape]
    case["lead"] = [[typical * float(rng.normal()) for _ in row] for row in shape]
    return case


def main():
    rng = np.random.default_rng(73)
    cases = []
    for number in range(30):
        case = random_case(rng, number)
        model = Set(case)
        x = model.solve()
        forces = model.forces(x)
        case["nominal"] = model.nominal
        case["forces"] = forces.tolist()
        case["displacement"] = list(x[-2:]) if case["floating"] else [0.0, 0.0]
        error = np.abs(forces.sum(axis=0) / np.array(model.nominal) / model.copies - 1).max()
        print(number, model.copies, case["teeth"], case["floating"], case["input"], f"{error:.1e}",
              (forces / model.nominal).round(3).tolist(), flush=True)
        cases.append(case)
    DATA.write_text(json.dumps(cases, separators=(",", ":")).replace("},{", "},\n{") + "\n")


if __name__ == "__main__":
    main()
