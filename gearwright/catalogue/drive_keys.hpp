// The keys of a drive: [planetary], [[stage]] and the graph [drive].
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/key.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright {

const KeyTable& planetary_keys();

/// The inputs of a [[stage]] with a pair of gears.
struct StageInput {
  StageSpec stage;
  PairTeeth plain{};   ///< data of the teeth; used only if the module is given
  std::string series;  ///< name of a series of thickness allowances of DIN 3967
  PerMesh backlash;    ///< j_n  mm, of the only mesh of the pair
  PerMesh efficiency;  ///< η
};

const KeyTable& stage_keys();
/// The keys of [gear1] that also apply to a gear of a drive, for example to a gear in the list
/// `gears` of a stage.
const KeyTable& stage_gear_keys();

/// [drive]: the graph, and the names of the bodies and gears to which it refers.
struct GraphInput {
  struct Body {
    DriveBody body;
    std::string rides_on;  ///< name of a body, or empty
  };
  struct Mesh {
    DriveMesh mesh;
    std::array<std::string, 2> gears;
  };
  DriveGraph graph;
  std::vector<std::string> fixed, inputs, output;
  std::optional<double> speed_m_per_s;  ///< v, if the input is a rack
  std::optional<double> force_N;        ///< F, if the input is a rack
  std::vector<Body> bodies;
  std::vector<Mesh> meshes;
};

const KeyTable& drive_keys();
const KeyTable& drive_body_keys();
const KeyTable& drive_gear_keys();
const KeyTable& drive_mesh_keys();

// The keys of a [search] for whole drives. Such a search has the key `kind`.

const KeyTable& drive_search_keys();

}  // namespace gearwright
