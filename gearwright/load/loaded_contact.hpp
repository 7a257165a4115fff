// Computes the loaded tooth contact of a mounted pair of cylindrical gears over one pitch.
//
//   Θ    rad, additional rotation of gear 2 due to the deflection of the teeth
//   approach   Θ r_b2, along the line of action in the transverse section
//   loaded TE = TE − Θ (gear 2 lags)        theory: docs/theory/12-loaded-contact.md
//
// The gap at every position is computed by the functions of contact/, and the compliance is
// computed from the section modes of both gears. At each rotation, the loads are the solution of a
// complementarity problem. The problem is linear except for the logarithm of the Hertz contact.
#pragma once

#include <array>
#include <atomic>
#include <complex>
#include <mutex>
#include <optional>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/contact/contact_point.hpp"
#include "gearwright/load/shaft_yield.hpp"

namespace gearwright {

/// The Hertz contact ellipse of a tooth pair with point contact.
struct LoadedPoint {
  double force = 0.0;                          ///< N, normal force
  double pressure = 0.0;                       ///< MPa, greatest pressure
  double semi_major = 0.0, semi_minor = 0.0;   ///< mm
  std::array<double, 2> diameter{}, height{};  ///< mm, position of the middle on each gear
  /// Each semi-axis on the flank of each gear, mm. Its two components are the step along the face
  /// and the step in radius from the middle of the ellipse to the end of the semi-axis.
  std::array<std::array<Eigen::Vector2d, 2>, 2> half_axis{};
  TouchKind kind = TouchKind::interior;
  int track = 0;        ///< number of the contact path; a tooth with double circular arcs has two
  bool beyond = false;  ///< true if the ellipse extends beyond an end of the flank or the face
};

/// One tooth pair in contact at one position or, for point contact, one contact point of the pair.
struct LoadedPair {
  int pair = 0;         ///< k, number of the tooth pair in the frame N
  double share = 0.0;   ///< fraction of the total load
  LoadedPoint point{};  ///< for point contact; the members below are for line contact
  /// N/mm, force per length of the contact line, for each slice in the order of ascending z.
  Eigen::VectorXd line_load;
  Eigen::VectorXd pressure;                   ///< MPa, Hertz [T12.13]; 0 without contact
  Eigen::VectorXd half_width;                 ///< mm
  std::vector<std::array<double, 2>> radius;  ///< mm, on both gears, for each slice
};
/// The contact at one position. Values are NaN if no teeth touch or the forces do not converge; in
/// the second case, `unloaded_te` is present.
struct LoadedPosition {
  Angle rotation1{};
  Angle te = Angle::radians(kNoNumber);           ///< loaded TE
  Angle unloaded_te = Angle::radians(kNoNumber);  ///< TE at which the teeth first touch
  double approach = kNoNumber;                    ///< Θ r_b2  mm; for point contact Θ M2/ΣF
  double force = kNoNumber;                       ///< ΣF  N, normal force, for point contact only
  double tangent = kNoNumber;  ///< d(Θ r_b2)/dF_bt  mm/N; for point contact, M2/ΣF replaces r_b2
  /// Line load divided by approach, N/(mm µm) or, for point contact, force by approach, N/µm.
  double stiffness = kNoNumber;
  /// Loaded tooth pairs or contact points, from the start to the end of contact.
  std::vector<LoadedPair> pairs{};
  double max_pressure = kNoNumber;  ///< MPa
  /// Greatest half width of the contact, relative to the radius R of the gap.
  double max_width_ratio = kNoNumber;
  /// Kind of contact at the greatest pressure; none without a result.
  TouchKind kind = TouchKind::none;
  bool unfinished = false;  ///< true if teeth touch but the forces do not converge
  bool edge_carries = false;
  /// MPa, greatest principal stress at the root of each gear.
  std::array<double, 2> root_stress{kNoNumber, kNoNumber};
  int iterations = 0;

  bool solved() const { return kind != TouchKind::none; }
};

/// The contact under one torque. Means and extremes are taken over the solved positions. Without a
/// solved position, they keep their initial values.
struct LoadedTorque {
  double torque = 0.0;  ///< N mm
  std::vector<LoadedPosition> positions;
  Angle peak_to_peak = Angle::radians(kNoNumber);
  /// Empty if rotations are given or a position is unsolved, because a whole pitch is needed.
  std::vector<Angle> harmonics{};
  struct Stiffness {
    /// N/(mm µm), for point contact N/µm; `mean` is the load divided by the mean approach or, for
    /// point contact, the reciprocal of the mean approach per force
    double mean = kNoNumber, min = kNoNumber, max = kNoNumber;
  };
  Stiffness stiffness, without_twist, tangent;
  double max_pressure = kNoNumber;
  double max_share = 0.0;  ///< greatest load share of one tooth pair
  /// K_Hα: `max_share` divided by `max_share` of the same gears without errors [T12.19]; NaN if the
  /// latter is unknown
  double transverse_load_factor = 1.0;
  std::array<double, 2> max_root_stress{kNoNumber, kNoNumber};
  double face_load_factor = 1.0;  ///< K_Hβ: greatest value of `face_load` divided by its mean
  double max_width_ratio = 0.0;
  bool edge_carries = false;
  bool beyond_flank = false;  ///< true if an ellipse extends beyond an end of the flank
  /// N/mm, mean line load over the positions, for each slice in the order of ascending z.
  Eigen::VectorXd face_load;
  /// The deflection of the shafts under `face_load`, for line contact; none without shafts.
  std::optional<FaceDeflection> shafts{};
  /// For each gear, the greatest principal stress over the positions, MPa; 0 without tension. There
  /// is a row for each root point and a column for each slice, in the order of ascending z.
  std::array<Eigen::MatrixXd, 2> root_stress;
  /// The least principal stress at the same points, MPa; 0 without compression. A fillet is
  /// compressed while neighbouring teeth carry load.
  std::array<Eigen::MatrixXd, 2> least_root_stress;
  /// The value of `least_root_stress` at the point with the greatest `root_stress`, MPa.
  std::array<double, 2> least_at_max{kNoNumber, kNoNumber};
};

struct LoadedContact {
  LoadedContact() = default;  ///< an empty result; loaded_contact() computes the values
  std::vector<LoadedTorque> torques;
  LoadRegime regime = LoadRegime::line;
  std::array<FaceSlices, 2> slices;    ///< mm from the middle of the face of each gear
  std::array<double, 2> body_twist{};  ///< twist of each body, mm per N/mm at the base radius
  /// Points of each gear along the fillet in tension, starting at the root, mm. In the section, the
  /// centre line of the tooth is the x axis, and the loaded flank is at y > 0.
  std::array<std::vector<std::complex<double>>, 2> root_points;
  long unfinished = 0;  ///< number of positions without convergence, over all torques
  bool slices_too_fine = false;
};

/// Returns the rotations of the request, or its positions over one pitch of gear 1.
std::vector<Angle> rotations_of(const ContactPair& pair, const LoadRequest& request);

/// Computes the loaded contact of `pair`. K_Hα is computed by means of `perfect`, which is the same
/// pair without mounting errors and deflections. `perfect` is null if `pair` itself has no errors
/// and no deflections.
///
/// Domain    `pair` consists of `gear_1` and `gear_2`; torques > 0 (contract)
LoadedContact loaded_contact(const ContactPair& pair, const Gear& gear_1, const Gear& gear_2,
                             const PairCompliance& compliance, const LoadRequest& request,
                             const ContactPair* perfect = nullptr);

/// Performs the computation of loaded_contact() in parts. The calls of solve() must cover all
/// positions before result() is called. Their order does not matter, and they may run in several
/// threads. The inputs must outlive the object.
class LoadedTurn {
 public:
  LoadedTurn(const ContactPair& pair, const Gear& gear_1, const Gear& gear_2,
             const PairCompliance& compliance, const LoadRequest& request,
             const ContactPair* perfect = nullptr);
  std::size_t positions() const { return rotations_.size(); }
  void solve(std::size_t from, std::size_t to);
  LoadedContact result() const;

 private:
  const ContactPair& pair_;
  const Gear &one_, &two_;
  const PairCompliance& compliance_;
  const LoadRequest& request_;
  const ContactPair* perfect_;
  LoadRequest undeflected_;  // for the perfect pair
  template <class Solver>
  void solve_with(std::size_t from, std::size_t to);

  std::vector<Angle> rotations_;
  // Greatest share of a tooth pair, [torque][position].
  std::vector<std::vector<double>> perfect_share_;
  LoadedContact found_;
  std::atomic<bool> too_fine_{false};
  std::mutex root_;  // guards the greatest root stress
};

}  // namespace gearwright
