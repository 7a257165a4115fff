#include "gearwright/gear/modifications.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/error.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {

namespace {

// Greatest amount, relative to the depth of the usable flank. The depth is about two modules, so
// the greatest amount is 0.2 modules, which is ten times the usual amounts. If this amount is
// removed from both flanks, most teeth still have half of their tip land.
constexpr double kMaxAmount = 0.1;
// Greatest slope of a relief over its depth or length. Because the material is removed along the
// normal of the unmodified flank, the amount has a relative error of half the square of the slope,
// which is 2 % here. A steeper relief is a chamfer, which is a separate surface.
constexpr double kSteepest = 0.2;
// Least depth of a profile relief, relative to the depth of the flank, and least length of an end
// relief, relative to the face width. A shorter relief would be an edge, so it is an error.
constexpr double kMinReach = 1e-3;
// Borders closer together than this fraction of the width of the flank are merged. This changes a
// linear relief by less than 1e-6 of its amount.
constexpr double kSameBorder = 1e-9;
// A grid must reach the form diameters within this relative tolerance, because diameters in a spec
// are rounded.
constexpr double kSameDiameter = 1e-9;
// Least L, relative to the greatest L, that is computed as √(ρ² − r0²). If the flank begins on the
// base circle, a smaller L is replaced by a smooth function. The error of this function is greatest
// on the base circle, where it is half the least L.
constexpr double kMinRoll = 1e-6;
// Relative rounding error of the form radius of a flank that begins on the base circle.
constexpr double kOnBase = 1e-12;
// Converts mm to µm. The result is rounded, so that a value of the spec is recovered exactly after
// it has been converted to mm.
double in_um(double mm) {
  constexpr double kSteps = 1e9;  // steps per µm, finer than any drawing and coarser than rounding
                                  // errors
  return std::round(mm / kMmPerUm * kSteps) / kSteps;
}

constexpr const char* kTenth =
    "must lie between {} µm and {} µm, because at most a tenth of the depth of the usable flank is "
    "allowed";

std::optional<Error> check_amount(std::string field, double amount, double greatest) {
  if (std::abs(amount) <= greatest) return std::nullopt;  // false for NaN
  return refused(
      std::move(field), in_um(amount), {-greatest / kMmPerUm, greatest / kMmPerUm},
      std::string(kTenth) + "; for a larger change give another rack or thickness allowance");
}

std::string amount_of(const std::string& relief) { return relief + ".amount"; }
std::string reach_of(const std::string& relief) { return relief + ".reach"; }

std::optional<Error> check_steepness(const std::string& name, const Relief& relief, double over) {
  const double greatest = kSteepest * over / (relief.shape == ReliefShape::parabolic ? 2 : 1);
  if (relief.amount <= greatest) return std::nullopt;
  return refused(
      amount_of(name), in_um(relief.amount), {greatest / kMmPerUm},
      fmt::format(
          "must be at most {{}} µm over a length of {} mm, which is a slope of 1 in 5; a longer "
          "relief (`{}`) may remove more; for a chamfer give `rack.semi_topping_angle`",
          format_number(over), reach_of(name)));
}

std::optional<Error> check_relief(const std::string& name, const Relief& relief) {
  if (!(relief.amount >= 0.0)) {
    return refused(amount_of(name), in_um(relief.amount),
                   "must not be negative, because a relief removes material; `profile_crowning` "
                   "and `lead_crowning` may be negative (hollow)");
  }
  if (relief.amount > 0.0 && !relief.reach)
    return absent_input(reach_of(name), fmt::format(", although `{}` is given", amount_of(name)));
  return std::nullopt;
}

std::optional<Error> check_profile_relief(const std::string& name, const Relief& relief,
                                          double rho_far, double rho_end) {
  if (auto error = check_relief(name, relief)) return error;
  if (!relief.reach) return std::nullopt;
  const double nearest = 2 * (rho_end - kMinReach * (rho_end - rho_far));
  const auto [lo, hi] = std::minmax({2 * rho_far, nearest});
  const double slack = kSameDiameter * rho_far;
  if (!(*relief.reach >= lo - slack && *relief.reach <= hi + slack)) {
    return refused(
        reach_of(name), *relief.reach, {lo, hi},
        fmt::format("must lie on the usable flank, between the diameters {{}} mm and {{}} "
                    "mm, and not at the relieved end of the flank, {} mm",
                    format_number(2 * rho_end, *relief.reach)));
  }
  return check_steepness(name, relief, std::abs(rho_end - *relief.reach / 2));
}

std::optional<Error> check_end_relief(const Relief& relief, double b) {
  const std::string name = "end_relief";
  if (auto error = check_relief(name, relief)) return error;
  if (!relief.reach) return std::nullopt;
  const double l = *relief.reach;
  if (!(l >= kMinReach * b && l <= b / 2)) {
    return refused(reach_of(name), l, {kMinReach * b, b / 2},
                   "must lie between {} mm and half the face width, {} mm; for the whole face give "
                   "`lead_crowning`");
  }
  return check_steepness(name, relief, l);
}

std::optional<Error> check_topography(const FlankModifications& m, const FlankExtent& e,
                                      double greatest) {
  if (!m.topography) return std::nullopt;
  const Topography& t = *m.topography;
  const auto [inner, outer] = std::minmax({2 * e.rho_root_form, 2 * e.rho_tip_form});
  const double slack = kSameDiameter * outer;
  // The value of the key is the name of a file, so the number is part of the rule.
  const auto refusal = [&](const char* what, double value, double lo, double hi) {
    return Error{
        "topography", "",
        fmt::format(
            "the {} of the grid is {} mm, but the grid must cover the usable flank "
            "from {} mm to {} mm",
            what,
            with_digits(value, std::max(digits_between(value, lo), digits_between(value, hi))),
            format_number(lo, value), format_number(hi, value))};
  };
  const double first = t.diameters.front(), last = t.diameters.back();
  if (!(first <= inner + slack)) return refusal("least diameter", first, inner, outer);
  if (!(last >= outer - slack)) return refusal("greatest diameter", last, inner, outer);
  const double half = e.face_width / 2;
  const double bottom = t.heights.front(), top = t.heights.back();
  if (!(bottom <= -half * (1 - kSameDiameter))) return refusal("least z", bottom, -half, half);
  if (!(top >= half * (1 - kSameDiameter))) return refusal("greatest z", top, -half, half);
  for (const double c : t.removed) {
    if (std::abs(c) <= greatest) continue;
    Error error =
        refused("topography", in_um(c), {-greatest / kMmPerUm, greatest / kMmPerUm}, kTenth);
    error.rule = fmt::format("the grid removes {} µm, which {}", error.value, error.rule);
    error.value.clear();
    return error;
  }
  return std::nullopt;
}

std::optional<Error> check_wave(const std::string& name, const FormWave& wave) {
  if (wave.waves < 0) return refused(name + ".waves", wave.waves, "must not be negative");
  if (wave.height >= 0.0) return std::nullopt;
  return refused(name + ".height", in_um(wave.height),
                 "must not be negative, because this value is the distance in µm from trough to "
                 "crest; to move the crests, give another phase");
}

std::optional<Error> check(const FlankModifications& m, const FlankExtent& e) {
  const double depth = std::abs(e.rho_tip_form - e.rho_root_form);
  if (auto error =
          check_profile_relief("tip_relief", m.tip_relief, e.rho_root_form, e.rho_tip_form))
    return error;
  if (auto error =
          check_profile_relief("root_relief", m.root_relief, e.rho_tip_form, e.rho_root_form))
    return error;
  if (auto error = check_end_relief(m.end_relief, e.face_width)) return error;
  if (auto error = check_wave("profile_wave", m.profile_wave)) return error;
  if (auto error = check_wave("helix_wave", m.helix_wave)) return error;
  const double greatest = kMaxAmount * depth;
  for (const ModificationMember& one : kModifications) {
    const std::string name(one.name);
    if (auto error = check_amount(one.relief ? amount_of(name) : name, one.amount_of(m), greatest))
      return error;
  }
  if (auto error = check_amount("profile_wave.height", m.profile_wave.height / 2, greatest))
    return error;
  if (auto error = check_amount("helix_wave.height", m.helix_wave.height / 2, greatest))
    return error;
  return check_topography(m, e, greatest);
}

struct Jet {
  double f, d1, d2;
};

Removal along_profile(const Jet& f, double L_u, double L_uu) {
  return {f.f, f.d1 * L_u, 0.0, f.d2 * L_u * L_u + f.d1 * L_uu, 0.0, 0.0};
}

Removal along_face(const Jet& f) { return {f.f, 0.0, f.d1, 0.0, 0.0, f.d2}; }

Jet ramp_at(ReliefShape shape, double from, double to, double x) {
  const double q1 = 1 / (to - from);
  const double q = (x - from) * q1;
  if (shape == ReliefShape::linear) return {q, q1, 0.0};
  return {q * q, 2 * q * q1, 2 * q1 * q1};
}

void add(Removal& sum, double amount, const Removal& unit) {
  sum.c += amount * unit.c;
  sum.c_u += amount * unit.c_u;
  sum.c_z += amount * unit.c_z;
  sum.c_uu += amount * unit.c_uu;
  sum.c_uz += amount * unit.c_uz;
  sum.c_zz += amount * unit.c_zz;
}

// Returns the candidates inside (lo, hi), in ascending order. Candidates that are too close to the
// preceding border or to an end are left out.
std::vector<double> borders(std::vector<double> candidates, double lo, double hi) {
  const double same = kSameBorder * (hi - lo);
  std::sort(candidates.begin(), candidates.end());
  std::vector<double> kept;
  for (const double x : candidates) {
    const double last = kept.empty() ? lo : kept.back();
    if (x - last > same && hi - x > same) kept.push_back(x);
  }
  return kept;
}

std::vector<double> with_ends(double lo, const std::vector<double>& inner, double hi) {
  std::vector<double> all{lo};
  all.insert(all.end(), inner.begin(), inner.end());
  all.push_back(hi);
  return all;
}

}  // namespace

RemovalField::Ramp RemovalField::ramp(const Relief& relief, double from, double to) {
  return {from, to, relief.shape, relief.reach.has_value()};
}

RemovalField::RemovalField(const FlankModifications& m, const FlankExtent& e)
    : extent_(e),
      roll_root_(roll_length(e.rho_root_form, e.r0)),
      roll_tip_(roll_length(e.rho_tip_form, e.r0)),
      roll_mid_((roll_tip_ + roll_root_) / 2),
      waves_{m.profile_wave, m.helix_wave} {
  GW_EXPECTS(!check(m, e));
  for (const ModificationMember& one : kModifications) amounts_[one.kind] = one.amount_of(m);
  const auto [least, greatest] = std::minmax({roll_root_, roll_tip_});
  const double floor = std::max(least / 2, kMinRoll * greatest);
  y_floor_ = floor * floor;
  tip_ = ramp(m.tip_relief, roll_length(m.tip_relief.reach.value_or(0.0) / 2, e.r0), roll_tip_);
  root_ = ramp(m.root_relief, roll_length(m.root_relief.reach.value_or(0.0) / 2, e.r0), roll_root_);
  const double half = e.face_width / 2;
  end_ = ramp(m.end_relief, half - m.end_relief.reach.value_or(0.0), half);
  if (m.topography) topography_ = std::make_shared<TopographySpline>(*m.topography);
  const auto [inner, outer] = std::minmax({e.rho_root_form, e.rho_tip_form});
  std::vector<double> u;
  for (const Relief* relief : {&m.tip_relief, &m.root_relief}) {
    if (relief->reach) u.push_back(std::log(*relief->reach / 2));
  }
  kinks_u_ = borders(std::move(u), std::log(inner), std::log(outer));
  if (end_.placed) kinks_z_ = borders({-end_.from, end_.from}, -half, half);
  make_cells();
}

void RemovalField::make_cells() {
  const auto [inner, outer] = std::minmax({extent_.rho_root_form, extent_.rho_tip_form});
  const double half = extent_.face_width / 2;
  const std::vector<double> u = with_ends(std::log(inner), kinks_u_, std::log(outer));
  const std::vector<double> z = with_ends(-half, kinks_z_, half);
  for (std::size_t i = 0; i + 1 < u.size(); ++i) {
    // The middle of a cell determines which reliefs apply in the cell.
    const double L = roll_length(std::exp((u[i] + u[i + 1]) / 2), extent_.r0);
    const auto beyond = [](const Ramp& r, double x) {
      return r.placed && (x - r.from) / (r.to - r.from) > 0.0;
    };
    for (std::size_t j = 0; j + 1 < z.size(); ++j) {
      const double middle = (z[j] + z[j + 1]) / 2;
      cells_.push_back(
          {u[i],
           u[i + 1],
           z[j],
           z[j + 1],
           {beyond(tip_, L), beyond(root_, L), beyond(end_, -middle), beyond(end_, middle)}});
    }
  }
}

bool RemovalField::ridge_between(const Piece& a, const Piece& b) const {
  const auto begins = [&](bool differs, const Ramp& r, Modification p) {
    return differs && r.placed && r.shape == ReliefShape::linear && amount(p) != 0.0;
  };
  return begins(a.tip != b.tip, tip_, Modification::tip_relief) ||
         begins(a.root != b.root, root_, Modification::root_relief) ||
         begins(a.end_lo != b.end_lo || a.end_hi != b.end_hi, end_, Modification::end_relief);
}

// Returns L as a function of y = ρ² − r0². If y ≥ y0 = y_floor_, L = √y. If y < y0, L = √y0 (1 − h)
// with t = (y0 − y)/y0 and h = t (1 + 7t/4)/(2 (1 + t)^(3/2)). At t = 0, h has the value, slope and
// second derivative of 1 − √(1 − t). For t ≥ 0, h increases everywhere, and for large t it grows
// like √t.
RemovalField::Roll RemovalField::roll(double rho) const {
  const double y = (rho - extent_.r0) * (rho + extent_.r0);
  const double y_u = 2 * rho * rho;
  const double y_uu = 2 * y_u;
  double L = 0.0, by_y = 0.0, by_yy = 0.0;
  if (y >= y_floor_) {
    L = std::sqrt(y);
    by_y = 1 / (2 * L);
    by_yy = -by_y / (2 * y);
  } else {
    const double root = std::sqrt(y_floor_);
    const double t = (y_floor_ - y) / y_floor_;
    const double n = 1 + t;
    const double p = t * (1 + 1.75 * t);  // h = p/(2 n^1.5)
    const double p1 = 1 + 3.5 * t;
    const double scale = 0.5 / (n * std::sqrt(n));
    L = root * (1 - scale * p);
    by_y = scale * (p1 - 1.5 * p / n) / root;
    by_yy = -scale * (3.5 - 3 * p1 / n + 3.75 * p / (n * n)) / (root * y_floor_);
  }
  return {L, by_y * y_u, by_yy * y_u * y_u + by_y * y_uu};
}

Removal RemovalField::unit(Modification of, const Roll& L, double z, const Piece& piece) const {
  const auto relief = [&](const Ramp& r) {
    return along_profile(ramp_at(r.shape, r.from, r.to, L.value), L.d1, L.d2);
  };
  const double w1 = 1 / (roll_tip_ - roll_root_);
  const double w = (L.value - roll_mid_) * w1;
  const double b = extent_.face_width;
  switch (of) {
    case Modification::tip_relief:
      GW_EXPECTS(!piece.tip || tip_.placed);
      return piece.tip ? relief(tip_) : Removal{};
    case Modification::root_relief:
      GW_EXPECTS(!piece.root || root_.placed);
      return piece.root ? relief(root_) : Removal{};
    case Modification::profile_crowning:
      return along_profile({4 * w * w, 8 * w * w1, 8 * w1 * w1}, L.d1, L.d2);
    case Modification::profile_slope: return along_profile({w, w1, 0.0}, L.d1, L.d2);
    case Modification::lead_crowning:
      return along_face({4 * z * z / (b * b), 8 * z / (b * b), 8 / (b * b)});
    case Modification::lead_slope: return along_face({z / b, 1 / b, 0.0});
    case Modification::end_relief: {
      GW_EXPECTS(!(piece.end_lo || piece.end_hi) || end_.placed);
      Removal sum;
      if (piece.end_hi) add(sum, 1.0, along_face(ramp_at(end_.shape, end_.from, end_.to, z)));
      if (piece.end_lo) add(sum, 1.0, along_face(ramp_at(end_.shape, -end_.from, -end_.to, z)));
      return sum;
    }
  }
  GW_EXPECTS(false);
  return {};
}

Removal RemovalField::at(double u, double z, const Piece& piece) const {
  const double rho = std::exp(u);
  const Roll L = roll(rho);
  Removal sum;
  for (const auto& [kind, name, relief, alone] : kModifications)
    if (amount(kind) != 0.0) add(sum, amount(kind), unit(kind, L, z, piece));
  if (topography_) {
    const double d = 2 * rho;  // ∂d/∂u = ∂²d/∂u² = d
    const auto s = topography_->at(d, z);
    add(sum, 1.0, {s.s, d * s.d, s.z, d * (d * s.dd + s.d), d * s.dz, s.zz});
  }
  if (waves_[0].waves > 0) {
    const WaveJet w = profile_wave(L.value);
    add(sum, 1.0, along_profile({w.c, w.d1, w.d2}, L.d1, L.d2));
  }
  if (waves_[1].waves > 0) {
    const WaveJet w = helix_wave(z);
    add(sum, 1.0, along_face({w.c, w.d1, w.d2}));
  }
  return sum;
}

// Returns the removal of a wave at x, measured along the profile or the face, and its derivatives.
// [T14.21]
RemovalField::WaveJet RemovalField::wave(const FormWave& wave, double x, double middle,
                                         double width) {
  const double rate = 2 * std::numbers::pi * wave.waves / width;
  const double turn = rate * (x - middle) + wave.phase;
  const double sine = 0.5 * wave.height * std::sin(turn);
  return {sine, 0.5 * wave.height * rate * std::cos(turn), -rate * rate * sine};
}

RemovalField RemovalField::smooth() const {
  RemovalField field = *this;
  field.waves_ = {};
  return field;
}

Removal RemovalField::derivative(Modification of, double u, double z, const Piece& piece) const {
  return unit(of, roll(std::exp(u)), z, piece);
}

const RemovalField::Piece& RemovalField::piece_at(double u, double z) const {
  const auto i = std::upper_bound(kinks_u_.begin(), kinks_u_.end(), u) - kinks_u_.begin();
  const auto j = std::upper_bound(kinks_z_.begin(), kinks_z_.end(), z) - kinks_z_.begin();
  return cells_[static_cast<std::size_t>(i) * (kinks_z_.size() + 1) + static_cast<std::size_t>(j)]
      .piece;
}

bool RemovalField::none() const {
  return !topography_ && !wavy() && amounts_ == ModificationAmounts{};
}

Result<RemovalField> make_removal_field(const FlankModifications& modifications,
                                        const FlankExtent& e) {
  GW_EXPECTS(e.r0 >= 0.0 && e.face_width > 0.0);
  GW_EXPECTS(std::min(e.rho_root_form, e.rho_tip_form) >= e.r0 * (1 - kOnBase));
  GW_EXPECTS(std::min(e.rho_root_form, e.rho_tip_form) > 0.0);
  GW_EXPECTS(e.rho_root_form != e.rho_tip_form);
  GW_EXPECTS(!modifications.topography || is_grid(*modifications.topography));
  if (auto error = check(modifications, e)) return *error;
  return RemovalField(modifications, e);
}

}  // namespace gearwright
