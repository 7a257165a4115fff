// Includes all headers that a program about gears needs.
//
//   #include <gearwright/gearwright.hpp>
//   using namespace gearwright;
//   using namespace gearwright::literals;
//
//   CylindricalSpec spec{.teeth = 21, .normal_module = 3, .helix_angle = 12_deg, .face_width = 40};
//   const Result<Gear> pinion = make_gear(spec);
//   spec.teeth = 55, spec.helix_angle = -12_deg;
//   const Result<Gear> wheel = make_gear(spec);
//   if (!pinion || !wheel) return 1;  // error() names the number and the allowed range
//   const Result<Pair> pair = mount(*pinion, *wheel, {.center_distance = 116.6});
//   if (pair) std::printf("contact ratio %.4f\n", pair->contact_ratio());
//
// Lengths are in mm. Angles are Angle or rad, as the comment of each member states. Functions
// that can fail return a Result, which contains a value or an error. docs/programming.md shows the
// example programs of examples/cpp.
#pragma once

// Numbers and units: Angle, 20_deg, Result, µm and arcseconds, and the version.
#include "gearwright/base/angle.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/base/version.hpp"

// One gear: make_gear(), make_pinion_cut_gear() and flank modifications.
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/modifications.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/tool/rack.hpp"

// Two gears: mount(), mount_rack(), and the requirements on the housing.
#include "gearwright/pair/drive.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/pair/rack_pair.hpp"

// Incomplete drawings of gears or of a pinion and a rack: arrange() completes the missing numbers,
// and judge() returns a verdict. as_rack() describes a gear by another rack.
#include "gearwright/arrange/arrange.hpp"
#include "gearwright/arrange/judge.hpp"

// Contact under errors: contact() of a pair or a rack, contact_pattern(), map_of_errors(),
// compensate().
#include "gearwright/contact/corrections.hpp"
#include "gearwright/contact/error_map.hpp"
#include "gearwright/contact/pair_contact.hpp"
#include "gearwright/contact/pattern.hpp"
#include "gearwright/contact/rack_contact.hpp"

// Tolerances: scatter_of() computes their effect over many pairs. robust_corrections() reduces it.
#include "gearwright/scatter/robust.hpp"
#include "gearwright/scatter/scatter.hpp"

// Elastic teeth: loaded() computes contact under torque, and probes describe single teeth.
#include "gearwright/arrange/face_loads.hpp"
#include "gearwright/arrange/loaded_pair.hpp"

// Strength: rated_pair(), rate(), rate_spectrum(), torque_of_safety() and the table of steels.
#include "gearwright/rating/sizing.hpp"
#include "gearwright/rating/spectrum.hpp"

// Inspection: measure() a gear, and identify() an unknown gear.
#include "gearwright/arrange/measured_gear.hpp"
#include "gearwright/inspection/chordal_thickness.hpp"
#include "gearwright/inspection/identify.hpp"

// Whole drives: graph_of(), train_of(), make_drive(), rate_meshes() and search_drives().
#include "gearwright/design/drive_search.hpp"
#include "gearwright/drive/drive_rating.hpp"
#include "gearwright/drive/short_forms.hpp"

// Design: fit(), design_few_teeth() and Search.
#include "gearwright/design/few_teeth_design.hpp"
#include "gearwright/design/fit.hpp"
#include "gearwright/design/search.hpp"

// Files: gear_body() or drive_solids(), and the writers of STEP, STL, 3MF, GLB, DXF and SVG.
#include "gearwright/cad/drive_solids.hpp"
#include "gearwright/cad/dxf.hpp"
#include "gearwright/cad/mesh_files.hpp"
#include "gearwright/cad/step.hpp"
#include "gearwright/cad/svg_outline.hpp"
#include "gearwright/cad/toothed_body.hpp"
