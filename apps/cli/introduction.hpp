// The introduction of `gearwright --help`.
#pragma once

namespace gearwright::apps {

inline constexpr const char* kIntroduction =
    "Gearwright: exact geometry, mesh and CAD files of cylindrical gears.\n\n"
    "  gearwright run pair.toml              everything: report.html, STEP, STL, 3MF, GLB, DXF, "
    "SVG\n"
    "  gearwright gear pair.toml             diameters, thicknesses, limits of each gear\n"
    "  gearwright pair pair.toml --json      the mounted pair, as JSON\n"
    "  gearwright contact pair.toml          transmission error and contact under [errors]\n"
    "  gearwright compensate pair.toml       corrections that cancel those errors\n"
    "  gearwright load pair.toml             teeth under torque: sharing, stiffness, stresses\n"
    "  gearwright rate pair.toml             strength by ISO 6336: factors, stresses, safeties\n"
    "  gearwright measure pair.toml          the calliper's settings\n"
    "  gearwright fit wish.toml              gears for a centre distance and a shaft angle\n"
    "  gearwright search wish.toml --out found  all designs within limits, ranked\n"
    "  gearwright outline pair.toml --gear 1 --points 200 --json\n"
    "  gearwright export pair.toml --step both.step --dxf pinion.dxf --gear 1\n"
    "  gearwright export pair.toml --drawing pair.pdf  the workshop drawing, a sheet for each "
    "gear\n"
    "  gearwright batch pair specs.jsonl     one spec per line, one answer per line\n"
    "  gearwright verify cases.json          comparison with published numbers\n"
    "  gearwright schema spec                the JSON Schema of specs, for editors; or of results\n"
    "  gearwright completion bash            completion for bash, zsh or fish\n\n"
    "A spec is a TOML file. The smallest one is:\n\n"
    "  [gear1]\n"
    "  teeth = 17\n"
    "  normal_module_mm = 2.5\n";

}  // namespace gearwright::apps
