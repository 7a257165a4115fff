#include "gearwright/contact/halves.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>
#include <utility>

#include "gearwright/base/numbers.hpp"
#include "gearwright/contact/continuous.hpp"
#include "gearwright/math/lowest.hpp"

namespace gearwright {

namespace {

Vec3 in_mirror(const Vec3& v) { return {v.x(), v.y(), -v.z()}; }

// Returns the factor, 1 or −1, by which an error of the pair changes in the mirror image.
double mirror_sign(ErrorKind kind) {
  const bool turns =
      kind == ErrorKind::crossing || kind == ErrorKind::intersecting || kind == ErrorKind::axial;
  return turns ? -1.0 : 1.0;
}

ContactPoint in_mirror(ContactPoint p, Angle behind, double ratio) {
  p.rotation1 = p.rotation1 - behind;
  p.rotation2 = p.rotation2 - ratio * behind;
  p.point = in_mirror(p.point);
  p.normal = in_mirror(p.normal);
  for (double& z : p.height) z = -z;
  if (p.ellipse) p.ellipse->angle = -p.ellipse->angle;
  if (p.ridge && p.ridge->by_height) std::swap(p.ridge->side[0], p.ridge->side[1]);
  if (p.line) p.line = std::array{in_mirror((*p.line)[1]), in_mirror((*p.line)[0])};
  return p;
}

std::vector<Angle> harmonics_of(const ContactResult& result, int per_pitch) {
  std::vector<double> te;
  for (int i = 0; i < per_pitch; ++i)
    te.push_back(result.positions[static_cast<std::size_t>(i)].te.rad());
  return harmonics(te);
}

// Converts `image`, the contact of the mirror image of half B, to the contact of half B itself. The
// rotations of `image` are those of rotations_of_second(). `per_pitch` is the number of positions
// in one pitch, or 0 if the caller gave the rotations.
ContactResult second_half(const HalvesMesh& mesh, const ContactResult& image,
                          const std::vector<Influence>& influences, int per_pitch) {
  ContactResult result = image;
  for (ContactPoint& p : result.positions) p = in_mirror(p, mesh.behind(), mesh.half[1]->ratio());
  for (std::size_t i = 0; i < result.sensitivities.size(); ++i) {
    const Influence& by = influences[i];
    const double sign = by.modified_gear == 0 ? mirror_sign(by.error) : 1.0;
    for (Sensitivity& s : result.sensitivities[i]) s = {sign * s.te, sign * in_mirror(s.point)};
  }
  if (per_pitch > 0 && !result.contact_lost) result.harmonics = harmonics_of(result, per_pitch);
  return result;
}

void add_whole(const HalvesMesh& mesh, int per_pitch, HalvesContact& found) {
  const auto& [a, b] = found.half;
  ContactResult& whole = found.whole;
  const double per_mm = mesh.half[0]->ratio() * mesh.gear_1->twist();
  std::vector<double> te;
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    const ContactPoint& p = a.positions[i];
    const ContactPoint& q = b.positions[i];
    ContactPoint both;
    both.rotation1 = p.rotation1;
    both.point = both.normal = Vec3::Constant(kNoNumber);
    both.diameter = both.height = {kNoNumber, kNoNumber};
    if (p.kind == TouchKind::none || q.kind == TouchKind::none) {
      whole.contact_lost = true;
      found.float_axial.push_back(kNoNumber);
    } else {
      both.te = (p.te + q.te) / 2;
      both.rotation2 = (p.rotation2 + q.rotation2) / 2;
      both.pair = p.pair;
      both.kind = is_edge(q.kind) && !is_edge(p.kind) ? q.kind : p.kind;
      found.float_axial.push_back((q.te - p.te).rad() / (2 * per_mm));
      te.push_back(both.te.rad());
    }
    whole.positions.push_back(both);
  }
  whole.unfinished = a.unfinished + b.unfinished;
  if (te.empty()) return;
  whole.peak_to_peak = Angle::radians(peak_to_peak(te));
  whole.mean_slope = (a.mean_slope + b.mean_slope) / 2;
  if (per_pitch > 0 && !whole.contact_lost) whole.harmonics = harmonics_of(whole, per_pitch);
}

// The mean of the TE of both halves, rad, or NaN if a half does not touch. The mean is also
// computed between positions. A half then has two candidates for its TE. One is the branch with the
// greatest T at the preceding position, and the other is the branch with the greatest T at the
// following position. Both branches are followed to the point between the positions, and the
// greater TE is used. If both positions have the same branch, it is followed from the nearer
// position only. On wavy flanks, no branch is followed, and all flanks are searched instead.
class MeanError {
 public:
  MeanError(const HalvesMesh& mesh, int positions)
      : n_(positions), step_(mesh.half[0]->pitch() / positions) {
    const double first = -0.5 * mesh.half[0]->pitch();
    for (const auto& [pair, start] :
         {std::pair(mesh.half[0], first), {mesh.half[1], first + mesh.behind().rad()}}) {
      Half& half = halves_.emplace_back(*pair, start);
      half.touches = one_pitch(half.transmission, start, positions);
    }
  }

  // The mean at the rotation that is `x` steps after the first position.
  double at(double x) { return (of(halves_[0], x) + of(halves_[1], x)) / 2; }

 private:
  struct Half {
    Half(const ContactPair& pair, double start) : transmission(pair), first(start) {}
    Transmission transmission;
    double first;  // rad
    std::vector<PairTouch> touches{};
  };

  double of(Half& half, double x) {
    const ContactPair& pair = half.transmission.pair();
    const auto touch = [&](double near) -> const PairTouch& {
      const auto i = (static_cast<long>(near) % n_ + n_) % n_;
      return half.touches[static_cast<std::size_t>(i)];
    };
    const double below = std::floor(x), above = std::ceil(x);
    const PairTouch &a = touch(below), &b = touch(above);
    if (below == above) return a.found() ? pair.turned() * a.te() : kNoNumber;
    const bool one_branch = a.found() && b.found() && a.fields == b.fields &&
                            std::abs(b.phi - a.phi - pair.to_world(step_)) < 0.5 * step_;
    PairTouch leads;
    for (const double near : {below, above}) {
      if (one_branch && near != std::round(x)) continue;
      const PairTouch& from = touch(near);
      if (!from.found() || half.transmission.wavy()) continue;
      const double phi = from.phi + pair.to_world((x - near) * step_);
      const PairTouch t = half.transmission.follow(from, phi);
      if (t.found() && !(leads.found() && leads.te() > t.te())) leads = t;
    }
    if (!leads.found()) leads = half.transmission.at(pair.to_world(half.first + x * step_));
    return leads.found() ? pair.turned() * leads.te() : kNoNumber;
  }

  long n_;
  double step_;  // rad
  std::deque<Half> halves_;
};

}  // namespace

FlankRaster in_mirror(const FlankRaster& raster) {
  FlankRaster r = raster;
  const std::size_t columns = r.height.size();
  for (std::size_t k = 0; k < columns; ++k) r.height[k] = -raster.height[columns - 1 - k];
  for (std::size_t i = 0; i < r.diameter.size(); ++i)
    std::reverse(r.gap.begin() + static_cast<std::ptrdiff_t>(i * columns),
                 r.gap.begin() + static_cast<std::ptrdiff_t>((i + 1) * columns));
  return r;
}

double middle_of_half(const Gear& half) {
  GW_EXPECTS(half.gap.has_value());
  return (*half.gap + half.spec.face_width) / 2;
}

Angle behind(double stagger, const Gear& gear_1) {
  return Angle::radians(-stagger * 2 * std::numbers::pi / gear_1.spec.teeth);
}

std::vector<Angle> rotations_of_second(const Gear& gear_1, double stagger,
                                       std::vector<Angle> rotations, int positions, int pitches) {
  if (stagger == 0.0) return rotations;
  if (rotations.empty()) {
    const double pitch = 2 * std::numbers::pi / gear_1.spec.teeth;
    for (int i = 0; i < pitches * positions; ++i)
      rotations.push_back(
          Angle::radians(pitch * (static_cast<double>(i) / positions - 0.5 * pitches)));
  }
  for (Angle& r : rotations) r += behind(stagger, gear_1);
  return rotations;
}

HalvesSetup::HalvesSetup(const ContactSetup& setup, double stagger, double side)
    : half_{setup, setup}, stagger_(stagger) {
  const std::array middles{side * middle_of_half(setup.gear(1)),
                           side * middle_of_half(setup.gear(2))};
  half_ = {setup.half_at(middles, false), setup.half_at(middles, true)};
}

HalvesPair HalvesSetup::pair(const ContactErrors& errors, bool gear2_drives) const {
  HalvesPair made{{half_[0].shared_pair(errors, gear2_drives),
                   half_[1].shared_pair(mirrored(errors), gear2_drives)},
                  {}};
  made.mesh = {&half_[0].gear(1), {made.half[0].get(), made.half[1].get()}, stagger_};
  return made;
}

ContactResult HalvesContact::on_halves() const {
  ContactResult both;
  for (const ContactResult* one : {&half[0], &image})
    both.positions.insert(both.positions.end(), one->positions.begin(), one->positions.end());
  return both;
}

HalvesContact analyse_contact(const HalvesMesh& mesh, const ContactRequest& request) {
  HalvesContact found;
  found.half[0] = analyse_contact(*mesh.half[0], request);
  ContactRequest at = request;
  at.rotations = rotations_of_second(*mesh.gear_1, mesh.stagger, request.rotations,
                                     request.positions, request.pitches);
  found.image = mesh.alike() ? found.half[0] : analyse_contact(*mesh.half[1], at);
  const int per_pitch = request.rotations.empty() ? request.positions : 0;
  found.half[1] = second_half(mesh, found.image, request.influences, per_pitch);
  add_whole(mesh, per_pitch, found);
  return found;
}

std::vector<double> transmission_error(const HalvesMesh& mesh, int positions) {
  std::vector<double> te = transmission_error(*mesh.half[0], positions);
  if (mesh.alike()) return te;
  std::vector<double> second;
  if (mesh.stagger == 0.0) {
    second = transmission_error(*mesh.half[1], positions);
  } else {
    const ContactRequest at{
        .positions = positions,
        .rotations = rotations_of_second(*mesh.gear_1, mesh.stagger, {}, positions, 1)};
    for (const ContactPoint& p : analyse_contact(*mesh.half[1], at).positions)
      second.push_back(p.kind == TouchKind::none ? kNoNumber : p.te.rad());
  }
  for (std::size_t i = 0; i < te.size(); ++i) te[i] = (te[i] + second[i]) / 2;
  return te;
}

std::optional<Angle> continuous_span(const HalvesMesh& mesh, int positions) {
  positions = std::max(kLeastSpanPositions, positions);
  if (mesh.alike()) return continuous_span(*mesh.half[0], positions);
  MeanError mean(mesh, positions);
  std::vector<double> te;
  for (int i = 0; i < positions; ++i) {
    te.push_back(mean.at(i));
    if (std::isnan(te.back())) return std::nullopt;
  }
  double extreme[2];
  for (const int which : {0, 1}) {
    const double sign = which == 0 ? -1.0 : 1.0;
    const auto value = [&](int i) { return sign * te[(i + positions) % positions]; };
    double best = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < positions; ++i) best = std::max(best, value(i));
    for (int i = 0; i < positions; ++i) {
      if (value(i) < value(i - 1) || value(i) < value(i + 1)) continue;
      // Between two positions, the curve may exceed the values at both positions. The difference is
      // at most the change of the curve in one step.
      const double reach = value(i) - std::min(value(i - 1), value(i + 1));
      if (value(i) + reach < best) continue;
      const auto lowered = [&](double x) { return -sign * mean.at(x); };
      best = std::max(best, -lowered(place_of_least(lowered, i - 1, i + 1)));
    }
    extreme[which] = sign * best;
  }
  return Angle::radians(extreme[1] - extreme[0]);
}

}  // namespace gearwright
