// Loaded tooth contact: a mounted pair of cylindrical gears under torque, turned through a pitch.
//
//   Θ    rad, by which gear 2 yields more than the rigid flanks would let it turn
//   approach   Θ r_b2, along the line of action in the transverse section
//   loaded TE = TE − Θ (gear 2 hangs back)        theory: docs/theory/12-loaded-contact.md
//
// The gap of every place comes from contact, the compliance from the section modes of both gears;
// what remains at a position is a linear complementarity problem with Hertz' logarithm in it.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "gearwright/base/headway.hpp"
#include "gearwright/compliance/tooth_table.hpp"
#include "gearwright/load/gap_places.hpp"

namespace gearwright {

struct LoadRequest {
  std::vector<double> torques;     ///< M1  N mm, on gear 1, > 0
  int positions = 64;              ///< over one pitch of gear 1
  std::vector<Angle> rotations{};  ///< of gear 1: these instead of positions
  int slices = 32;                 ///< over the common face
  ComplianceAccuracy accuracy = ComplianceAccuracy::full;
  std::array<ElasticBody, 2> bodies{};
  double deflection_slope = 0.0;  ///< mm, further approach of the flanks over the common face
  double deflection_bow = 0.0;    ///< mm, height of its parabola in the middle
  Headway* headway = nullptr;
  /// Does the work of items [0, n) by calling it for ranges that together are all of them, from
  /// several threads if it likes; none: one after the other. The answer is the same to the last bit.
  std::function<void(std::size_t n, const std::function<void(std::size_t, std::size_t)>& work)>
      spread{};
};

/// One tooth pair in contact at one position.
struct LoadedPair {
  int pair = 0;                ///< k in N
  double share = 0.0;          ///< of the whole load
  Eigen::VectorXd line_load;   ///< N/mm, per length of the contact line, slice by slice
  Eigen::VectorXd pressure;    ///< MPa, Hertz [T12.13]; 0 where nothing presses
  Eigen::VectorXd half_width;  ///< mm
  std::vector<std::array<double, 2>> radius;  ///< mm of each place on both gears
};

struct LoadedPosition {
  Angle rotation1;
  Angle te;                          ///< loaded
  Angle unloaded_te;                 ///< of the first touch, deflections included
  double approach = 0.0;             ///< Θ r_b2  mm
  double tangent = 0.0;              ///< d(Θ r_b2)/dF_bt  mm/N
  std::vector<LoadedPair> pairs;     ///< that carry; the one nearest to its exit last
  double max_pressure = 0.0;         ///< MPa
  double max_width_ratio = 0.0;      ///< greatest half width of contact over its radius
  TouchKind kind = TouchKind::line;  ///< or the edge that carries most
  bool edge_carries = false;
  std::array<double, 2> root_stress{};  ///< MPa, greatest principal at the root of each gear
  int iterations = 0;
};

struct LoadedTorque {
  double torque = 0.0;  ///< N mm
  std::vector<LoadedPosition> positions;
  Angle peak_to_peak;
  std::vector<Angle> harmonics;  ///< empty for rotations
  struct Stiffness {
    double mean = 0.0, min = 0.0, max = 0.0;  ///< N/(mm µm); mean: at the mean approach
  };
  Stiffness stiffness, without_twist, tangent;
  double max_pressure = 0.0;
  std::array<double, 2> max_root_stress{};
  double face_load_factor = 1.0;  ///< K_Hβ: load over the face, mean of the positions
  double max_width_ratio = 0.0;
  bool edge_carries = false;
  Eigen::VectorXd face_load;  ///< N/mm per slice, mean of the positions
};

struct LoadedContact {
  std::vector<LoadedTorque> torques;
  FaceSlices slices;                   ///< mm
  std::array<double, 2> body_twist{};  ///< mm per N/mm at the base radius
  long unfinished = 0;
  bool slices_too_fine = false;
};

/// The tables of both gears: what the outlines, faces and materials give. Torques, errors and
/// modifications do not change them.
struct PairCompliance {
  std::array<std::shared_ptr<const ToothTable>, 2> table;
  std::array<ElasticBody, 2> bodies;
  FaceSlices slices;        ///< mm
  double half_width = 0.0;  ///< a0  mm
};

/// Domain    parallel external involute gears (contract)
/// Errors    `gearN.…` as make_section_mesh
Result<PairCompliance> pair_compliance(const Gear& gear_1, const Gear& gear_2,
                                       const LoadRequest& request);

/// Domain    the pair of these gears; torques > 0 (contract)
LoadedContact loaded_contact(const ContactPair& pair, const Gear& gear_1, const Gear& gear_2,
                             const PairCompliance& compliance, const LoadRequest& request);

}  // namespace gearwright
