// Makes the spec of the tab "search" for a search around the pair on screen.

import type { Json } from "../engine_worker";
import { at, bench } from "../workbench";

/** Returns the spec of a search for designs that are similar to the pair on screen. */
export function around(): string {
  const pair = bench.good?.result?.["pair"];
  const gears = (bench.good?.result?.["gears"] ?? []) as unknown as {
    teeth: number;
    helix_angle_deg: number;
  }[];
  const u = Math.abs(Number(at(pair, "gear_ratio")));
  const a = Number(at(pair, "center_distance_mm"));
  const z1 = Math.abs(gears[0]?.teeth ?? 20);
  const sign = (gears[1]?.teeth ?? 1) < 0 ? -1 : 1;
  const band = [0.97 * u * sign, 1.03 * u * sign].sort((x, y) => x - y).map((x) => x.toFixed(4));
  return `title = "around ${z1} : ${gears[1]?.teeth ?? ""}"

[search]
ratio = [${band.join(", ")}]
center_distance_mm = [${(0.98 * a).toFixed(3)}, ${(1.02 * a).toFixed(3)}]
modules_mm = "ISO54-I"
pinion_teeth = [${Math.max(5, z1 - 12)}, ${z1 + 12}]
helix_angle_deg = ${gears[0]?.helix_angle_deg ?? 0}
contact_ratio_min = 1.2
objective = ["contact_ratio", "sliding"]
`;
}

export function measured(spec: Json): boolean {
  return at(spec, "gear1.measured") !== undefined || at(spec, "gear2.measured") !== undefined;
}
