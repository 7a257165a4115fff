#include "gearwright/cad/modified_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/curve/arc_length.hpp"

namespace gearwright {

namespace {

// Target deviations of the splines along u and along v, mm. Their sum is the target of a face.
constexpr double kTargetU_mm = kSectionTarget_mm / 2, kTargetV_mm = kSectionTarget_mm / 2;
constexpr int kLineChecks = 12, kFaceChecks = 8;  // checked points between neighbouring knots
constexpr int kRowsU = 7;  // number of rows of a layer at which the basis along u is examined
// Least distance between a plane of a slice and the line at which an end relief begins, relative to
// the height of a slice. The removed material c moves this line out of its own plane z = const by c
// sin β_b, about a hundredth of a module. Without this distance, the moved line could cross the
// plane of the slice.
constexpr double kNearPlane = 0.02;
constexpr int kMoreSlices = 5;

using Point = std::function<Vec3(double)>;

// Returns, for each span, the greatest distance between an exact line and the spline through points
// of this line.
std::vector<double> errors(const BSplineBasis& basis, const Point& exact) {
  Eigen::MatrixXd samples(basis.poles(), 3);
  for (int i = 0; i < basis.poles(); ++i)
    samples.row(i) = exact(basis.greville()[static_cast<std::size_t>(i)]).transpose();
  const Eigen::MatrixXd poles = basis.interpolate(samples);
  return worst_by_span(basis, kLineChecks, [&](double at) {
    return (Vec3(basis.evaluate(poles, at)) - exact(at)).norm();
  });
}

// Fits one side of the teeth. Along an arc, u is the parameter of the spline that represents the
// arc as cut. It is the curve's own parameter or the relative arc length.
class SideFitter {
 public:
  explicit SideFitter(const ModifiedSide& side) : side_(side) {
    for (std::size_t arc = 0; arc < side.outline().arcs.size(); ++arc) {
      lengths_.emplace_back();
      bases_.emplace_back(1, 2);
      if (side.role(arc) == ModifiedSide::Role::land) continue;
      faces_.push_back(arc);
      const Arc& a = side.outline().arcs[arc];
      SectionSpline cut = fit_section(a, kTargetU_mm);
      if (cut.by_length) lengths_.back().emplace(*a.curve, a.begin, a.end);
      bases_.back() = std::move(cut.basis);
    }
  }

  const std::vector<BSplineBasis>& bases() const { return bases_; }  // by arc
  const BSplineBasis& basis(std::size_t arc) const { return bases_[arc]; }
  const std::vector<std::size_t>& faces() const { return faces_; }  // the arcs that are not lands
  bool is_land(std::size_t arc) const { return side_.role(arc) == ModifiedSide::Role::land; }
  const ModifiedSide& side() const { return side_; }

  Vec3 point(std::size_t arc, double x, const ModifiedSide::Row& row) const {
    double u = x;
    if (lengths_[arc] && x > 0.0 && x < 1.0) {
      const Arc& a = side_.outline().arcs[arc];
      u = (lengths_[arc]->parameter(x * lengths_[arc]->length()) - a.begin) / (a.end - a.begin);
    }
    return side_.point(arc, u, row);
  }

  // Halves each span along u in which the spline misses the target on the given row.
  void refine(std::size_t arc, const ModifiedSide::Row& row) {
    const Point exact = [&](double x) { return point(arc, x, row); };
    while (true) {
      auto finer = refined(bases_[arc], errors(bases_[arc], exact), kTargetU_mm);
      if (!finer || finer->poles() > kMaxPoles) return;
      bases_[arc] = *std::move(finer);
    }
  }

 private:
  const ModifiedSide& side_;
  std::vector<std::optional<ArcLength>> lengths_;
  std::vector<BSplineBasis> bases_;
  std::vector<std::size_t> faces_{};
};

struct Layer {
  ToothLevel low, high;
};

// True if the basis along v meets the targets on all edges, and on lines between the edges.
bool serves(const BSplineBasis& basis, const SideFitter& fitter, const Layer& layer) {
  std::vector<std::pair<double, ModifiedSide::Row>> rows;
  const auto row_at = [&](double v) -> const ModifiedSide::Row& {
    const auto same = [&](const auto& known) { return known.first == v; };
    auto found = std::find_if(rows.begin(), rows.end(), same);
    if (found == rows.end())
      found = rows.insert(rows.end(), {v, fitter.side().row(layer.low, layer.high, v)});
    return found->second;
  };
  for (const std::size_t arc : fitter.faces()) {
    for (const double x : {0.0, 0.3, 0.7, 1.0}) {
      const bool on_root_land = x == 0.0 && arc > 0 && fitter.is_land(arc - 1);
      const bool on_tip_land =
          x == 1.0 && arc + 1 < fitter.bases().size() && fitter.is_land(arc + 1);
      const double target = on_root_land || on_tip_land ? kHelixTarget_mm : kTargetV_mm;
      const std::vector<double> worst =
          errors(basis, [&](double v) { return fitter.point(arc, x, row_at(v)); });
      if (*std::max_element(worst.begin(), worst.end()) > target) return false;
    }
  }
  return true;
}

// Tries bases with an increasing number of poles and returns the first one that meets the targets
// on both sides. If there is no such basis, the result has kMaxPoles poles.
BSplineBasis basis_along(const std::array<SideFitter, 2>& fitters, const Layer& layer) {
  const auto both = [&](const BSplineBasis& basis) {
    return serves(basis, fitters[0], layer) && serves(basis, fitters[1], layer);
  };
  if (BSplineBasis line(1, 2); both(line)) return line;
  for (int poles = 6; poles < kMaxPoles; poles += 1 + poles / 8)
    if (BSplineBasis basis(5, poles); both(basis)) return basis;
  return {5, kMaxPoles};
}

// Computes the poles of a face. `begin` contains the samples of the previous face on the common
// edge at the start of the arc. `below` contains the samples of the face below on the common edge
// at the lower level. These samples replace the samples of this face, so that common edges are
// exactly equal. `end` and `above` receive the samples on the other two edges, for the next faces.
ModifiedFace fit_face(const SideFitter& fitter, std::size_t arc,
                      const std::vector<ModifiedSide::Row>& rows, const BSplineBasis& along_v,
                      const std::vector<Vec3>* begin, const std::vector<Vec3>* below,
                      std::vector<Vec3>& end, std::vector<Vec3>& above) {
  const BSplineBasis& along_u = fitter.basis(arc);
  const int nu = along_u.poles(), nv = along_v.poles();
  Eigen::MatrixXd samples(nu, 3 * nv);
  end.clear();
  above.clear();
  for (int i = 0; i < nu; ++i) {
    for (int j = 0; j < nv; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      Vec3 p = fitter.point(arc, along_u.greville()[a], rows[b]);
      if (j == 0 && below) p = (*below)[a];
      if (i == 0 && begin) p = (*begin)[b];
      samples.block<1, 3>(i, 3 * j) = p.transpose();
      if (i + 1 == nu) end.push_back(p);
      if (j + 1 == nv) above.push_back(p);
    }
  }
  const Eigen::MatrixXd half = along_u.interpolate(samples);
  ModifiedFace face;
  for (int i = 0; i < nu; ++i) {
    Eigen::MatrixXd row(nv, 3);
    for (int j = 0; j < nv; ++j) row.row(j) = half.block<1, 3>(i, 3 * j);
    const Eigen::MatrixXd poles = along_v.interpolate(row);
    face.poles.emplace_back();
    for (int j = 0; j < nv; ++j) face.poles.back().emplace_back(poles.row(j).transpose());
  }
  return face;
}

double deviation(const ModifiedFace& face, const SideFitter& fitter, std::size_t arc,
                 const Layer& layer, const BSplineBasis& along_v) {
  const BSplineBasis& along_u = fitter.basis(arc);
  double worst = 0.0;
  for (const double v : places_between_knots(along_v, kFaceChecks)) {
    const ModifiedSide::Row row = fitter.side().row(layer.low, layer.high, v);
    const BSplineBasis::Local local = along_v.local(v);
    Eigen::MatrixXd line(along_u.poles(), 3);
    for (int i = 0; i < along_u.poles(); ++i) {
      Vec3 sum = Vec3::Zero();
      for (std::size_t j = 0; j < local.values.size(); ++j)
        sum += local.values[j] *
               face.poles[static_cast<std::size_t>(i)][static_cast<std::size_t>(local.first) + j];
      line.row(i) = sum.transpose();
    }
    for (const double x : places_between_knots(along_u, kFaceChecks)) {
      const Vec3 error = along_u.evaluate(line, x) - fitter.point(arc, x, row);
      worst = std::max(worst, error.norm());
    }
  }
  return worst;
}

}  // namespace

std::vector<ToothLevel> tooth_levels(const ModifiedTeeth& teeth, int slices, double face_width) {
  const std::vector<double> kinks = teeth.kinks_z();
  const auto cut_by = [&](int n) {
    std::vector<ToothLevel> planes;
    for (int i = 0; i <= n; ++i) planes.push_back({face_width * (2 * i - n) / (2.0 * n)});
    return planes;
  };
  const auto near = [&](const std::vector<ToothLevel>& planes) {
    const double least = kNearPlane * (planes[1].z - planes[0].z);
    for (const double kink : kinks)
      for (const ToothLevel& plane : planes)
        if (std::abs(plane.z - kink) < least) return true;
    return false;
  };
  std::vector<ToothLevel> levels = cut_by(slices);
  for (int n = slices; n > 1 && n < slices + kMoreSlices; ++n) {
    if (auto planes = cut_by(n); !near(planes)) {
      levels = std::move(planes);
      break;
    }
  }
  for (const double z : kinks) levels.push_back({z, true});
  std::sort(levels.begin(), levels.end(),
            [](const ToothLevel& a, const ToothLevel& b) { return a.z < b.z; });
  return levels;
}

Result<ModifiedFit> fit_modified(const ModifiedTeeth& teeth, std::vector<ToothLevel> levels) {
  GW_EXPECTS(levels.size() >= 2);
  std::array<SideFitter, 2> fitters{SideFitter(teeth.side(false)), SideFitter(teeth.side(true))};
  ModifiedFit fit;
  fit.levels = std::move(levels);
  for (SideFitter& fitter : fitters)
    for (const std::size_t arc : fitter.faces())
      for (std::size_t l = 0; l + 1 < fit.levels.size(); ++l)
        for (int i = 0; i < kRowsU; ++i)
          fitter.refine(arc, fitter.side().row(fit.levels[l], fit.levels[l + 1],
                                               static_cast<double>(i) / (kRowsU - 1)));
  for (const std::size_t side : {0U, 1U})
    for (const BSplineBasis& basis : fitters[side].bases())
      fit.along_u[side].push_back(knots_of(basis));

  // Samples on the upper edges of the faces in the layer below, by arc.
  std::array<std::vector<std::vector<Vec3>>, 2> above;
  for (std::size_t l = 0; l + 1 < fit.levels.size(); ++l) {
    const Layer layer{fit.levels[l], fit.levels[l + 1]};
    const BSplineBasis along_v = basis_along(fitters, layer);
    fit.along_v.push_back(knots_of(along_v));
    for (double& knot : fit.along_v.back().distinct)
      knot = knot == 1.0 ? layer.high.z : layer.low.z + (layer.high.z - layer.low.z) * knot;
    for (const std::size_t side : {0U, 1U}) {
      const SideFitter& fitter = fitters[side];
      std::vector<ModifiedSide::Row> rows;
      for (const double v : along_v.greville())
        rows.push_back(fitter.side().row(layer.low, layer.high, v));
      std::vector<ModifiedFace> faces(fitter.bases().size());
      std::vector<std::vector<Vec3>> upper(fitter.bases().size());
      std::vector<Vec3> end;
      for (const std::size_t arc : fitter.faces()) {
        const std::vector<Vec3> begin = std::move(end);
        const bool joined = arc > 0 && !fitter.is_land(arc - 1);
        faces[arc] = fit_face(fitter, arc, rows, along_v, joined ? &begin : nullptr,
                              l > 0 ? &above[side][arc] : nullptr, end, upper[arc]);
        const double off = deviation(faces[arc], fitter, arc, layer, along_v);
        faces[arc].deviation_mm = off;
        if (!(off <= kSectionMax_mm))
          return no_spline(fmt::format("modified {}", to_string(teeth.outline().arcs[arc].name)),
                           off);
      }
      fit.faces[side].push_back(std::move(faces));
      above[side] = std::move(upper);
    }
  }
  return fit;
}

ModifiedFit in_mirror(ModifiedFit fit) {
  std::reverse(fit.levels.begin(), fit.levels.end());
  for (ToothLevel& level : fit.levels) level.z = -level.z;
  std::reverse(fit.along_v.begin(), fit.along_v.end());
  for (WallKnots& knots : fit.along_v) {
    std::reverse(knots.distinct.begin(), knots.distinct.end());
    for (double& knot : knots.distinct) knot = -knot;
    std::reverse(knots.multiplicity.begin(), knots.multiplicity.end());
  }
  for (auto& layers : fit.faces) {
    std::reverse(layers.begin(), layers.end());
    for (auto& faces : layers)
      for (ModifiedFace& face : faces)
        for (std::vector<Vec3>& row : face.poles) {
          std::reverse(row.begin(), row.end());
          for (Vec3& pole : row) pole.z() = -pole.z();
        }
  }
  return fit;
}

}  // namespace gearwright
