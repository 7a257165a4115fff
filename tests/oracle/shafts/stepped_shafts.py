"""Computes the deflection, the slope and the twist of stepped shafts with brick elements.

Half of a shaft, y >= 0, consists of bricks of twenty nodes (C3D20), which CalculiX solves. No code of the
program is used.

    python3 stepped_shafts.py        writes all cases to stepped_shafts.json (six runs of a few seconds)

Every load is a force per volume. A force F and a moment M of a gear are uniform over its face, and a bearing
carries its reaction uniformly over the width BEARING. In bending, the shaft lies in the plane of symmetry. The
deflection w is the mean of u_x over a section, and the slope is psi = -int x u_z dA / I, as in Cowper's theory
of beams. w is 0 at both bearings. In torsion, the torque is uniform over the face, and it acts at the left end
of the shaft over the length BEARING. The twist is that of the rim of the face, relative to its right end.

Lengths are in mm, forces in N. z is measured from the middle of the face.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile

import numpy as np

DATA = pathlib.Path(__file__).with_suffix(".json")
MODULUS, POISSON = 206000.0, 0.3
BEARING = 8.0
TORQUE = 200000.0
CORE = 2  # elements along half a side of the square core of a section
SHAFTS = {
    "plain": {"ends": [-110.0, 110.0], "bearings": [-100.0, 100.0], "diameters": [40.0], "steps": [],
              "force": 10000.0, "moment": 0.0, "face": [-60.0, -20.0]},
    "between the bearings": {"ends": [-90.0, 130.0], "bearings": [-80.0, 120.0], "diameters": [35.0, 45.0, 60.0, 45.0, 35.0],
                             "steps": [-60.0, -20.0, 20.0, 90.0], "force": 10000.0, "moment": 100000.0, "face": [-20.0, 20.0]},
    "overhung": {"ends": [-220.0, 20.0], "bearings": [-190.0, -60.0], "diameters": [40.0, 50.0, 40.0, 30.0],
                 "steps": [-170.0, -80.0, -40.0], "force": 5000.0, "moment": -50000.0, "face": [-20.0, 20.0]},
}


def halved(ends):
    """Inserts the middle between each two adjacent values."""
    ends = np.asarray(ends, float)
    both = np.empty(2 * len(ends) - 1)
    both[::2], both[1::2] = ends, (ends[1:] + ends[:-1]) / 2
    return both


def divided(points, longest):
    """Divides the intervals between the points into equal parts that are not longer than `longest`."""
    points = sorted(set(points))
    parts = [np.linspace(a, b, int(np.ceil((b - a) / longest - 1e-9)) + 1)[:-1] for a, b in zip(points, points[1:])]
    return np.append(np.concatenate(parts), points[-1])


class Section:
    """Quadrilaterals of eight nodes in half a disc. `diameter` is the least shaft diameter that contains the
    element."""

    def __init__(self, diameters):
        self.nodes, self.elements, self.diameter, self._known = [], [], [], {}
        radii = sorted({d / 2 for d in diameters})
        side = 0.55 * radii[0]
        u = np.linspace(-side, side, 4 * CORE + 1)
        v = np.linspace(0, side, 2 * CORE + 1)
        # The square bulges, so that its corners are less sharp.
        square = u[:, None] * (1 - 0.25 * (v / side) ** 2) + 1j * v * (1 - 0.25 * (u[:, None] / side) ** 2)
        self.add(square, radii[0])
        edge = np.concatenate([square[-1], square[-2::-1, -1], square[0, -2::-1]])
        angle = np.exp(1j * np.linspace(0, np.pi, len(edge)))
        inner = edge
        for radius in radii:
            thick = radius - abs(inner).mean()
            parts = max(1, round(thick / (np.pi * radius / (4 * CORE))))
            t = np.linspace(0, 1, 2 * parts + 1)
            self.add(inner[:, None] * (1 - t) + (radius * angle)[:, None] * t, radius)
            inner = radius * angle
        self.nodes, self.elements, self.diameter = np.array(self.nodes), np.array(self.elements), 2 * np.array(self.diameter)

    def _node(self, w):
        key = (round(w.real * 1e6), round(w.imag * 1e6))
        if key not in self._known:
            self._known[key] = len(self.nodes)
            self.nodes.append(w)
        return self._known[key]

    def add(self, points, radius):
        rows, columns = points.shape
        ids = {(i, j): self._node(points[i, j]) for i in range(rows) for j in range(columns) if not (i % 2 and j % 2)}
        for i in range(0, rows - 2, 2):
            for j in range(0, columns - 2, 2):
                e = [ids[i + a, j + b] for a, b in ((0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1))]
                x = np.array([self.nodes[n] for n in e[::2]])
                if np.sum((np.conj(x) * np.roll(x, -1)).imag) < 0:
                    e = [e[0], *e[:0:-1]]
                self.elements.append(e[::2] + e[1::2])
                self.diameter.append(radius)


# The nodes of C3D20 in the unit cube: corners and middles of the lower face, of the upper face, and between them.
RING = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
MIDDLES = [(0, -1), (1, 0), (0, 1), (-1, 0)]
BRICK = np.array([(*p, -1) for p in RING] + [(*p, 1) for p in RING] + [(*p, -1) for p in MIDDLES] + [(*p, 1) for p in MIDDLES]
                 + [(*p, 0) for p in RING], float)
QUAD = np.array(RING + MIDDLES, float)
GAUSS, WEIGHT = np.polynomial.legendre.leggauss(4)


def shapes(nodes, at):
    """Returns the shape functions of an element with nodes in corners and middles of edges, at each point."""
    value = np.ones((len(at), len(nodes)))
    corner = np.all(nodes != 0, axis=1)
    for k in range(nodes.shape[1]):
        n, x = nodes[:, k], at[:, k, None]
        value *= np.where(n == 0, 1 - x * x, (1 + n * x) / 2)
    along = at @ nodes.T - (nodes.shape[1] - 1)
    return np.where(corner, value * along, value)


def slopes(nodes, at, step=1e-6):
    """Returns the derivatives of the shape functions, which are polynomials, by central differences."""
    return np.stack([(shapes(nodes, at + step * d) - shapes(nodes, at - step * d)) / (2 * step) for d in np.eye(nodes.shape[1])])


CUBE = np.array([(a, b, c) for a in GAUSS for b in GAUSS for c in GAUSS])
CUBE_WEIGHT = np.array([a * b * c for a in WEIGHT for b in WEIGHT for c in WEIGHT])
SQUARE = np.array([(a, b) for a in GAUSS for b in GAUSS])
SQUARE_WEIGHT = np.array([a * b for a in WEIGHT for b in WEIGHT])
BRICK_SHAPES, BRICK_SLOPES = shapes(BRICK, CUBE), slopes(BRICK, CUBE)
QUAD_SHAPES, QUAD_SLOPES = shapes(QUAD, SQUARE), slopes(QUAD, SQUARE)


class Bricks:
    """The bricks of a shaft, which is described by a value of SHAFTS."""

    def __init__(self, shaft):
        self.shaft = shaft
        section = self.section = Section(shaft["diameters"])
        pads = [b + s * BEARING / 2 for b in shaft["bearings"] for s in (-1, 0, 1)]
        fixed = [*shaft["ends"], *shaft["steps"], *shaft["face"], *pads, shaft["ends"][0] + BEARING]
        fine = [s + k * 4.0 for s in shaft["steps"] for k in (-1, 1)]
        levels = self.levels = divided(fixed + fine, max(shaft["diameters"]) / 8)
        self.z = halved(levels)
        self.id, self.at, self.bricks, self.layer = {}, [], [], []
        for k, (lo, hi) in enumerate(zip(levels, levels[1:])):
            d = self.diameter((lo + hi) / 2)
            for e in section.elements[section.diameter <= d + 1e-9]:
                low, high = [self._node(n, 2 * k) for n in e], [self._node(n, 2 * k + 2) for n in e]
                between = [self._node(n, 2 * k + 1) for n in e[:4]]
                self.bricks.append(low[:4] + high[:4] + low[4:] + high[4:] + between)
                self.layer.append(k)
        self.at, self.bricks, self.layer = np.array(self.at), np.array(self.bricks), np.array(self.layer)

    def _node(self, n, layer):
        if (n, layer) not in self.id:
            self.id[n, layer] = len(self.at)
            w = self.section.nodes[n]
            self.at.append((w.real, w.imag, self.z[layer]))
        return self.id[n, layer]

    def diameter(self, z):
        return self.shaft["diameters"][int(np.searchsorted(self.shaft["steps"], z))]

    def load(self, force, lo, hi, field):
        """Adds the force per volume field(x, y, d) in the bricks between lo and hi; d is the diameter there."""
        middle = (self.levels[self.layer] + self.levels[self.layer + 1]) / 2
        for brick in self.bricks[(middle > lo) & (middle < hi)]:
            x = self.at[brick]
            volume = CUBE_WEIGHT * np.abs(np.linalg.det(np.einsum("kpn,nj->pkj", BRICK_SLOPES, x)))
            place = BRICK_SHAPES @ x
            d = self.diameter(place[0, 2])
            density = field(place[:, 0], place[:, 1], d)
            np.add.at(force, brick, (BRICK_SHAPES * volume[:, None]).T @ density)

    def sections(self, u, field):
        """Returns the integral of field(x, y, u) over the whole section at each level."""
        found = []
        for k in range(len(self.levels)):
            # At a step, the smaller section is the common one.
            inside = self.section.diameter <= min(self.diameter(self.levels[k] + s) for s in (-1e-6, 1e-6)) + 1e-9
            total = 0.0
            for e in self.section.elements[inside]:
                ids = [self.id[n, 2 * k] for n in e]
                x = self.at[ids][:, :2]
                area = SQUARE_WEIGHT * np.abs(np.linalg.det(np.einsum("kpn,nj->pkj", QUAD_SLOPES, x)))
                place, moved = QUAD_SHAPES @ x, QUAD_SHAPES @ u[ids]
                total += 2 * np.sum(area * field(place[:, 0], place[:, 1], moved))
            found.append(total)
        return np.array(found)

    def solve(self, force, fixed):
        """Returns the displacements of all nodes. `fixed` contains pairs of node and direction. CalculiX runs on one core."""
        with tempfile.TemporaryDirectory() as folder:
            case = pathlib.Path(folder) / "shaft"
            with open(case.with_suffix(".inp"), "w") as file:
                file.write("*NODE,NSET=ALL\n" + "".join(f"{i + 1},{x:.12g},{y:.12g},{z:.12g}\n" for i, (x, y, z) in enumerate(self.at)))
                file.write("*ELEMENT,TYPE=C3D20,ELSET=ALL\n")
                for i, brick in enumerate(self.bricks):
                    n = [i + 1, *(brick + 1)]
                    file.write(",".join(map(str, n[:16])) + ",\n" + ",".join(map(str, n[16:])) + "\n")
                file.write(f"*MATERIAL,NAME=M\n*ELASTIC\n{MODULUS},{POISSON}\n*SOLID SECTION,ELSET=ALL,MATERIAL=M\n*BOUNDARY\n")
                file.writelines(f"{node + 1},{c + 1},{c + 1},0.\n" for node, c in sorted(fixed))
                file.write("*STEP\n*STATIC,SOLVER=SPOOLES\n*CLOAD\n")
                file.writelines(f"{i + 1},{c + 1},{f[c]:.12g}\n" for i, f in enumerate(force) for c in range(3) if f[c])
                file.write("*NODE PRINT,NSET=ALL\nU\n*END STEP\n")
            one = {"OMP_NUM_THREADS": "1", "CCX_NPROC_EQUATION_SOLVER": "1"}
            run = subprocess.run(["ccx", "-i", "shaft"], cwd=folder, env=os.environ | one, capture_output=True, text=True)
            rows = [line.split() for line in case.with_suffix(".dat").read_text().splitlines() if line.strip() and "displacements" not in line]
        if len(rows) != len(self.at):
            raise RuntimeError(run.stdout[-2000:])
        u = np.zeros((len(self.at), 3))
        for node, *xyz in rows:
            u[int(node) - 1] = [float(value) for value in xyz]
        return u

    def on_axis(self, z):
        middle = int(np.argmin(abs(self.section.nodes)))
        return self.id[middle, int(np.argmin(abs(self.z - z)))]

    def plane(self):
        return np.flatnonzero(abs(self.at[:, 1]) < 1e-9)

    def bending(self):
        """Returns w and psi at all levels."""
        s = self.shaft
        lo, hi = s["face"]
        one, two = s["bearings"]
        second = -(s["force"] * ((lo + hi) / 2 - one) + s["moment"]) / (two - one)
        force = np.zeros_like(self.at)

        def along_x(total, length):
            return lambda x, y, d: np.outer(np.full(len(x), total / length / (np.pi * d * d / 4)), (1, 0, 0))
        self.load(force, lo, hi, along_x(s["force"], hi - lo))
        # psi > 0 turns the side x > 0 towards -z.
        self.load(force, lo, hi, lambda x, y, d: np.outer(-s["moment"] / (hi - lo) / (np.pi * d**4 / 64) * x, (0, 0, 1)))
        for place, total in ((one, -s["force"] - second), (two, second)):
            self.load(force, place - BEARING / 2, place + BEARING / 2, along_x(total, BEARING))
        fixed = {(n, 1) for n in self.plane()} | {(self.on_axis(one), 0), (self.on_axis(two), 0), (self.on_axis(one), 2)}
        u = self.solve(force, fixed)
        z = self.levels
        d = np.array([min(self.diameter(at - 1e-6), self.diameter(at + 1e-6)) for at in z])
        w = self.sections(u, lambda x, y, v: v[:, 0]) / (np.pi * d**2 / 4)
        psi = -self.sections(u, lambda x, y, v: x * v[:, 2]) / (np.pi * d**4 / 64)
        ends = np.interp([one, two], z, w)
        turn = (ends[1] - ends[0]) / (two - one)
        return w - ends[0] - turn * (z - one), psi - turn

    def torsion(self, torque):
        """Returns the levels of the face and the twist there."""
        s = self.shaft
        lo, hi = s["face"]
        force = np.zeros_like(self.at)

        def around(total, length):
            def field(x, y, d):
                per_radius = total / length / (np.pi * d**4 / 32)
                return per_radius * np.stack([-y, x, 0 * x], axis=1)
            return field
        self.load(force, lo, hi, around(torque, hi - lo))
        self.load(force, s["ends"][0], s["ends"][0] + BEARING, around(-torque, BEARING))
        plane = self.plane()
        rim = max(plane, key=lambda n: (abs(self.at[n, 2] - lo) < 1e-9, self.at[n, 0]))
        fixed = {(n, c) for n in plane for c in (0, 2)} | {(self.on_axis(s["bearings"][0]), 1), (self.on_axis(lo), 1), (rim, 1)}
        u = self.solve(force, fixed)
        radius = self.diameter((lo + hi) / 2) / 2
        rims = [(self.at[n, 2], u[n, 1] / radius) for n in plane if abs(self.at[n, 0] - radius) < 1e-9]
        z, twist = zip(*sorted((z, turn) for z, turn in rims if z in self.levels and lo <= z <= hi))
        return z, np.array(twist) - twist[-1]


def digits(values):
    return [float(f"{v:.6g}") + 0.0 for v in values]


def made(name):
    bricks = Bricks(SHAFTS[name])
    w, psi = bricks.bending()
    face, twist = bricks.torsion(TORQUE)
    return SHAFTS[name] | {"name": name, "unknowns": 3 * len(bricks.at), "z": digits(bricks.levels), "w_um": digits(1e3 * w),
                           "slope_urad": digits(1e6 * psi), "face_z": digits(face), "twist_urad": digits(1e6 * twist)}


def installed():
    return shutil.which("ccx") is not None


def main():
    about = {"made_by": "tests/oracle/shafts/stepped_shafts.py", "youngs_modulus": MODULUS, "poisson_ratio": POISSON,
             "bearing_width": BEARING, "torque": TORQUE}
    text = json.dumps(about | {"shafts": [made(name) for name in SHAFTS]}, indent=1)
    DATA.write_text(re.sub(r"\[[^\[\]{}]*\]", lambda numbers: " ".join(numbers[0].split()), text) + "\n")


if __name__ == "__main__":
    main()
