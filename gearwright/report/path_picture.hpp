// The path of contact as a strip with its zones, specific sliding over it, and the contact ratios.
#pragma once

#include <string>
#include <vector>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// A stretch of the path on which the same number of tooth pairs touch.
struct ContactZone {
  double rho1_begin;  ///< mm
  double rho1_end;    ///< mm
  int pairs;          ///< tooth pairs in contact, helix left out (one transverse section)
};

/// Zones from A to E; with ε_α < 1 a last one of 0 pairs from E to where the next pair comes in.
///
///   Laws  (1) zones follow each other without a gap      (2) pairs is ⌊ε_α⌋ or ⌈ε_α⌉
/// Units     mm
std::vector<ContactZone> contact_zones(const ParallelMesh<double>& mesh);

/// The two figures.
std::string path_figures(const Pair& pair);

}  // namespace gearwright
