#include "gearwright/load/loaded_position.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gearwright::detail {

namespace {

// Reverses the order of the slices. This is necessary if gear 2 drives, because the z axis of frame
// N is then opposite to the z axis of the housing frame.
void reverse(LoadedPair& pair) {
  pair.line_load.reverseInPlace();
  pair.pressure.reverseInPlace();
  pair.half_width.reverseInPlace();
  std::reverse(pair.radius.begin(), pair.radius.end());
}

bool deflects(const LoadRequest& r) { return r.deflection_slope != 0.0 || r.deflection_bow != 0.0; }

// Returns the heights of the middles of the slices, mm. If `borders` is true, the heights of the
// borders between the slices and of both ends are appended. With deflections, the first contact is
// searched for only at the returned heights.
std::vector<double> heights_of(const FaceSlices& s, bool borders) {
  std::vector<double> heights;
  for (int j = 0; j < s.count; ++j) heights.push_back(s.middle(j));
  if (!borders) return heights;
  for (int j = 0; j <= s.count; ++j) heights.push_back(s.lo + j * s.width());
  return heights;
}

}  // namespace

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

PositionSolver::PositionSolver(const ContactPair& pair, const Gear& one, const Gear& two,
                               const PairCompliance& c, const LoadRequest& request)
    : pair_(pair),
      compliance_(c),
      request_(request),
      shafts_(pair, one, two, c, request),
      search_(pair, heights_of(c.slices[0], deflects(request))),
      transmission_(pair) {
  module_ = {one.spec.normal_module, two.spec.normal_module};
  base_radius_ = two.base_radius();
  sin_b_ = std::sin(one.spec.helix_angle.rad()) * std::cos(one.spec.normal_pressure_angle.rad());
  ratio_ = std::abs(double(two.spec.teeth) / one.spec.teeth);
}

Position PositionSolver::prepare(double rotation, Slices slices) {
  Position at;
  const int n = compliance_.slices[0].count;
  auto all = search_.places(rotation);
  double te = -std::numeric_limits<double>::infinity();
  for (const PairPlaces& p : all)
    for (std::size_t i = 0; i < search_.heights().size(); ++i)
      if (p.at[i]) te = std::max(te, p.at[i]->te + deflection(search_.heights()[i]) / p.at[i]->arm);
  if (!deflects(request_))
    if (const PairTouch t = transmission_.at(rotation); t.found()) te = std::max(te, t.te());
  at.te = te;
  std::vector<double> gap;
  std::vector<double> arm;
  std::vector<double> radius;
  std::sort(all.begin(), all.end(),
            [](const PairPlaces& a, const PairPlaces& b) { return a.turn < b.turn; });
  for (PairPlaces& p : all) {
    double least = std::numeric_limits<double>::infinity();
    const auto gap_at = [&](int j) {
      return (te - p.at[j]->te) * p.at[j]->arm - deflection(search_.heights()[j]);
    };
    for (int j = 0; j < n; ++j)
      if (p.at[j]) least = std::min(least, gap_at(j));
    if (!(least < kFarGap * module_[0])) continue;
    const int index = static_cast<int>(at.pairs.size());
    std::array<LinePlaces, 2> line;
    for (int g = 0; g < 2; ++g) line[g].assign(n, compliance_.table[g]->section().s.front());
    for (int j = 0; j < n; ++j) {
      if (!p.at[j]) continue;
      const GapPlace& place = *p.at[j];
      for (int g = 0; g < 2; ++g)
        line[g][j] = compliance_.table[g]->section().length_at_radius(place.radius[g] / module_[g]);
      if (slices == Slices::that_may_touch && gap_at(j) > kFarGap * module_[0]) continue;
      at.rows.push_back({index, j});
      gap.push_back(gap_at(j));
      arm.push_back(place.arm);
      radius.push_back(1.0 / std::max(place.curvature, kFlattest));
    }
    for (int g = 0; g < 2; ++g) at.lines[g].push_back(line[g]);
    at.pairs.push_back(std::move(p));
  }
  ContactProblem& q = at.problem;
  const auto vector = [](const std::vector<double>& v) {
    return VectorXd(Eigen::Map<const VectorXd>(v.data(), static_cast<Index>(v.size())));
  };
  q.gap = vector(gap);
  q.arm = vector(arm);
  q.radius = vector(radius);
  q.length = compliance_.slices[0].width() / std::sqrt(1 - sin_b_ * sin_b_);
  q.half_width = compliance_.half_width;
  double soft = 0.0;
  for (const ElasticBody& b : compliance_.bodies) {
    const double plane = plane_softness(b);
    soft += plane;
    q.local += 2 * plane / std::numbers::pi;
  }
  q.reduced_modulus = 1 / soft;
  if (at.rows.empty()) return at;
  if (shafts_.any()) {
    std::vector<ShaftYield::Place> places;
    for (const Row& row : at.rows)
      places.push_back({row.slice, at.pairs[row.pair].at[row.slice]->radius});
    at.shafts = q.length * shafts_.between(places);
  }
  q.yield = std::make_shared<const MatrixXd>(yields(at));
  return at;
}

MatrixXd PositionSolver::yields(const Position& at) const {
  const int n = compliance_.slices[0].count;
  const auto pairs = static_cast<int>(at.pairs.size());
  MatrixXd all = MatrixXd::Zero(pairs * n, pairs * n);
  for (int g = 0; g < 2; ++g) {
    const ToothTable& table = *compliance_.table[g];
    const double unit = at.problem.length / (compliance_.bodies[g].youngs_modulus * module_[g]);
    for (int a = 0; a < pairs; ++a) {
      all.block(a * n, a * n, n, n) += unit * table.same_tooth(at.lines[g][a]);
      for (int b = 0; b < a; ++b) {
        const int k = teeth_between(g, at.pairs[a].pair, at.pairs[b].pair);
        const MatrixXd c = unit * table.other_tooth(k, at.lines[g][a], at.lines[g][b]);
        all.block(a * n, b * n, n, n) += c;
        all.block(b * n, a * n, n, n) += c.transpose();
      }
    }
  }
  const auto m = static_cast<Index>(at.rows.size());
  MatrixXd yield(m, m);
  for (Index i = 0; i < m; ++i)
    for (Index j = 0; j < m; ++j)
      yield(i, j) =
          all(at.rows[i].pair * n + at.rows[i].slice, at.rows[j].pair * n + at.rows[j].slice);
  if (shafts_.any()) yield += at.shafts;
  return yield;
}

LoadedPosition PositionSolver::solve(Position& at, double torque, Angle rotation1, bool& too_fine,
                                     RootStress& swing) const {
  LoadedPosition out;
  out.rotation1 = rotation1;
  if (at.rows.empty()) return out;
  const double sign = pair_.turned();
  out.unloaded_te = Angle::radians(sign * at.te);
  ContactProblem& q = at.problem;
  q.moment = torque * ratio_;
  const ContactSolution x = solve_contact(q);
  out.iterations = x.iterations;
  if (x.stop == ContactSolution::Stop::indefinite) too_fine = true;
  out.unfinished = !x.found();
  if (out.unfinished) return out;
  out.max_pressure = out.max_width_ratio = 0.0;
  // The displacement of the axes is not a deflection of the mesh, so it is subtracted from the
  // approach. LoadedTurn::result() subtracts its mean over the positions from the transmission
  // error. [T12.36], [T12.36a]
  out.te = Angle::radians(sign * (at.te - x.approach));
  double approach = x.approach;
  double tangent = x.yield_per_moment;
  if (shafts_.any()) {
    const VectorXd& h = x.approach_per_gap;
    approach -= q.length * x.line_load.dot(at.shafts * x.line_load) / q.moment;
    tangent -= h.dot(at.shafts * h) / q.length;
  }
  out.approach = approach * base_radius_;
  out.tangent = tangent * base_radius_ * base_radius_;
  const int n = compliance_.slices[0].count;
  const double total = x.line_load.sum();
  std::vector<VectorXd> load(at.pairs.size(), VectorXd::Zero(n));
  std::vector<LoadedPair> pairs(at.pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    pairs[k].pair = at.pairs[k].pair;
    pairs[k].pressure = pairs[k].half_width = VectorXd::Zero(n);
    pairs[k].radius.resize(n);
    for (int j = 0; j < n; ++j)
      if (at.pairs[k].at[j]) pairs[k].radius[j] = at.pairs[k].at[j]->radius;
  }
  for (std::size_t i = 0; i < at.rows.size(); ++i) {
    const auto [k, j] = at.rows[i];
    const double p = x.line_load[static_cast<Index>(i)];
    if (!(p > 0.0)) continue;
    const double radius = q.radius[static_cast<Index>(i)];
    const double a = hertz_half_width(p, radius, q.reduced_modulus);
    load[k][j] = p;
    pairs[k].half_width[j] = a;
    pairs[k].pressure[j] = 2 * p / (std::numbers::pi * a);
    out.max_width_ratio = std::max(out.max_width_ratio, a / radius);
    const TouchKind kind = at.pairs[k].at[j]->kind;
    if (is_edge(kind)) out.edge_carries = true;
    if (pairs[k].pressure[j] > out.max_pressure) {
      out.max_pressure = pairs[k].pressure[j];
      out.kind = kind;
    }
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    pairs[k].line_load = load[k];
    pairs[k].share = load[k].sum() / total;
    if (!(pairs[k].share > 0.0)) continue;
    if (sign < 0.0) reverse(pairs[k]);
    out.pairs.push_back(pairs[k]);
  }
  root_stress(at, load, out, swing);
  return out;
}

double PositionSolver::greatest_share(Position& at, double torque) const {
  if (at.rows.empty()) return 0.0;
  at.problem.moment = torque * ratio_;
  const ContactSolution x = solve_contact(at.problem);
  if (!x.found()) return kNoNumber;
  const VectorXd& load = x.line_load;
  VectorXd of_pair = VectorXd::Zero(static_cast<Index>(at.pairs.size()));
  for (std::size_t i = 0; i < at.rows.size(); ++i)
    of_pair[at.rows[i].pair] += load[static_cast<Index>(i)];
  return of_pair.maxCoeff() / load.sum();
}

void PositionSolver::root_stress(const Position& at, const std::vector<VectorXd>& load,
                                 LoadedPosition& out, RootStress& swing) const {
  for (int g = 0; g < 2; ++g) {
    const ToothTable& table = *compliance_.table[g];
    std::vector<ToothForces> forces;
    for (std::size_t a = 0; a < at.pairs.size(); ++a)
      if (!load[a].isZero(0.0))
        forces.push_back(
            {at.pairs[a].pair, table.on_grid(at.lines[g][a], load[a] * at.problem.length)});
    out.root_stress[g] = greatest_root_stress(table, g, module_[g], forces, swing[g]);
  }
}

}  // namespace gearwright::detail
