"""Computes the forces of planets between a sun and a ring, as springs, by a slow minimisation of the energy.

Each gear is a circle with an axis, a displacement of this axis and a rotation. A mesh acts along the
straight line through its pitch point that is tangent to both base circles. No code of the program is used:
no signs of teeth, no rows, no Newton steps. scipy minimises Σ ∫F dδ − M φ by BFGS and Powell's method in
turn until the energy does not decrease. The printed number is the error of the moment on the sun.

    python3 planet_springs.py          writes all cases to planet_springs.json (two minutes)

Lengths are in mm, forces in N, angles in rad, counter-clockwise. All motions are relative to the carrier. In
this frame, the ring does not rotate. `distances` are the centre distances of the meshes in the order from
the sun to the ring. `axes` are the polar coordinates of copy 0 of each rider, the idler first if there is
one. `pins` are the tangential errors of [rider][copy]. `floating` is the body that is free to move radially.
A spring is F = k δ for δ > 0, or F = k δ + c δ² with `bend` = c. `lead` is the approach of the flanks before
the bodies move, e_0 of docs/theory/13-drives.md: δ = y + lead.
"""
import json
import math
import pathlib

import numpy as np
from scipy.optimize import minimize

DATA = pathlib.Path(__file__).with_suffix(".json")


def across(v):
    return np.array([-v[1], v[0]])


def polar(radius, angle):
    return radius * np.array([math.cos(angle), math.sin(angle)])


def motion(case):
    """Returns the sense of rotation of the sun in the frame of the carrier, and whether the sun drives its
    mesh, by Willis: (ω_s − ω_c)/(ω_r − ω_c) = k."""
    sun, ring = case["teeth"][0], case["teeth"][-1]
    k = ring / sun * (-1) ** len(case["teeth"])
    speed = {case["fixed"]: 0.0, case["input"]: 1.0}
    if "carrier" not in speed:
        s, r = speed["sun"], speed["ring"]
        speed["carrier"] = (s - k * r) / (1 - k)
    elif "sun" not in speed:
        speed["sun"] = speed["carrier"] + k * (speed["ring"] - speed["carrier"])
    elif "ring" not in speed:
        speed["ring"] = speed["carrier"] + (speed["sun"] - speed["carrier"]) / k
    relative = {name: speed[name] - speed["carrier"] for name in ("sun", "ring")}
    # A central gear that is the input receives power; one that is the output delivers it. Power in the frame of the carrier
    # enters at the sun or at the ring.
    central = "sun" if case["fixed"] != "sun" else "ring"
    enters = speed[central] * relative[central] > 0
    if case["output"] == central:
        enters = not enters
    return math.copysign(1.0, relative["sun"]), enters == (central == "sun")


def least_energy(energy, x, scale):
    """Returns the place with the least energy, searched from x. `scale` is the size of the energy."""
    for _ in range(60):
        before = energy(x)
        x = minimize(lambda v: energy(v) / scale, x, method="BFGS", options={"gtol": 1e-13, "maxiter": 5000}).x
        x = minimize(lambda v: energy(v) / scale, x, method="Powell",
                     options={"xtol": 1e-14, "ftol": 1e-16, "maxiter": 20000}).x
        if before - energy(x) < 1e-15 * scale:
            break
    return x


class Set:
    def __init__(self, case):
        self.case = case
        self.bases = case["bases"]
        self.copies = len(case["angles"])
        self.riders = len(self.bases) - 2
        self.meshes = self.riders + 1
        self.sense, self.sun_drives = motion(case)
        self.lines = [[self.line(i, m) for m in range(self.meshes)] for i in range(self.copies)]

    def axis(self, i, gear):
        if gear in (0, self.riders + 1):
            return np.zeros(2)
        radius, angle = self.case["axes"][gear - 1]
        return polar(radius, angle + self.case["angles"][i])

    def line(self, i, m):
        """Returns the pitch point of the mesh between gears m and m + 1, and the direction of the force on gear
        m + 1."""
        a, b = self.axis(i, m), self.axis(i, m + 1)
        ring = m + 1 == self.meshes
        apart = b - a
        distance = np.linalg.norm(apart)
        outward = -apart / distance if ring else apart / distance  # from gear m to its flank, away from its axis
        if ring:
            outward = a / np.linalg.norm(a)
        ra, rb = self.bases[m], self.bases[m + 1]
        pitch = a + outward * distance * ra / (rb - ra if ring else rb + ra)
        turns = self.sense * (-1) ** m  # each external mesh reverses the sense
        if not self.sun_drives:
            turns = -turns  # gear m is pushed against its rotation, so it pushes back in that sense
        cosine = ra / np.linalg.norm(pitch - a)
        push = turns * cosine * across(outward) + math.sqrt(1 - cosine ** 2) * outward
        assert abs(abs(np.cross(pitch - b, push)) - rb) < 1e-9 * rb
        assert abs(abs(np.cross(pitch - a, push)) - ra) < 1e-9 * ra
        return pitch, push

    def approaches(self, x):
        """Returns the approaches of all meshes. x contains the rotations of the sun and of the riders times
        their base radii, and the displacement of the floating body."""
        sun = x[0] / self.bases[0]
        moved = x[-2:] if self.case["floating"] else np.zeros(2)
        shift = {name: moved if self.case["floating"] == name else np.zeros(2) for name in ("sun", "ring", "carrier")}
        found = []
        for i in range(self.copies):
            turned, displaced = [sun], [shift["sun"]]
            for r in range(self.riders):
                turned.append(x[1 + i * self.riders + r] / self.bases[1 + r])
                axis = self.axis(i, 1 + r)
                tangent = across(axis) / np.linalg.norm(axis)
                displaced.append(shift["carrier"] + self.case["pins"][r][i] * tangent)
            turned.append(0.0)
            displaced.append(shift["ring"])
            row = []
            for m in range(self.meshes):
                pitch, push = self.lines[i][m]
                at = [displaced[g] + turned[g] * across(pitch - self.axis(i, g)) for g in (m, m + 1)]
                row.append((at[0] - at[1]) @ push)
            found.append(row)
        return np.array(found)

    def moment(self):
        return self.case["torque"] * self.sense * (1 if self.sun_drives else -1)

    def energy(self, x):
        total = -self.moment() * x[0] / self.bases[0]
        for i, row in enumerate(self.approaches(x)):
            for m, y in enumerate(row):
                d = max(0.0, y + self.case["lead"][i][m])
                total += self.case["stiffness"][i][m] * d * d / 2 + self.case["bend"][i][m] * d ** 3 / 3
        return total

    def forces(self, x):
        d = np.maximum(0.0, self.approaches(x) + self.case["lead"])
        return (np.array(self.case["stiffness"]) * d + np.array(self.case["bend"]) * d * d).tolist()

    def solve(self):
        x = np.zeros(1 + self.riders * self.copies + (2 if self.case["floating"] else 0))
        x[0] = math.copysign(0.1, self.moment())
        return least_energy(self.energy, x, self.case["torque"] / self.bases[0] * 0.01)


def random_case(rng, number):
    idler = number % 3 == 2
    floating = (None, "sun", "ring", "carrier")[number % 4]
    copies = int(rng.integers(3, 6)) if floating else int(rng.integers(2, 6))
    fixed, given, output = (("ring", "sun", "carrier"), ("ring", "carrier", "sun"), ("sun", "ring", "carrier"),
                            ("sun", "carrier", "ring"))[number % 7 % 4]
    module = float(rng.uniform(1, 8))
    sun = int(rng.integers(15, 40))
    half = module / 2
    if idler:
        first, second = int(rng.integers(17, 25)), int(rng.integers(17, 40))
        ring = sun + first + second + int(rng.integers(8, first)) + second
        teeth = [sun, first, second, ring]
        distances = [half * (sun + first), half * (first + second), half * (ring - second)]
    else:
        planet = int(rng.integers(17, 60))
        ring = sun + 2 * planet
        teeth = [sun, planet, ring]
        distances = [half * (sun + planet)] * 2
    factor = float(rng.uniform(0.997, 1.015))
    distances = [a * factor for a in distances]
    axes = [[distances[-1], 0.0]]
    if idler:
        a, b, c = distances[0], distances[2], distances[1]
        axes.insert(0, [a, math.acos((a * a + b * b - c * c) / (2 * a * b))])
    places = ring - sun if idler else ring + sun  # number of places around the carrier at which a planet meshes
    torque = float(rng.uniform(5e3, 5e5))
    bases = [half * math.cos(math.radians(20)) * z for z in teeth]
    force = torque / bases[0] / copies
    typical = force / 5e4
    meshes = len(teeth) - 1
    return {
        "teeth": teeth, "module": module, "bases": bases, "distances": distances, "axes": axes,
        "fixed": fixed, "input": given, "output": output,
        "angles": [2 * math.pi * math.floor(i * places / copies + 0.5) / places for i in range(copies)],
        "pins": [[typical * float(rng.normal()) * (number % 5 > 0) for _ in range(copies)] for _ in axes],
        "floating": floating, "torque": torque,
        "stiffness": [[float(rng.uniform(3e4, 2e5)) for _ in range(meshes)] for _ in range(copies)],
        "bend": [[(number % 5 == 0) * float(rng.uniform(0, 5e4)) / typical for _ in range(meshes)] for _ in range(copies)],
        "lead": [[typical * float(rng.normal()) for _ in range(meshes)] for _ in range(copies)],
    }


def main():
    rng = np.random.default_rng(36)
    cases = []
    for number in range(48):
        case = random_case(rng, number)
        model = Set(case)
        x = model.solve()
        case["forces"] = model.forces(x)
        case["displacement"] = list(x[-2:]) if case["floating"] else [0.0, 0.0]
        moment = sum(f[0] for f in case["forces"]) * case["bases"][0] / case["torque"]
        print(number, model.copies, model.riders, case["floating"], case["input"], f"{moment - 1:.1e}",
              [round(f[0] * model.copies * case["bases"][0] / case["torque"], 4) for f in case["forces"]], flush=True)
        cases.append(case)
    DATA.write_text(json.dumps(cases, separators=(",", ":")).replace("},", "},\n") + "\n")


if __name__ == "__main__":
    main()
