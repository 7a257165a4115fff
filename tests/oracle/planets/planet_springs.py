"""Forces of planets between a sun and a ring, modelled as springs, from a slow minimisation of the energy.

Each planet is written down by its vectors: the point and the direction of both lines of action in the plane, the pin with
its error, the sun with its displacement. Nothing of the program is used: no signs of teeth, no rows, no Newton steps.
scipy minimises Σ ∫F dδ − T φ, by BFGS and Powell's method in turn until the energy does not fall. The printed number is the
error of the moment on the sun.

    python3 planet_springs.py          computes all cases into planet_springs.json beside this file (ten seconds)

Lengths in mm, forces in N, angles in rad. The sun turns counter-clockwise and drives, carrier and ring are fixed. A spring is
F = k δ for δ > 0, or F = k δ + c δ² with `bend` = c. `lead` is a gap of the flanks of the mesh before they touch, as e_0 of
docs/theory/13-drives.md: δ = y + lead.
"""
import json
import math
import pathlib

import numpy as np
from scipy.optimize import minimize

DATA = pathlib.Path(__file__).with_suffix(".json")


class Set:
    def __init__(self, case):
        self.case = case
        self.r_s, self.r_p = case["base_sun"], case["base_planet"]
        self.r_r = case["base_ring"]
        self.a = case["distance"]
        self.floats = case["floating"]
        self.n = len(case["angles"])

    def approaches(self, x):
        """x: sun's angle, planets' angles (against the driven sense), then the sun's displacement; all in mm at the bases."""
        sun, planets = x[0] / self.r_s, x[1:1 + self.n] / self.r_p
        shift = x[1 + self.n:3 + self.n] if self.floats else np.zeros(2)
        found = []
        for i, psi in enumerate(self.case["angles"]):
            out, along = np.array([math.cos(psi), math.sin(psi)]), np.array([-math.sin(psi), math.cos(psi)])
            axis = self.a * out
            pin = axis + self.case["pins"][i] * along
            # The line of action of the sun's mesh pushes the planet forward and outward; a point of it on the sun.
            w = math.acos((self.r_s + self.r_p) / self.a)
            push = math.cos(w) * along + math.sin(w) * out
            foot = self.r_s * (math.cos(w) * out - math.sin(w) * along)  # perpendicular to push, at the base radius
            moved_sun = shift + sun * np.array([-foot[1], foot[0]])
            arm = -self.r_p * (math.cos(w) * out - math.sin(w) * along)
            moved_planet = (pin - axis) + -planets[i] * np.array([-arm[1], arm[0]])  # it turns clockwise
            y_sun = (moved_sun - moved_planet) @ push
            # The planet turns clockwise, so its outer side moves against the rotation of the sun and pushes the ring that
            # way and outward.
            v = math.acos((self.r_r - self.r_p) / self.a)
            push = -math.cos(v) * along + math.sin(v) * out
            arm = self.r_p * (math.cos(v) * out + math.sin(v) * along)
            moved_planet = (pin - axis) + -planets[i] * np.array([-arm[1], arm[0]])
            y_ring = moved_planet @ push  # the ring is fixed
            found.append((y_sun, y_ring))
        return np.array(found)

    def energy(self, x):
        total = -self.case["torque"] * x[0] / self.r_s
        for i, pair in enumerate(self.approaches(x)):
            for mesh, y in enumerate(pair):
                d = max(0.0, y + self.case["lead"][i][mesh])
                total += self.case["stiffness"][i][mesh] * d * d / 2 + self.case["bend"][i][mesh] * d ** 3 / 3
        return total

    def forces(self, x):
        found = []
        for i, pair in enumerate(self.approaches(x)):
            row = []
            for mesh, y in enumerate(pair):
                d = max(0.0, y + self.case["lead"][i][mesh])
                row.append(self.case["stiffness"][i][mesh] * d + self.case["bend"][i][mesh] * d * d)
            found.append(row)
        return found

    def solve(self):
        size = 1 + self.n + (2 if self.floats else 0)
        x = np.full(size, 0.02)
        scale = self.case["torque"] / self.r_s * 0.01
        for _ in range(60):
            before = self.energy(x)
            x = minimize(lambda v: self.energy(v) / scale, x, method="BFGS", options={"gtol": 1e-13, "maxiter": 5000}).x
            x = minimize(lambda v: self.energy(v) / scale, x, method="Powell",
                         options={"xtol": 1e-14, "ftol": 1e-16, "maxiter": 20000}).x
            if before - self.energy(x) < 1e-15 * scale:
                break
        return x


def random_case(rng, number):
    n = int(rng.integers(2, 6))
    floats = bool(number % 2) and n > 2
    sun, planet = int(rng.integers(15, 40)), int(rng.integers(15, 60))
    ring = sun + 2 * planet
    module = float(rng.uniform(1, 8))
    distance = module * (sun + planet) / 2 * float(rng.uniform(0.995, 1.02))
    base = module * math.cos(math.radians(20)) / 2
    base_sun, base_planet, base_ring = base * sun, base * planet, base * ring
    places = sun + ring  # positions at which a planet meshes
    torque = float(rng.uniform(5e3, 5e5))
    force = torque / base_sun / n
    typical = force / 5e4
    return {
        "teeth": [sun, planet, ring], "module": module,
        "base_sun": base_sun, "base_planet": base_planet, "base_ring": base_ring, "distance": distance,
        "angles": [2 * math.pi * math.floor(i * places / n + 0.5) / places for i in range(n)],
        "pins": [typical * float(rng.normal()) * (number % 3) for _ in range(n)],
        "floating": floats, "torque": torque,
        "stiffness": [[float(rng.uniform(3e4, 2e5)) for _ in range(2)] for _ in range(n)],
        "bend": [[(number % 4 == 0) * float(rng.uniform(0, 5e4)) / typical for _ in range(2)] for _ in range(n)],
        "lead": [[typical * float(rng.normal()) for _ in range(2)] for _ in range(n)],
    }


def main():
    rng = np.random.default_rng(36)
    cases = []
    for number in range(20):
        case = random_case(rng, number)
        model = Set(case)
        x = model.solve()
        case["forces"] = model.forces(x)
        case["sun"] = x[0]
        case["displacement"] = list(x[1 + model.n:]) if model.floats else [0.0, 0.0]
        moment = sum(f[0] for f in case["forces"]) * case["base_sun"] / case["torque"]
        print(number, model.n, model.floats, f"{moment - 1:.1e}",
              [round(f[0] * model.n * case["base_sun"] / case["torque"], 4) for f in case["forces"]])
        cases.append(case)
    DATA.write_text(json.dumps(cases, indent=1) + "\n")


if __name__ == "__main__":
    main()
