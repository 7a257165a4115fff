// Computes positions of the gears while they turn. The engine computes exact poses over one pitch of gear 1,
// and the page interpolates between these poses. After one pitch, the next tooth takes the place of the
// previous one.
//
//   t   rotation of gear 1 in its pitches, −½ … ½

import type { ContactCurve } from "../engine/engine";

export interface Motion {
  pitchDeg: number;
  n: number; // number of positions from −½ to ½, both included
  places: Float64Array[]; // for each gear, 16 numbers per position (a column-major matrix)
  curve: ContactCurve | null;
}

/** Returns the angle about its own z axis by which pose `a` must be turned to give pose `b`. The angle follows from
 *  the first two columns of both poses. */
function turnBetween(a: ArrayLike<number>, b: ArrayLike<number>): number {
  const cos = a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;
  const sin = a[4]! * b[0]! + a[5]! * b[1]! + a[6]! * b[2]!;
  return Math.atan2(sin, cos);
}

/** Returns a pose between two poses of the engine, as 16 numbers. The rotation is interpolated as an angle, and all
 *  other numbers linearly. */
export function poseAt(motion: Motion, gear: number, t: number): number[] {
  const all = motion.places[gear]!;
  const at = Math.min(Math.max((t + 0.5) * (motion.n - 1), 0), motion.n - 1);
  const i = Math.min(Math.floor(at), motion.n - 2);
  const a = all.subarray(16 * i, 16 * i + 16);
  const b = all.subarray(16 * i + 16, 16 * i + 32);
  const share = at - i;
  const angle = turnBetween(a, b) * share;
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  const pose = Array.from(a);
  for (let k = 0; k < 3; ++k) {
    pose[k] = c * a[k]! + s * a[4 + k]!;
    pose[4 + k] = c * a[4 + k]! - s * a[k]!;
    pose[12 + k] = a[12 + k]! + share * (b[12 + k]! - a[12 + k]!);
  }
  return pose;
}

/** Returns the rotation of a gear about its own axis from the pose at t = −½, rad. */
export function turnAt(motion: Motion, gear: number, t: number): number {
  return turnBetween(motion.places[gear]!, poseAt(motion, gear, t));
}

/** Returns the contact point at the position nearest to t, or null if no teeth touch. */
export function touchAt(motion: Motion, t: number): { x: number; y: number; z: number } | null {
  const points = motion.curve?.columns["point_mm"];
  if (!motion.curve || !(points instanceof Float64Array)) return null;
  const n = motion.curve.n;
  const i = ((Math.round((t + 0.5) * n) % n) + n) % n;
  const [x, y, z] = points.subarray(3 * i, 3 * i + 3);
  return Number.isFinite(x) ? { x: x!, y: y!, z: z! } : null;
}
