// Describes flank modifications, which remove material from a flank, by the numbers of a drawing
// and by a smooth field over the flank.
//
//   C      amount of one modification, mm         c(u, z)  material removed normal to the flank, mm
//   ρ, u   radius, mm, and ln ρ                   z, b     height from the middle of the face, mm;
//                                                          face width, mm
//   L      roll length √(ρ² − r0²), mm, which measures the position along the profile; L_f at d_Ff
//          and L_a at d_Fa
//   r0     base radius of an involute; 0 for other teeth, so that L is the radius
//   w      (L − (L_f + L_a)/2)/(L_a − L_f), from −½ at the root to ½ at the tip
//
// A modification removes its amount C times one of these fields (ISO 21771-1, "flank
// modifications"):
//
//   tip relief        q or q²,  q = (L − L_start)/(L_a − L_start), from d_start to the tip
//   root relief       q or q²,  q = (L − L_start)/(L_f − L_start), from d_start to the root
//   profile crowning  4 w²                          profile slope  w
//   helix crowning     4 (z/b)²                      helix slope modification     z/b
//   end relief        q or q²,  q = (|z| − b/2 + l)/l, over the length l from each face
//
// c is the sum of these products, of a measured or designed topography, and of the waves of form
// deviations. The waves are ½ f_f sin(2π n w + χ) along the profile and ½ f_f sin(2π n z/b + χ)
// along the face, with n whole waves. The formulas also hold for an internal gear, whose tip has
// the lesser radius.
//
// The right and the left flank are defined as seen from +z with the tooth pointing up. If the
// centre line of the tooth is the x axis, the right flank has y < 0.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/gear/topography.hpp"

namespace gearwright {

enum class ReliefShape { linear, parabolic };

struct Relief {
  double amount = 0.0;            ///< C  mm, ≥ 0
  std::optional<double> reach{};  ///< mm: start diameter (tip and root relief), or length from each
                                  ///< face (end relief)
  ReliefShape shape = ReliefShape::linear;
};

/// A form deviation over the usable flank or over the face.
struct FormWave {
  int waves = 0;        ///< n   0 without a wave
  double phase = 0.0;   ///< χ   rad
  double height = 0.0;  ///< f_f mm, from trough to crest

  bool operator==(const FormWave&) const = default;
};

/// The modifications of one flank. They are the same on every tooth.
struct FlankModifications {
  Relief tip_relief{};            ///< C_αa, at d_Fa
  Relief root_relief{};           ///< C_αf, at d_Ff
  double profile_crowning = 0.0;  ///< C_α   mm, at both ends of the usable flank; < 0 if hollow
  double profile_slope = 0.0;     ///< C_Hα  mm, from root to tip; > 0 removes material at the tip
  double lead_crowning = 0.0;     ///< C_β   mm, at both faces; < 0 if hollow
  double lead_slope = 0.0;        ///< C_Hβ  mm, over the face; > 0 removes material at the +z end
  Relief end_relief{};            ///< C_βI = C_βII
  std::shared_ptr<const Topography> topography{};
  FormWave profile_wave{}, helix_wave{};
};

/// The modifications of the right and the left flank of a gear.
using BothFlanks = std::array<FlankModifications, 2>;
inline BothFlanks on_both_flanks(const FlankModifications& flank) { return {flank, flank}; }

/// The modifications of gear 1 and of gear 2.
using PairModifications = std::array<BothFlanks, 2>;

/// The modifications that have an amount.
enum class Modification {
  tip_relief,
  root_relief,
  profile_crowning,
  profile_slope,
  lead_crowning,
  lead_slope,
  end_relief
};

/// A modification as a member of FlankModifications. It is either a relief or an amount alone.
struct ModificationMember {
  Modification kind;
  std::string_view name;               ///< name of the member, "tip_relief"
  Relief FlankModifications::*relief;  ///< `relief` or `alone` is set, and the other is null
  double FlankModifications::*alone;

  double& amount_of(FlankModifications& m) const { return relief ? (m.*relief).amount : m.*alone; }
  double amount_of(const FlankModifications& m) const {
    return relief ? (m.*relief).amount : m.*alone;
  }
  /// True if the range of the modification is known. The range of a relief is known if its reach is
  /// given. An amount alone always applies to the whole flank.
  bool placed(const FlankModifications& m) const { return !relief || (m.*relief).reach; }
};

inline constexpr std::array<ModificationMember, 7> kModifications{{
    {Modification::tip_relief, "tip_relief", &FlankModifications::tip_relief, nullptr},
    {Modification::root_relief, "root_relief", &FlankModifications::root_relief, nullptr},
    {Modification::profile_crowning, "profile_crowning", nullptr,
     &FlankModifications::profile_crowning},
    {Modification::profile_slope, "profile_slope", nullptr, &FlankModifications::profile_slope},
    {Modification::lead_crowning, "lead_crowning", nullptr, &FlankModifications::lead_crowning},
    {Modification::lead_slope, "lead_slope", nullptr, &FlankModifications::lead_slope},
    {Modification::end_relief, "end_relief", &FlankModifications::end_relief, nullptr},
}};
constexpr const ModificationMember& member_of(Modification m) {
  return kModifications[static_cast<std::size_t>(m)];
}

struct ModificationAmounts {
  std::array<double, kModifications.size()> mm{};

  double& operator[](Modification m) { return mm[static_cast<std::size_t>(m)]; }
  double operator[](Modification m) const { return mm[static_cast<std::size_t>(m)]; }
  bool operator==(const ModificationAmounts&) const = default;
};

struct FlankExtent {
  double r0;             ///< mm, base radius of an involute, 0 for other teeth
  double rho_root_form;  ///< d_Ff/2  mm
  double rho_tip_form;   ///< d_Fa/2  mm; less than rho_root_form on an internal gear
  double face_width;     ///< b  mm
};

/// Material removed at a point of the flank, and its derivatives with respect to u and z.
struct Removal {
  double c = 0.0;                             ///< mm
  double c_u = 0.0, c_z = 0.0;                ///< mm, 1
  double c_uu = 0.0, c_uz = 0.0, c_zz = 0.0;  ///< mm, 1, 1/mm
};

/// The field of one flank.
///
///   Laws  (1) at() = Σ amount · derivative() + topography + waves
///         (2) pieces() cover the usable flank without overlap; the formulas of a piece are smooth
///             and also apply beyond its borders, so that an iteration may leave the piece
///         (3) the derivatives returned are the exact derivatives of c at every point
class RemovalField {
 public:
  /// The reliefs that apply in a piece of the flank.
  struct Piece {
    bool tip = false, root = false;
    bool end_lo = false, end_hi = false;  ///< end relief at −b/2, at +b/2
    bool operator==(const Piece&) const = default;
  };
  struct Cell {
    double u_lo, u_hi;  ///< u_lo < u_hi
    double z_lo, z_hi;  ///< mm
    Piece piece;
  };

  /// Domain    arguments that make_removal_field() accepts (contract)
  RemovalField(const FlankModifications& modifications, const FlankExtent& extent);

  /// Returns the material removed at (u, z), by the formulas of `piece`.
  ///
  /// Units     u = ln(ρ/mm), z in mm
  /// Domain    any u, z. Every relief of `piece` must have a reach (contract). Inside the base
  ///           circle, √(ρ² − r0²) is not defined. L is therefore continued by another function,
  ///           with the same value and the same first two derivatives, below half the least L of
  ///           the usable flank. If the flank begins on the base circle, this limit is 1e-6 of the
  ///           greatest L
  Removal at(double u, double z, const Piece& piece) const;
  Removal at(double u, double z) const { return at(u, z, piece_at(u, z)); }

  /// Returns the derivative of at() with respect to the amount of a modification, in mm removed per
  /// mm of the amount. For a relief without a reach, the derivative is 0, because such a relief
  /// applies in no piece.
  Removal derivative(Modification of, double u, double z, const Piece& piece) const;

  double amount(Modification of) const { return amounts_[of]; }  ///< C  mm
  const ModificationAmounts& amounts() const { return amounts_; }

  /// Returns the piece that contains (u, z). For a point on a border, the result is the piece with
  /// the greater u or z. For a point outside the flank, it is the nearest piece.
  const Piece& piece_at(double u, double z) const;
  /// Pieces in order of u, and for equal u in order of z.
  const std::vector<Cell>& pieces() const { return cells_; }
  /// Borders between pieces, in ascending order. At a border the first derivative jumps, or the
  /// second derivative if the relief is parabolic. A relief with a reach has a border even if its
  /// amount is 0, because derivative() depends on the border.
  const std::vector<double>& kinks_u() const { return kinks_u_; }
  const std::vector<double>& kinks_z() const { return kinks_z_; }

  /// True if the border between two neighbouring pieces is a ridge. A ridge is the start of a
  /// linear relief with an amount other than 0, where the first derivative of c jumps.
  bool ridge_between(const Piece& a, const Piece& b) const;

  bool has_topography() const { return topography_ != nullptr; }
  /// Returns the waves along the profile and along the face.
  const std::array<FormWave, 2>& waves() const { return waves_; }
  bool wavy() const { return waves_[0].waves > 0 || waves_[1].waves > 0; }
  /// The removal of one wave at the position x, which is L or z, and its derivatives with respect
  /// to x.
  struct WaveJet {
    double c, d1, d2;  ///< mm, 1, 1/mm
  };
  WaveJet profile_wave(double L) const {
    return wave(waves_[0], L, roll_mid_, roll_tip_ - roll_root_);
  }
  WaveJet helix_wave(double z) const { return wave(waves_[1], z, 0.0, extent_.face_width); }
  double base_radius() const { return extent_.r0; }  ///< r0  mm
  /// Returns the same field without its waves.
  RemovalField smooth() const;
  /// True if nothing is removed, because there is no topography and no wave, and every amount is 0.
  bool none() const;

 private:
  struct Roll {
    double value, d1, d2;  // L and its derivatives with respect to u
  };
  struct Ramp {  // a relief as a function of L or |z|: 0 at `from`, and its amount at `to`
    double from = 0.0, to = 0.0;
    ReliefShape shape = ReliefShape::linear;
    bool placed = false;
  };
  static Ramp ramp(const Relief& relief, double from, double to);
  Roll roll(double rho) const;
  Removal unit(Modification of, const Roll& L, double z, const Piece& piece) const;
  static WaveJet wave(const FormWave& wave, double x, double middle, double width);
  void make_cells();

  FlankExtent extent_;
  ModificationAmounts amounts_;
  double y_floor_ = 0.0;  // mm²; below this L², L is continued by another function
  double roll_root_ = 0.0, roll_tip_ = 0.0, roll_mid_ = 0.0;
  Ramp tip_, root_, end_;
  std::shared_ptr<const TopographySpline> topography_;
  std::array<FormWave, 2> waves_{};
  std::vector<double> kinks_u_, kinks_z_;
  std::vector<Cell> cells_;
};

/// Makes the field, if the modifications fit the flank.
///
/// Errors    the member of FlankModifications that has a fault, such as `tip_relief.reach`. The
///           faults are: a relief that does not start on the usable flank; a relief without a
///           reach; a relief steeper than 1 in 5 (a chamfer); an amount greater than a tenth of the
///           flank's depth; a relief, a wave height or a number of waves that is negative; a grid
///           that does not cover the flank
/// Domain    0 ≤ r0 ≤ both form radii, which differ; face_width > 0; is_grid() of the topography
///           (contract)
Result<RemovalField> make_removal_field(const FlankModifications& modifications,
                                        const FlankExtent& extent);

}  // namespace gearwright
