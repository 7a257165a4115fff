// Draws the contact pattern on the flanks with the graphics card. A raster of the engine
// contains the gap as a function of diameter and height. Points of the flank have another
// colour if the gap is less than the thickness of the marking compound.

import * as THREE from "three";
import type { FlankRaster } from "../../engine/engine";
import { colour } from "../elements";

export interface Marking {
  texture: THREE.DataTexture;
  /** `side` is +1 if the working flanks face counter-clockwise about the axis of the gear, and −1 if they face
   *  clockwise. */
  faces(side: number): void;
  set(raster: FlankRaster | null, thickness: number): void;
}

export const kMetal = { metalness: 0.25, roughness: 0.48 };
const kFar = 1e3; // mm; stands for an infinite gap

/** Returns the colour of a gear, paler than on paper, so that light and shade remain visible. */
export function metal(gear: number): THREE.Color {
  return new THREE.Color(colour(`g${gear + 1}`)).lerp(new THREE.Color(colour(`g${gear + 1}-fill`)), 0.32);
}

/** Returns a material in the colour of a gear, with a contact pattern on its working flanks. */
export function markedMaterial(
  gear: number,
  cut: THREE.Plane,
): { material: THREE.Material; marking: Marking } {
  const texture = new THREE.DataTexture(new Float32Array([kFar]), 1, 1, THREE.RedFormat, THREE.FloatType);
  texture.needsUpdate = true;
  const uniforms = {
    gaps: { value: texture },
    span: { value: new THREE.Vector4(0, 1, 0, 1) }, // least and greatest diameter, then height, mm
    size: { value: new THREE.Vector2(1, 1) },
    thickness: { value: 0 },
    side: { value: 1 },
    shine: { value: new THREE.Color(colour("action")) },
  };
  const material = new THREE.MeshStandardMaterial({
    ...kMetal,
    color: metal(gear),
    clippingPlanes: [cut],
  });
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nvarying vec3 ownPlace; varying vec3 ownNormal;")
      .replace(
        "#include <begin_vertex>",
        "#include <begin_vertex>\nownPlace = position; ownNormal = normal;",
      );
    shader.fragmentShader = shader.fragmentShader
      .replace(
        "#include <common>",
        `#include <common>
        varying vec3 ownPlace; varying vec3 ownNormal;
        uniform sampler2D gaps; uniform vec4 span; uniform vec2 size; uniform float thickness, side; uniform vec3 shine;
        float cell(vec2 at) { return texelFetch(gaps, ivec2(clamp(at, vec2(0.0), size - 1.0)), 0).r; }
        float gapAt(vec2 place) { // bilinear
          vec2 at = place * (size - 1.0), low = floor(at), share = at - low;
          return mix(mix(cell(low), cell(low + vec2(1, 0)), share.x), mix(cell(low + vec2(0, 1)), cell(low + vec2(1, 1)), share.x), share.y);
        }`,
      )
      .replace(
        "#include <color_fragment>",
        `#include <color_fragment>
        float around = -ownNormal.x * ownPlace.y + ownNormal.y * ownPlace.x;
        float diameter = 2.0 * length(ownPlace.xy);
        vec2 place = vec2((ownPlace.z - span.z) / (span.w - span.z), (diameter - span.x) / (span.y - span.x));
        if (thickness > 0.0 && around * side > 0.05 * diameter && all(greaterThanEqual(place, vec2(0.0))) && all(lessThanEqual(place, vec2(1.0)))) {
          float gap = gapAt(place);
          float soft = max(fwidth(gap), 1e-6);
          diffuseColor.rgb = mix(diffuseColor.rgb, shine, 0.72 * (1.0 - smoothstep(thickness - soft, thickness + soft, gap)));
        }`,
      );
  };
  const marking: Marking = {
    texture,
    faces(side) {
      uniforms.side.value = side;
    },
    set(raster, thickness) {
      uniforms.thickness.value = raster ? thickness : 0;
      if (!raster) return;
      const rows = raster.diameter.length;
      const columns = raster.height.length;
      const data = Float32Array.from(raster.gap, (gap) => (gap < kFar ? gap : kFar));
      this.texture.dispose();
      this.texture = new THREE.DataTexture(data, columns, rows, THREE.RedFormat, THREE.FloatType);
      this.texture.needsUpdate = true;
      uniforms.gaps.value = this.texture;
      uniforms.size.value.set(columns, rows);
      uniforms.span.value.set(
        raster.diameter[0]!,
        raster.diameter[rows - 1]!,
        raster.height[0]!,
        raster.height[columns - 1]!,
      );
    },
  };
  return { material, marking };
}
