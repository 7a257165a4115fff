// The scene of the tab "solid". It consists of both gears or the parts of a drive as meshes of the
// engine, a light that moves with the camera, a cutting plane, and the contact on the flanks.
//
// The scene is drawn again only if something has changed.

import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { DriveSolids, Mesh } from "../../engine/engine";
import { colour, onKeys, onNextFrame } from "../elements";
import { ContactMarks } from "./contact_marks";
import { kMetal, markedMaterial, metal, type Marking } from "./marking";

function geometryOf(mesh: Mesh): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(mesh.positions, 3));
  geometry.setAttribute("normal", new THREE.BufferAttribute(mesh.normals, 3));
  geometry.setIndex(new THREE.BufferAttribute(mesh.indices, 1));
  return geometry;
}

/** Direction from the solids to the camera. */
const kView = new THREE.Vector3(-0.42, 0.38, 0.82).normalize();
/** Distance of the camera relative to the least distance at which everything is visible. */
const kMargin = 1.08;

export class SolidScene {
  readonly marks = new ContactMarks();
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.PerspectiveCamera(28, 1, 0.1, 1e5);
  private readonly orbit: OrbitControls;
  private readonly gears: THREE.Group[] = [];
  private readonly markings: Marking[] = [];
  private readonly cut = new THREE.Plane(new THREE.Vector3(0, 0, -1), 1e9);
  private radius = 0;
  private readonly home = new THREE.Vector3(); // position of the camera that look() has chosen
  readonly repaint = onNextFrame(() => this.draw());

  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new THREE.WebGLRenderer({
      canvas,
      antialias: true,
      alpha: true,
      preserveDrawingBuffer: true,
    });
    this.renderer.localClippingEnabled = true;
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.enableDamping = false;
    this.orbit.zoomToCursor = true;
    this.orbit.addEventListener("change", () => this.repaint());
    const key = new THREE.DirectionalLight(0xffffff, 2.6);
    key.position.set(-0.5, 1.3, 0.9);
    const fill = new THREE.DirectionalLight(0xffffff, 0.55);
    fill.position.set(1, -0.5, 0.8);
    this.camera.add(key, fill);
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x6a7078, 1.0), this.camera, this.marks.group);
    onKeys(canvas, {
      ArrowLeft: () => this.turn(this.camera.up, 0.12),
      ArrowRight: () => this.turn(this.camera.up, -0.12),
      ArrowUp: () => this.turn(this.across, 0.12),
      ArrowDown: () => this.turn(this.across, -0.12),
      "+": () => this.come(0.85),
      "=": () => this.come(0.85),
      "-": () => this.come(1 / 0.85),
      "0": () => this.look(),
    });
    canvas.addEventListener("dblclick", () => this.look());
  }

  /** Replaces the solids by gears without markings. The camera stays, and frame() moves it. */
  setMeshes(meshes: Mesh[], internal: boolean[], driver: number): void {
    // Materials are kept, because the graphics card compiles a program for each new material.
    const keep = meshes.length > 0 && this.markings.length === meshes.length;
    if (!keep) this.clear();
    meshes.forEach((mesh, i) => {
      const geometry = geometryOf(mesh);
      if (keep) {
        const [outer, inner] = this.gears[i]!.children as THREE.Mesh[];
        outer!.geometry.dispose();
        outer!.geometry = inner!.geometry = geometry;
      } else {
        const { material, marking } = markedMaterial(i, this.cut);
        this.add(geometry, material, colour(`g${i + 1}-fill`));
        this.markings.push(marking);
      }
      this.markings[i]!.set(null, 0);
      this.markings[i]!.faces((internal[i] ? 1 : -1) * (driver === 2 ? -1 : 1));
    });
    this.repaint();
  }

  /** Replaces the solids with the parts of a drive, in the colours of their bodies. */
  setParts({ parts, bodies }: DriveSolids): void {
    this.clear();
    const shapes: THREE.BufferGeometry[] = [];
    for (const { mesh, same, body, name } of parts) {
      shapes.push(mesh ? geometryOf(mesh) : shapes[same!]!);
      const color = new THREE.Color(...bodies[body]!.colour);
      const material = new THREE.MeshStandardMaterial({ ...kMetal, color, clippingPlanes: [this.cut] });
      this.add(shapes.at(-1)!, material, color.clone().lerp(new THREE.Color(1, 1, 1), 0.35)).name = name;
    }
    this.repaint();
  }

  private clear(): void {
    for (const gear of this.gears) {
      this.scene.remove(gear);
      gear.traverse((part) => {
        if (!(part instanceof THREE.Mesh)) return;
        part.geometry.dispose();
        (part.material as THREE.Material).dispose();
      });
    }
    for (const marking of this.markings) marking.texture.dispose();
    this.gears.length = this.markings.length = 0;
  }

  /** Adds a solid. Its cut face has a flat colour, as in a section on a drawing. */
  private add(geometry: THREE.BufferGeometry, material: THREE.Material, color: THREE.ColorRepresentation): THREE.Group {
    const inside = new THREE.MeshBasicMaterial({ color, side: THREE.BackSide, clippingPlanes: [this.cut] });
    const group = new THREE.Group();
    group.add(new THREE.Mesh(geometry, material), new THREE.Mesh(geometry, inside));
    group.matrixAutoUpdate = false;
    this.gears.push(group);
    this.scene.add(group);
    return group;
  }

  /** Sets all colours for the light or dark colour scheme. */
  recolour(): void {
    // The parts of a drive have no markings and keep their colours.
    this.gears.slice(0, this.markings.length).forEach((gear, i) => {
      const [outer, inner] = gear.children as THREE.Mesh[];
      (outer!.material as THREE.MeshStandardMaterial).color.copy(metal(i));
      (inner!.material as THREE.MeshBasicMaterial).color.set(colour(`g${i + 1}-fill`));
    });
    this.marks.recolour();
    this.repaint();
  }

  get count(): number {
    return this.gears.length;
  }
  marking(gear: number): Marking | undefined {
    return this.markings[gear];
  }

  /** Sets the pose of a gear, given as a column-major 4×4 matrix. */
  place(gear: number, pose: number[]): void {
    const group = this.gears[gear];
    if (!group) return;
    group.matrix.fromArray(pose);
    group.matrixWorldNeedsUpdate = true;
    this.repaint();
  }

  /** Cuts off everything above z, mm. Infinity removes the cut. */
  section(z: number): void {
    this.cut.constant = Number.isFinite(z) ? z : 1e9;
    this.repaint();
  }

  /** Returns the least and the greatest z of the solids, and the length of their diagonal, mm. */
  extent(): { low: number; high: number; size: number } {
    const box = this.bounds();
    return { low: box.min.z, high: box.max.z, size: box.max.distanceTo(box.min) };
  }
  private bounds(): THREE.Box3 {
    const box = new THREE.Box3();
    this.scene.updateMatrixWorld(true);
    for (const gear of this.gears) box.expandByObject(gear);
    return box;
  }

  /** Moves the camera so that everything is visible. Does nothing if `take` is false and the size has
   *  hardly changed. */
  frame(take: boolean): void {
    const sphere = this.bounds().getBoundingSphere(new THREE.Sphere());
    if (!take && Math.abs(sphere.radius - this.radius) < 0.25 * this.radius) return;
    this.radius = sphere.radius;
    this.look();
  }
  look(): void {
    const box = this.bounds();
    if (!(box.max.distanceTo(box.min) > 0)) return;
    const center = box.getCenter(new THREE.Vector3());
    const distance = kMargin * this.distanceTo(center);
    this.orbit.target.copy(center);
    this.camera.position.copy(center).addScaledVector(kView, distance);
    this.camera.near = distance / 500;
    this.camera.far = distance * 20;
    this.camera.updateProjectionMatrix();
    this.orbit.update();
    this.home.copy(this.camera.position);
    this.repaint();
  }

  /** Returns the least distance of the camera from `center`, in the direction kView, at which every vertex is
   *  visible. */
  private distanceTo(center: THREE.Vector3): number {
    const aspect = Math.max(0.2, this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight));
    const half = Math.tan((this.camera.fov * Math.PI) / 360);
    const right = new THREE.Vector3().crossVectors(this.camera.up, kView).normalize();
    const up = new THREE.Vector3().crossVectors(kView, right);
    const at = new THREE.Vector3();
    let distance = 0;
    for (const gear of this.gears) {
      const { position } = (gear.children[0] as THREE.Mesh).geometry.attributes;
      for (let i = 0; i < position!.count; ++i) {
        at.fromBufferAttribute(position!, i).applyMatrix4(gear.matrixWorld).sub(center);
        const aside = Math.max(Math.abs(at.dot(right)) / aspect, Math.abs(at.dot(up)));
        distance = Math.max(distance, at.dot(kView) + aside / half);
      }
    }
    return distance;
  }

  private draw(): void {
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    if (!width || !height) return;
    const size = this.renderer.getSize(new THREE.Vector2());
    if (size.x !== width || size.y !== height) {
      this.renderer.setPixelRatio(Math.min(2, devicePixelRatio || 1));
      this.renderer.setSize(width, height, false);
      this.camera.aspect = width / height;
      this.camera.updateProjectionMatrix();
      // A view that the user has not changed is fitted to the new size.
      if (this.camera.position.equals(this.home)) this.look();
    }
    this.renderer.render(this.scene, this.camera);
  }

  private get across(): THREE.Vector3 {
    return new THREE.Vector3(1, 0, 0).applyQuaternion(this.camera.quaternion);
  }
  private turn(axis: THREE.Vector3, angle: number): void {
    this.camera.position.sub(this.orbit.target).applyAxisAngle(axis, angle).add(this.orbit.target);
    this.orbit.update();
    this.repaint();
  }
  private come(factor: number): void {
    this.camera.position.sub(this.orbit.target).multiplyScalar(factor).add(this.orbit.target);
    this.orbit.update();
    this.repaint();
  }
}
