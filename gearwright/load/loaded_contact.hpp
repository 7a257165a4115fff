// Loaded tooth contact: a mounted pair of cylindrical gears under torque, turned through a pitch.
//
//   Θ    rad, additional rotation of gear 2 due to the deflection of the teeth
//   approach   Θ r_b2, along the line of action in the transverse section
//   loaded TE = TE − Θ (gear 2 lags)        theory: docs/theory/12-loaded-contact.md
//
// Room contact computes the gap of every position, and the section modes of both gears give the
// compliance. Each rotation is then a linear complementarity problem with the logarithm of Hertz.
#pragma once

#include <array>
#include <atomic>
#include <complex>
#include <limits>
#include <mutex>
#include <vector>

#include "gearwright/contact/contact_point.hpp"
#include "gearwright/load/pair_compliance.hpp"

namespace gearwright {

/// The ellipse of Hertz of a tooth pair with point contact.
struct LoadedPoint {
  double force = 0.0;                          ///< N, normal
  double pressure = 0.0;                       ///< MPa, greatest
  double semi_major = 0.0, semi_minor = 0.0;   ///< mm
  std::array<double, 2> diameter{}, height{};  ///< mm on each gear, of its middle
  /// Both half axes on each gear's flank, as steps along the face and in radius, mm.
  std::array<std::array<Eigen::Vector2d, 2>, 2> half_axis{};
  TouchKind kind = TouchKind::interior;
  int track = 0;        ///< number of contact patches; double arcs have two on a tooth
  bool beyond = false;  ///< true if the ellipse extends beyond an end of the flank or the face
};

/// One tooth pair in contact at one position; for point contact, one of its places.
struct LoadedPair {
  int pair = 0;                ///< k in N
  double share = 0.0;          ///< of the whole load
  LoadedPoint point{};         ///< for point contact; the members below are for line contact
  Eigen::VectorXd line_load;   ///< N/mm, per length of the contact line, slices from −z on
  Eigen::VectorXd pressure;    ///< MPa, Hertz [T12.13]; 0 without contact
  Eigen::VectorXd half_width;  ///< mm
  std::vector<std::array<double, 2>> radius;  ///< mm of each place on both gears
};

/// NaN if no teeth touch or the forces do not converge.
struct LoadedPosition {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  Angle rotation1{};
  Angle te = Angle::radians(kNone);           ///< loaded
  Angle unloaded_te = Angle::radians(kNone);  ///< of the first touch, deflections included
  double approach = kNone;                    ///< Θ r_b2  mm; of points Θ M2/ΣF
  double force = kNone;                       ///< ΣF  N, normal; of points
  double tangent = kNone;                     ///< d(Θ r_b2)/dF_bt  mm/N; of points by the same arm
  /// Line load over approach, N/(mm µm); for point contact, force over approach, N/µm.
  double stiffness = kNone;
  std::vector<LoadedPair> pairs{};  ///< loaded pairs or points; the nearest to its exit last
  double max_pressure = kNone;      ///< MPa
  double max_width_ratio = kNone;   ///< greatest half width of contact over its radius
  TouchKind kind =
      TouchKind::none;      ///< line, interior, or the edge with most load; none without a result
  bool unfinished = false;  ///< true if teeth touch but the forces do not converge
  bool edge_carries = false;
  std::array<double, 2> root_stress{kNone, kNone};  ///< MPa, greatest principal at each root
  int iterations = 0;

  bool solved() const { return kind != TouchKind::none; }
};

/// Values over the solved positions; NaN if there are none.
struct LoadedTorque {
  double torque = 0.0;  ///< N mm
  std::vector<LoadedPosition> positions;
  Angle peak_to_peak = Angle::radians(LoadedPosition::kNone);
  /// Empty for given rotations, and if any position is not solved, because harmonics need the whole
  /// pitch.
  std::vector<Angle> harmonics{};
  struct Stiffness {
    /// N/(mm µm), N/µm; `mean` is the value at the mean approach
    double mean = LoadedPosition::kNone, min = LoadedPosition::kNone, max = LoadedPosition::kNone;
  };
  Stiffness stiffness, without_twist, tangent;
  double max_pressure = LoadedPosition::kNone;
  double max_share = 0.0;  ///< of one tooth pair
  /// K_Hα: the greatest share over that of the pair without errors, [T12.19]
  double transverse_load_factor = 1.0;
  std::array<double, 2> max_root_stress{LoadedPosition::kNone, LoadedPosition::kNone};
  double face_load_factor = 1.0;  ///< K_Hβ: load over the face, mean of the positions
  double max_width_ratio = 0.0;
  bool edge_carries = false;
  bool beyond_flank = false;  ///< true if an ellipse extends beyond an end of the flank
  Eigen::VectorXd face_load;  ///< N/mm per slice from −z on, mean of the positions
  /// The greatest principal stress over the positions, MPa, of each gear: a row per root point, a
  /// column per slice from −z on; 0 without tension.
  std::array<Eigen::MatrixXd, 2> root_stress;
  /// The least principal stress there, 0 without compression; a fillet is compressed while
  /// neighbouring teeth carry load.
  std::array<Eigen::MatrixXd, 2> least_root_stress;
  /// The position of the greatest root_stress.
  std::array<double, 2> least_at_max{LoadedPosition::kNone, LoadedPosition::kNone};
};

struct LoadedContact {
  LoadedContact() = default;  ///< empty, and not an aggregate; loaded_contact() makes it
  std::vector<LoadedTorque> torques;
  LoadRegime regime = LoadRegime::line;
  std::array<FaceSlices, 2> slices;    ///< mm, on each gear; the same on both for line contact
  std::array<double, 2> body_twist{};  ///< mm per N/mm at the base radius
  /// Positions of each gear along the fillet in tension, starting at the root: mm in the section,
  /// with the tooth's centre line as x axis and the loaded flank at y > 0.
  std::array<std::vector<std::complex<double>>, 2> root_points;
  long unfinished = 0;  ///< positions, of all torques
  bool slices_too_fine = false;
};

/// `perfect`: the same pair without mounting errors and deflections, to whose shares K_Hα refers;
/// null if `pair` has no errors and there are no deflections.
///
/// Domain    the pair of these gears; torques > 0 (contract)
LoadedContact loaded_contact(const ContactPair& pair, const Gear& gear_1, const Gear& gear_2,
                             const PairCompliance& compliance, const LoadRequest& request,
                             const ContactPair* perfect = nullptr);

/// The same computation in parts: ranges of positions, in any order and from several threads with
/// one object each, and then the result. The inputs must outlive the object.
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
  LoadRequest undeflected_;  // of the perfect pair
  template <class Solver>
  void solve_with(std::size_t from, std::size_t to);

  std::vector<Angle> rotations_;
  std::vector<std::vector<double>> perfect_share_;  // the greatest, [torque][position]
  LoadedContact found_;
  std::atomic<bool> too_fine_{false};
  std::mutex root_;  // guards the greatest root stress
};

}  // namespace gearwright
