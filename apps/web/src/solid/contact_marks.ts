// Shows the contact point while it moves, and the ellipse or line within which the gap between the flanks is
// less than the thickness of the marking compound. docs/spec.md, contact.positions, defines the directions.
// The angle of the major axis is measured about the normal, from the projection of axis 1.

import * as THREE from "three";
import type { ContactCurve } from "../../engine/engine";
import { colour } from "../elements";

const kCorners = 72;

export class ContactMarks {
  readonly group = new THREE.Group();
  private readonly material = new THREE.LineBasicMaterial({ color: colour("ink"), depthTest: false });
  private readonly dotMaterial = new THREE.MeshBasicMaterial({ color: colour("action"), depthTest: false });
  private readonly ellipse = new THREE.LineLoop(new THREE.BufferGeometry(), this.material);
  private readonly line = new THREE.Line(new THREE.BufferGeometry(), this.material);
  private readonly dot = new THREE.Mesh(new THREE.SphereGeometry(1, 20, 14), this.dotMaterial);

  constructor() {
    for (const part of [this.ellipse, this.line, this.dot]) {
      part.renderOrder = 10;
      part.frustumCulled = false;
      this.group.add(part);
    }
    this.group.visible = false;
  }

  recolour(): void {
    this.material.color.set(colour("ink"));
    this.dotMaterial.color.set(colour("action"));
  }

  /** Shows position i of a curve. `size` is the size of the pair in mm. */
  show(curve: ContactCurve | null, i: number, size: number): void {
    const points = curve?.columns["point_mm"];
    const normals = curve?.columns["normal"];
    this.group.visible = false;
    if (!(points instanceof Float64Array) || !(normals instanceof Float64Array)) return;
    const point = new THREE.Vector3().fromArray(points, 3 * i);
    if (!Number.isFinite(point.x)) return;
    this.group.visible = true;
    this.dot.position.copy(point);
    this.dot.scale.setScalar(size * 0.006);
    const number = (key: string) => {
      const column = curve!.columns[key];
      return column instanceof Float64Array ? column[i]! : NaN;
    };
    const major = number("ellipse.semi_major_mm");
    const minor = number("ellipse.semi_minor_mm");
    this.ellipse.visible = Number.isFinite(major) && Number.isFinite(minor);
    if (this.ellipse.visible)
      this.drawEllipse(
        point,
        new THREE.Vector3().fromArray(normals, 3 * i),
        number("ellipse.angle_deg"),
        major,
        minor,
      );
    const ends = curve!.columns["line_mm"];
    this.line.visible = ends instanceof Float64Array && Number.isFinite(ends[6 * i]);
    if (this.line.visible)
      this.line.geometry.setFromPoints(
        [0, 3].map((k) => new THREE.Vector3().fromArray(ends as Float64Array, 6 * i + k)),
      );
  }

  private drawEllipse(
    middle: THREE.Vector3,
    normal: THREE.Vector3,
    angleDeg: number,
    major: number,
    minor: number,
  ): void {
    const axis = new THREE.Vector3(0, 0, 1);
    const along = axis
      .addScaledVector(normal, -normal.z)
      .normalize()
      .applyAxisAngle(normal, (angleDeg * Math.PI) / 180);
    const across = new THREE.Vector3().crossVectors(normal, along);
    const points = Array.from({ length: kCorners }, (_, k) => {
      const angle = (2 * Math.PI * k) / kCorners;
      return middle
        .clone()
        .addScaledVector(along, major * Math.cos(angle))
        .addScaledVector(across, minor * Math.sin(angle));
    });
    this.ellipse.geometry.setFromPoints(points);
  }
}
