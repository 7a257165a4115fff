#include "gearwright/compliance/section_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "gearwright/compliance/q9.hpp"
#include "gearwright/curve/arc_length.hpp"

namespace gearwright {

namespace {

using Complex = std::complex<double>;

constexpr int kLengthSteps = 64;    // chords per element; their total length has an error of 1e-6
constexpr double kSameNode = 1e-7;  // modules: points closer than this are merged
constexpr double kNoArc = 1e-6;     // modules: arcs shorter than this are ignored
constexpr int kLeastTeeth = 3;      // the model of a tooth includes its neighbour on each side
constexpr double kMinRim = 0.3;     // modules: smallest thickness of the body behind the teeth

struct Part {
  Arc arc;
  int elements;
};

double arc_length(const Arc& arc) {
  return arc.begin == arc.end ? 0.0 : ArcLength(*arc.curve, arc.begin, arc.end).length();
}

// Distributes a number of elements among all arcs with the same name, in proportion to their
// length. Each arc receives at least one element.
void share_out(std::vector<Part>& parts, ArcName name, int elements) {
  double sum = 0.0;
  for (const Part& p : parts)
    if (p.arc.name == name) sum += arc_length(p.arc);
  for (Part& p : parts)
    if (p.arc.name == name)
      p.elements = std::max(1, static_cast<int>(std::lround(elements * arc_length(p.arc) / sum)));
}

// Adds nodes. Nodes that two blocks have in common are merged.
class Nodes {
 public:
  explicit Nodes(std::vector<Complex>& nodes) : nodes_(nodes) {}
  int add(const Complex& w) {
    const long i = std::lround(w.real() / kCell);
    const long j = std::lround(w.imag() / kCell);
    for (long a = i - 1; a <= i + 1; ++a)
      for (long b = j - 1; b <= j + 1; ++b)
        if (const auto it = places_.find({a, b}); it != places_.end())
          if (std::abs(nodes_[it->second] - w) < kSameNode) return it->second;
    const int id = static_cast<int>(nodes_.size());
    nodes_.push_back(w);
    places_[{i, j}] = id;
    return id;
  }

 private:
  static constexpr double kCell = 1e-5;  // modules, much smaller than any element
  std::vector<Complex>& nodes_;
  std::map<std::pair<long, long>, int> places_;
};

// The (2a+1) × (2b+1) points of a block of a × b elements.
struct Block {
  int rows, columns;
  std::vector<Complex> points;
  Block(int r, int c) : rows(r), columns(c), points(static_cast<std::size_t>(r) * c) {}
  Complex& at(int i, int j) { return points[static_cast<std::size_t>(i) * columns + j]; }
  const Complex& at(int i, int j) const {
    return points[static_cast<std::size_t>(i) * columns + j];
  }
};

double jacobian(const SectionMesh& mesh, const std::array<int, 9>& e, double x, double y) {
  const detail::Shape9 s = detail::shape9(x, y);
  Complex by_x = 0.0;
  Complex by_y = 0.0;
  for (int k = 0; k < 9; ++k) {
    by_x += s.slope(0, k) * mesh.nodes[e[k]];
    by_y += s.slope(1, k) * mesh.nodes[e[k]];
  }
  return by_x.real() * by_y.imag() - by_x.imag() * by_y.real();
}

class Builder {
 public:
  explicit Builder(SectionMesh& mesh) : mesh_(mesh), nodes_(mesh.nodes) {}

  // Adds the elements of a block and returns its nodes in the order of the points.
  std::vector<int> add(const Block& b) {
    std::vector<int> id(b.points.size());
    for (std::size_t k = 0; k < id.size(); ++k) id[k] = nodes_.add(b.points[k]);
    const auto at = [&](int i, int j) { return id[static_cast<std::size_t>(i) * b.columns + j]; };
    for (int i = 0; i + 2 < b.rows; i += 2) {
      for (int j = 0; j + 2 < b.columns; j += 2) {
        std::array<int, 9> e{at(i, j),         at(i + 2, j), at(i + 2, j + 2),
                             at(i, j + 2),     at(i + 1, j), at(i + 2, j + 1),
                             at(i + 1, j + 2), at(i, j + 1), at(i + 1, j + 1)};
        // Elements of blocks that run clockwise are reversed. Their side y = −1 remains the same.
        if (jacobian(mesh_, e, 0, 0) < 0.0)
          e = {e[1], e[0], e[3], e[2], e[4], e[7], e[6], e[5], e[8]};
        mesh_.elements.push_back(e);
      }
    }
    return id;
  }

 private:
  SectionMesh& mesh_;
  Nodes nodes_;
};

std::vector<double> with_middles(const std::vector<double>& ends) {
  std::vector<double> all{ends.front()};
  for (std::size_t i = 1; i < ends.size(); ++i) {
    all.push_back(0.5 * (ends[i - 1] + ends[i]));
    all.push_back(ends[i]);
  }
  return all;
}

bool folds(const SectionMesh& mesh) {
  for (const auto& e : mesh.elements)
    for (const auto& p : detail::gauss9())
      if (!(jacobian(mesh, e, p.x, p.y) > 0.0)) return true;
  return false;
}

void measure(SectionMesh& mesh) {
  const int n = mesh.arc_begin.back();
  mesh.lengths.assign(static_cast<std::size_t>(n) * kLengthSteps + 1, 0.0);
  Complex last = mesh.outline(0.0);
  for (std::size_t i = 1; i < mesh.lengths.size(); ++i) {
    const Complex w = mesh.outline(double(i) / kLengthSteps);
    mesh.lengths[i] = mesh.lengths[i - 1] + std::abs(w - last);
    last = w;
  }
}

}  // namespace

SectionMesh::OnArc SectionMesh::arc_at(double t) const {
  std::size_t i = 0;
  while (i + 1 < arcs.size() && t >= arc_begin[i + 1]) ++i;
  const double n = arc_begin[i + 1] - arc_begin[i];
  const double u = std::clamp((t - arc_begin[i]) / n, 0.0, 1.0);
  return {&arcs[i], arcs[i].name == ArcName::flank ? 1 - std::pow(1 - u, to_tip) : u};
}

std::complex<double> SectionMesh::outline(double t) const {
  const OnArc at = arc_at(t);
  const Vec2 p = at.arc->point(at.u) / module;
  return {p.x(), p.y()};
}

double SectionMesh::length_at(double t) const {
  const double at = std::clamp(t * kLengthSteps, 0.0, double(lengths.size() - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(at), lengths.size() - 2);
  return lengths[i] + (at - double(i)) * (lengths[i + 1] - lengths[i]);
}

double SectionMesh::parameter_at(double length) const {
  const auto it = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, length);
  const auto i = static_cast<std::size_t>(it - lengths.begin()) - 1;
  return (double(i) + (length - lengths[i]) / (lengths[i + 1] - lengths[i])) / kLengthSteps;
}

std::optional<Error> too_few_teeth(int teeth) {
  if (std::abs(teeth) >= kLeastTeeth) return std::nullopt;
  return Error{"teeth", std::to_string(teeth),
               "is not possible under load; the gear must have at least 3 teeth, because the model "
               "of a tooth includes its neighbour on each side",
               FailureKind::not_under_load};
}

Result<SectionMesh> make_section_mesh(const Outline& outline, double module, double bore_radius,
                                      const SectionMeshOptions& options) {
  GW_EXPECTS(outline.teeth != 0 && module > 0.0 && bore_radius > 0.0);
  SectionMesh mesh;
  mesh.module = module;
  mesh.to_tip = options.to_tip;
  mesh.outward = outline.side();
  mesh.tooth_count = std::abs(outline.teeth);
  mesh.bore_radius = bore_radius / module;
  if (auto error = too_few_teeth(outline.teeth)) return *error;
  std::vector<Part> parts;
  for (const Arc& arc : outline.arcs)
    if (arc.name != ArcName::tip_land && arc_length(arc) > kNoArc * module)
      parts.push_back({arc, 1});
  share_out(parts, ArcName::root_fillet, options.fillet);
  share_out(parts, ArcName::flank, options.flank);
  share_out(parts, ArcName::tip_fillet, 2);
  int n = 0;
  mesh.fillet_begin = mesh.flank_begin = -1;
  for (const Part& p : parts) {
    mesh.arcs.push_back(p.arc);
    mesh.arc_begin.push_back(n);
    if (p.arc.name == ArcName::root_fillet && mesh.fillet_begin < 0) mesh.fillet_begin = n;
    if (p.arc.name == ArcName::flank && mesh.flank_begin < 0) mesh.flank_begin = n;
    n += p.elements;
    if (p.arc.name == ArcName::flank) mesh.flank_end = n;
  }
  mesh.arc_begin.push_back(n);
  if (mesh.flank_begin < 0)
    return Error{"teeth", "", "the gear has no flank that can carry load",
                 FailureKind::not_under_load};
  if (mesh.fillet_begin < 0) mesh.fillet_begin = mesh.flank_begin;
  measure(mesh);

  const int z = mesh.tooth_count;
  const double pit = std::numbers::pi / z;
  const int side = std::min(options.side_teeth, (z - 1) / 2);
  mesh.side_teeth = side;
  const Complex root = mesh.outline(0.0);
  const Complex tip = mesh.outline(n);
  mesh.root_radius = std::abs(root);
  const double ri = mesh.bore_radius;
  const double out = mesh.outward;
  const double rim = out * (mesh.root_radius - ri);
  if (!(rim > kMinRim)) {
    return refused("bore.diameter", 2 * bore_radius,
                   {2 * module * (mesh.root_radius - out * kMinRim)},
                   out > 0.0 ? "must be at most {} mm, so that a rim remains under the teeth"
                             : "must be at least {} mm, because the bore of an internal gear is "
                               "the outside diameter of its rim, and a rim must remain around the "
                               "teeth");
  }
  // Radii, in normal modules. `foot` is the radius at which the centre line of a tooth ends in the
  // rim, and `body` is the radius of the border between rim and body.
  const double foot = mesh.root_radius - out * std::min(1.125, 0.5 * rim);
  const double below = 0.45 * options.rim;
  const double left = out * (foot - ri);
  const double body = left - below > 0.3 ? foot - out * below : ri + 0.5 * (foot - ri);

  std::vector<double> across(options.across + 1);
  for (int i = 0; i <= options.across; ++i)
    across[i] = std::pow(double(i) / options.across, options.to_outline);
  across = with_middles(across);
  const int columns = static_cast<int>(across.size());
  Block half(2 * n + 1, columns);
  for (int i = 0; i <= 2 * n; ++i) {
    const double t = 0.5 * i;
    const Complex w = mesh.outline(t);
    const double way = mesh.length_at(t) / mesh.lengths.back();
    const double rise = (w.real() - root.real()) / (tip.real() - root.real());
    const double center = foot + (std::abs(tip) - foot) * (0.55 * way + 0.45 * rise);
    for (int j = 0; j < columns; ++j) half.at(i, j) = w * (1 - across[j]) + center * across[j];
  }
  const int rows = 2 * options.rim + 1;
  const auto fraction = [](int j, int count) { return double(j) / (count - 1); };
  Block under(columns, rows);
  for (int i = 0; i < columns; ++i) {
    const Complex to = std::polar(body, pit * (1 - across[i]));
    for (int j = 0; j < rows; ++j) {
      const double f = fraction(j, rows);
      under.at(i, j) = half.at(0, i) * (1 - f) + to * f;
    }
  }
  std::vector<double> depth{0.0};
  {
    const double q = options.body > 1 ? std::pow(3.0, 1.0 / (options.body - 1)) : 1.0;
    double step = 1.0;
    for (int i = 0; i < options.body; ++i, step *= q) depth.push_back(depth.back() + step);
    for (double& d : depth) d /= depth.back();
    depth = with_middles(depth);
  }

  const auto turned = [](Block b, const Complex& turn, bool mirror) {
    for (Complex& w : b.points) w = (mirror ? std::conj(w) : w) * turn;
    return b;
  };
  const auto annulus = [&](const std::vector<double>& angles) {
    Block b(static_cast<int>(angles.size()), static_cast<int>(depth.size()));
    for (int i = 0; i < b.rows; ++i)
      for (int j = 0; j < b.columns; ++j)
        b.at(i, j) = std::polar(body + (ri - body) * depth[j], angles[i]);
    return b;
  };
  Builder build(mesh);
  std::vector<double> sector;
  for (const double c : across) sector.push_back(pit * (1 - c));
  mesh.teeth.resize(2 * side + 1);
  for (int k = -side; k <= side; ++k) {
    const Complex turn = std::polar(1.0, 2 * pit * k);
    const auto first = static_cast<int>(mesh.elements.size());
    auto& nodes = mesh.teeth[k + side];
    for (const bool mirror : {false, true}) {
      const auto ids = build.add(turned(half, turn, mirror));
      nodes.insert(nodes.end(), ids.begin(), ids.end());
      if (mirror) continue;
      std::vector<SectionMesh::Edge> edges;
      for (int e = 0; e < n; ++e) {
        const int element = first + e * options.across;
        const int start = ids[static_cast<std::size_t>(2 * e) * columns];
        edges.push_back({element, mesh.elements[element][0] == start});
      }
      if (k == 0) mesh.edges = edges;
      mesh.tooth_edges.push_back(std::move(edges));
    }
    for (const bool mirror : {false, true}) {
      build.add(turned(under, turn, mirror));
      std::vector<double> angles;
      for (const double a : sector) angles.push_back((mirror ? -a : a) + 2 * pit * k);
      build.add(annulus(angles));
    }
  }
  if (const double from = pit * (2 * side + 1); z > 2 * side + 1) {
    std::vector<double> ends;
    for (int i = 0; i <= options.rest; ++i) {
      const double u = double(i) / options.rest;
      const double graded = 0.6 * (0.5 - 0.5 * std::cos(std::numbers::pi * u)) + 0.4 * u;
      ends.push_back(from + 2 * (std::numbers::pi - from) * graded);
    }
    const auto angles = with_middles(ends);
    Block ring(static_cast<int>(angles.size()), rows);
    for (int i = 0; i < ring.rows; ++i) {
      for (int j = 0; j < rows; ++j) {
        const double f = fraction(j, rows);
        ring.at(i, j) = std::polar(mesh.root_radius * (1 - f) + body * f, angles[i]);
      }
    }
    build.add(ring);
    build.add(annulus(angles));
  }
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    if (std::abs(std::abs(mesh.nodes[i]) - ri) < kSameNode)
      mesh.bore.push_back(static_cast<int>(i));
  if (folds(mesh)) {
    return Error{
        "teeth", std::to_string(outline.teeth),
        "gives a tooth that cannot be divided into finite elements, because it is too undercut or "
        "too pointed; a greater profile shift or a smaller tip diameter would help",
        FailureKind::not_under_load};
  }
  return mesh;
}

}  // namespace gearwright
