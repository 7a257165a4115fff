"""Computes the deflection of the flank of a helical tooth along the face, under a load on a part of the
face, with brick elements.

The transverse section consists of three teeth with their exact outline and the rest of the gear, which is
smooth at the root circle. It is divided into quadrilaterals of eight nodes, which are swept along the helix
into bricks of twenty nodes (C3D20) and fixed at the bore. The end faces are planes z = const. CalculiX
solves the model. Rack, involute and trochoid are written here, so no code of the program is used.

    python3 tooth_bricks.py          writes all cases to tooth_bricks.json (six runs of half a minute)

Lengths are in normal modules, E = 1, nu = 0.3, and the force is 1, so displacements are E u m_n / F. The
force has the distribution ("bump") 15/(16c) (1 - s^2/c^2)^2 along the arc length s of the outline, with
c = 0.3. It is uniform over the loaded part of the face and normal to the screw surface. A reading is the
mean with the same bump at one height, along the normal at that height. These are the values `bumps`. For
`strip`, both bumps are replaced in the half space by a Hertz strip of half width 0.05, read at its centre,
as in [T12.9]. [[load.probe]] prints these values. Far from the load, `bumps` and `strip` are equal. z begins
with 0 at one end of the face. The helix is right-handed, and the flank is at y > 0.
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
TEETH, ALPHA, FACE = 25, np.radians(20), 10.0
RACK_TIP, RACK_ROUND = 1.25, 0.38  # ISO53-A
BUMP, STRIP = 0.3, 0.05  # half widths
POISSON = 0.3
# Numbers of elements along the half outline and across to the centre line, for the loaded tooth and for
# its neighbours.
LOADED, BESIDE = (12, 3), (5, 2)
UNDER, BODY, REST = 2, 3, 6
# Layers have half a module, or a quarter of a module under a load.
HEIGHTS = sorted({*np.arange(0, FACE + 0.1, 0.5), 0.25, 4.75, 9.75})
READ = sorted({*np.arange(0, FACE + 0.1, 1.0), 0.25, 4.75, 9.75})
# GEARS: diameter of the bore by helix angle. LOADS: height above the reference circle, and part of the
# face.
GEARS = {30: 12.0, 45: 16.0}
LOADS = [(0.7, (0.0, 0.5)), (0.7, (4.5, 5.0)), (0.7, (9.5, 10.0))]


def reference_radius(beta):
    return TEETH / 2 / np.cos(beta)


def outline(beta, points=4000):
    """Returns points and arc lengths of half a tooth in the transverse section, y > 0, from the middle of
    the space to the tip."""
    r = reference_radius(beta)
    alpha_t = np.arctan(np.tan(ALPHA) / np.cos(beta))
    r_b = r * np.cos(alpha_t)
    # The rounding of the rack's tip is tangent to tip line and flank in the normal section. In the
    # transverse section, it is wider by 1/cos beta.
    t = np.linspace(np.pi / 2, ALPHA, points)
    y = RACK_ROUND - RACK_TIP - RACK_ROUND * np.sin(t)
    x = (np.pi / 4 + (RACK_TIP - RACK_ROUND) * np.tan(ALPHA) + RACK_ROUND / np.cos(ALPHA) - RACK_ROUND * np.cos(t)) / np.cos(beta)
    # The point at which the normal meets the pitch line, which rolls on the circle of radius r.
    pitch = x - y * np.cos(t) * np.cos(beta) / np.sin(t)
    fillet = (r + y + 1j * (x - pitch)) * np.exp(1j * pitch / r)
    roll = np.linspace(np.sqrt(abs(fillet[-1] / r_b) ** 2 - 1), np.sqrt(((r + 1) / r_b) ** 2 - 1), points)
    # Half angle of the tooth at the base circle.
    half = np.pi / (2 * TEETH) + np.tan(alpha_t) - alpha_t
    flank = r_b * (1 + 1j * roll) * np.exp(1j * (half - roll))
    land = abs(fillet[0]) * np.exp(1j * np.linspace(np.pi / TEETH, np.angle(fillet[0]), 50))
    w = np.concatenate([land[:-1], fillet, flank[1:]])
    return w, np.concatenate([[0], np.cumsum(abs(np.diff(w)))])


def halved(ends):
    """Inserts the middle between each two adjacent values."""
    ends = np.asarray(ends, float)
    all_of_them = np.empty(2 * len(ends) - 1)
    all_of_them[::2] = ends
    all_of_them[1::2] = (ends[1:] + ends[:-1]) / 2
    return all_of_them


class Section:
    """Quadrilaterals of eight nodes. Contains the nodes (complex), the elements (rows of 8), and the nodes
    of the loaded flank with their arc lengths s."""

    def __init__(self, beta, bore):
        self.nodes, self.elements, self._known = [], [], {}
        w, s = outline(beta)
        root, pitch = abs(w[0]), np.pi / TEETH
        foot = root - 1.125
        body = foot - 0.9
        depth = np.cumsum([0.0, *3.0 ** (np.arange(BODY) / (BODY - 1))])
        body_radii = halved(body + (bore / 2 - body) * depth / depth[-1])
        down = np.linspace(0, 1, 2 * UNDER + 1)
        for k, (along, across) in ((-1, BESIDE), (0, LOADED), (1, BESIDE)):
            at = np.linspace(0, 1, 2 * along + 1)
            at = s[-1] * (1 - (1 - at) ** 1.1)  # a little finer at the tip
            at[1::2] = (at[:-1:2] + at[2::2]) / 2
            p = np.interp(at, s, w)
            centre = foot + (abs(w[-1]) - foot) * at / s[-1]
            to = halved(np.linspace(0, 1, across + 1) ** 1.5)
            for side in (1, -1):
                def block(radii, angles, side=side, k=k):
                    return self.add(radii * np.exp(1j * (side * angles + 2 * pitch * k)))
                radii = abs(p)[:, None] * (1 - to) + centre[:, None] * to
                ids = block(radii, np.angle(p)[:, None] * (1 - to))
                if (k, side) == (0, 1):
                    self.flank, self.flank_s = ids[:, 0], at
                angles = (pitch * (1 - to))[:, None]
                block(radii[0][:, None] * (1 - down) + body * down, angles + 0 * down)
                block(body_radii + 0 * angles, angles + 0 * body_radii)
        u = np.linspace(0, 1, REST + 1)
        angles = halved(3 * pitch + (2 * np.pi - 6 * pitch) * (0.3 * (1 - np.cos(np.pi * u)) + 0.4 * u))[:, None]
        for radii in (root * (1 - down) + body * down, body_radii):
            self.add(radii * np.exp(1j * angles))
        self.nodes = np.array(self.nodes)
        self.elements = np.array(self.elements)
        self.bore = np.flatnonzero(abs(abs(self.nodes) - bore / 2) < 1e-7)

    def _node(self, w):
        return self._known.setdefault((round(w.real * 1e6), round(w.imag * 1e6)), len(self._known))

    def add(self, points):
        rows, columns = points.shape
        ids = np.full(points.shape, -1)
        for i in range(rows):
            for j in range(columns):
                if i % 2 and j % 2:
                    continue
                ids[i, j] = self._node(points[i, j])
                if ids[i, j] == len(self.nodes):
                    self.nodes.append(points[i, j])
        for i in range(0, rows - 2, 2):
            for j in range(0, columns - 2, 2):
                ring = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)]
                e = [ids[i + a, j + b] for a, b in ring]
                x = np.array([self.nodes[n] for n in e[::2]])
                if np.sum((np.conj(x) * np.roll(x, -1)).imag) < 0:
                    e = [e[0], *e[:0:-1]]
                self.elements.append(e[::2] + e[1::2])
        return ids


def offsets(points=400):
    """Returns the distances along s between load and reading with their weights, for two bumps and for a
    strip and its centre."""
    t, weight = np.polynomial.legendre.leggauss(points)
    t, weight = (t + 1) / 2, weight / 2  # concentrated towards 0 by t^3, where 1/R is large
    y, of_y = np.polynomial.legendre.leggauss(60)

    def bump(x):
        return np.where(abs(x) < 1, 15 / 16 * (1 - x * x) ** 2, 0)
    apart = 2 * t**3
    both = [np.sum(of_y * (1 - d / 2) * bump((1 - d / 2) * y - d / 2) * bump((1 - d / 2) * y + d / 2)) for d in apart]
    around = t**2 * np.pi / 2
    return ((BUMP * apart, np.array(both) * 6 * t**2 * weight),
            (STRIP * np.sin(around), 2 * np.cos(around) ** 2 * t * weight))


def half_space(slope, stretch, z, part):
    """Returns the displacement by a strip minus the displacement by bumps, -H[b, b] + H[a, a], at one
    height, with R^2 = x^2 + 2 slope x dz + stretch dz^2. The load is mirrored at both ends of the face."""
    def mean(x, weight):
        def integral(dz):
            across = abs(x) * np.sqrt(1 - slope * slope / stretch)
            return np.arcsinh(np.sqrt(stretch) * (dz + slope * x / stretch) / across) / np.sqrt(stretch)
        return sum(np.sum(weight * (integral(part[1] - at) - integral(part[0] - at))) for at in (z, -z, 2 * FACE - z))
    of_bumps, of_strip = (mean(x, weight) + mean(-x, weight) for x, weight in offsets())
    return (1 - POISSON**2) / np.pi * (of_strip - of_bumps) / (part[1] - part[0])


def quadratic(x):
    return np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2])


class Tooth:
    """The brick model of one gear, with its loads and readings."""

    def __init__(self, beta_deg, bore):
        self.beta = np.radians(beta_deg)
        self.twist = np.tan(self.beta) / reference_radius(self.beta)
        self.section = Section(self.beta, bore)
        self.z = halved(HEIGHTS)
        corner = np.zeros(len(self.section.nodes), bool)
        corner[np.unique(self.section.elements[:, :4])] = True
        self.id = np.zeros((len(self.section.nodes), len(self.z)), int)
        there = np.ones_like(self.id, bool)
        there[~corner, 1::2] = False
        self.id[there] = 1 + np.arange(there.sum())
        self.unknowns = 3 * int(there.sum())

    def place(self, above):
        """Returns for a point of the flank: arc length, normal and tangent of the outline, and d(x + iy)/dz
        along the helix."""
        w, s = outline(self.beta)
        at = np.interp(reference_radius(self.beta) + above, abs(w), s)
        tangent = np.interp(at + 0.01, s, w) - np.interp(at - 0.01, s, w)
        tangent /= abs(tangent)
        return at, -1j * tangent, tangent, self.twist * 1j * np.interp(at, s, w)

    def half_space(self, above, z, part):
        _, _, tangent, rise = self.place(above)
        return half_space((tangent * np.conj(rise)).real, 1 + abs(rise) ** 2, z, part)

    def bump(self, above):
        """Returns points under the bump, each as its element, x and weight, and the normal of the screw surface
        at height 0."""
        middle, normal, _, rise = self.place(above)
        g, weight = np.polynomial.legendre.leggauss(200)
        at = middle + BUMP * g
        ends = self.section.flank_s[::2]
        if not ends[0] < at[0] <= at[-1] < ends[-1]:
            raise ValueError("the bump hangs over the flank")
        e = np.searchsorted(ends, at) - 1
        x = 2 * (at - ends[e]) / (ends[e + 1] - ends[e]) - 1
        axial = -(normal * np.conj(rise)).real
        length = np.hypot(1, axial)
        return e, x, weight * 15 / 16 * (1 - g * g) ** 2, normal / length, axial / length

    def reading(self, above, height):
        """Returns node numbers with the weights of their displacements."""
        e, x, weight, normal, axial = self.bump(above)
        layer = int(np.argmin(abs(self.z - height)))
        turned = normal * np.exp(1j * self.twist * self.z[layer])
        direction = np.array([turned.real, turned.imag, axial])
        of_node = {}
        for element, at, q in zip(e, x, weight):
            for k, n in enumerate(quadratic(at)):
                node = self.id[self.section.flank[2 * element + k], layer]
                of_node[node] = of_node.get(node, 0) + q * n * direction
        return of_node

    def load(self, above, part):
        """Returns the forces on nodes. The face of a brick on the flank has eight nodes."""
        e, x, weight, normal, axial = self.bump(above)
        force = {}
        g, gw = np.polynomial.legendre.leggauss(3)
        for first in range(0, len(self.z) - 2, 2):
            lo, hi = self.z[first], self.z[first + 2]
            if lo < part[0] - 1e-9 or hi > part[1] + 1e-9:
                continue
            for up, share in zip(g, gw / 2 * (hi - lo) / (part[1] - part[0])):
                turned = normal * np.exp(1j * self.twist * (lo + (hi - lo) * (up + 1) / 2))
                direction = np.array([turned.real, turned.imag, axial])
                for element, at, q in zip(e, x, weight):
                    for i in (-1, 0, 1):
                        for j in (-1, 0, 1):
                            if i == j == 0:
                                continue
                            if i and j:
                                n = (1 + i * at) * (1 + j * up) * (i * at + j * up - 1) / 4
                            else:
                                n = (1 - at * at) * (1 + j * up) / 2 if j else (1 + i * at) * (1 - up * up) / 2
                            node = self.id[self.section.flank[2 * element + 1 + i], first + 1 + j]
                            force[node] = force.get(node, 0) + q * share * n * direction
        return force

    def write(self, file, force):
        section = self.section
        file.write("*NODE,NSET=ALL\n")
        for i, w in enumerate(section.nodes):
            for layer in np.flatnonzero(self.id[i]):
                p = w * np.exp(1j * self.twist * self.z[layer])
                file.write(f"{self.id[i, layer]},{p.real:.12g},{p.imag:.12g},{self.z[layer]:.12g}\n")
        file.write("*ELEMENT,TYPE=C3D20,ELSET=ALL\n")
        number = 0
        for a in range(0, len(self.z) - 2, 2):
            for e in section.elements:
                low, middle, high = self.id[e, a], self.id[e[:4], a + 1], self.id[e, a + 2]
                number += 1
                n = [number, *low[:4], *high[:4], *low[4:], *high[4:], *middle]
                file.write(",".join(map(str, n[:16])) + ",\n" + ",".join(map(str, n[16:])) + "\n")
        for name, nodes in (("BORE", section.bore), ("FLANK", section.flank)):
            file.write(f"*NSET,NSET={name}\n" + "".join(f"{n},\n" for n in self.id[nodes].ravel() if n))
        file.write(f"*MATERIAL,NAME=M\n*ELASTIC\n1.,{POISSON}\n*SOLID SECTION,ELSET=ALL,MATERIAL=M\n"
                   "*BOUNDARY\nBORE,1,3,0.\n*STEP\n*STATIC,SOLVER=SPOOLES\n*CLOAD\n")
        for node, f in force.items():
            file.writelines(f"{node},{c + 1},{f[c]:.12g}\n" for c in range(3))
        file.write("*NODE PRINT,NSET=FLANK\nU\n*END STEP\n")

    def displacements(self, above, part):
        """Returns the displacements at READ under one load. CalculiX runs on one core."""
        with tempfile.TemporaryDirectory() as folder:
            case = pathlib.Path(folder) / "tooth"
            with open(f"{case}.inp", "w") as file:
                self.write(file, self.load(above, part))
            one = {"OMP_NUM_THREADS": "1", "CCX_NPROC_EQUATION_SOLVER": "1"}
            run = subprocess.run(["ccx", "-i", "tooth"], cwd=folder, env=os.environ | one, capture_output=True, text=True)
            rows = [line.split() for line in open(f"{case}.dat") if line.strip() and "displacements" not in line]
        if not rows:
            raise RuntimeError(run.stdout[-2000:])
        u = {int(node): np.array(xyz, float) for node, *xyz in rows}
        return [sum(q @ u[n] for n, q in self.reading(above, z).items()) for z in READ]


def made(beta_deg, loads=LOADS):
    tooth = Tooth(beta_deg, GEARS[beta_deg])

    def digits(values):
        return [float(f"{v:.5g}") for v in values]

    def row(above, part):
        bumps = tooth.displacements(above, part)
        strip = [u + tooth.half_space(above, z, part) for u, z in zip(bumps, READ)]
        return {"diameter": round(2 * (reference_radius(tooth.beta) + above), 9), "z": part,
                "bumps": digits(bumps), "strip": digits(strip)}
    return {"helix_angle_deg": beta_deg, "bore_diameter": GEARS[beta_deg], "unknowns": tooth.unknowns,
            "loads": [row(*load) for load in loads]}


def installed():
    return shutil.which("ccx") is not None


def main():
    about = {"made_by": "tests/oracle/bricks/tooth_bricks.py", "teeth": TEETH, "rack": "ISO53-A", "face_width": FACE,
             "poisson_ratio": POISSON, "read_z": READ}
    text = json.dumps(about | {"gears": [made(beta) for beta in GEARS]}, indent=1)
    DATA.write_text(re.sub(r"\[[^\[\]{}]*\]", lambda numbers: " ".join(numbers[0].split()), text) + "\n")


if __name__ == "__main__":
    main()
