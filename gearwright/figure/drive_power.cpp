#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "gearwright/base/numbers.hpp"
#include "gearwright/figure/drive_figures.hpp"
#include "gearwright/figure/free_labels.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

constexpr double kBar = 0.05;  // half the width of a node, relative to the distance between columns
constexpr double kAir = 0.62;  // gap between nodes, relative to the distance between columns
constexpr double kShown = 0.006;  // least width of a band, relative to the height of the diagram
constexpr int kPieces = 24;
// Width of the picture for which the names are spaced, and step by which names are moved up, px.
constexpr double kWidth = 616.0, kLift = 18.0;

// A body or a mesh. Powers are shares of the input power.
struct Node {
  bool mesh;
  std::size_t index;
  double in = 0.0, out = 0.0, outside_in = 0.0, outside_out = 0.0;
  int column = 0;
  double y = 0.0;  // height of the middle of the node
  double height() const { return std::max(in + outside_in, out + outside_out); }
};

struct Band {
  std::size_t from, to;
  double power;
  // True if the band runs from a later column to an earlier one.
  bool back = false;
  double leaves = 0.0, arrives = 0.0;  // y of the centre line of the band at `from` and at `to`
};

class PowerDiagram {
 public:
  explicit PowerDiagram(const Drive& drive) : drive_(drive) {}

  std::optional<Figure> figure() {
    collect();
    if (bands_.empty()) return std::nullopt;
    find_columns();
    stack();
    draw();
    return std::move(f_);
  }

 private:
  std::size_t node(bool mesh, std::size_t index) {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (nodes_[i].mesh == mesh && nodes_[i].index == index) return i;
    nodes_.push_back({mesh, index});
    return nodes_.size() - 1;
  }

  void collect() {
    const PowerFlow& flow = *drive_.flow;
    for (const PowerPath& path : flow.paths) {
      const std::size_t body = node(false, path.body), mesh = node(true, path.mesh);
      const double power = path.power / flow.power_in;
      if (power < 0.0) {
        bands_.push_back({body, mesh, -power});
        nodes_[body].out -= power;
        nodes_[mesh].in -= power;
      } else {
        bands_.push_back({mesh, body, power});
        nodes_[mesh].out += power;
        nodes_[body].in += power;
      }
    }
    for (Node& n : nodes_) {
      if (n.mesh) continue;
      const double outside = n.out - n.in;
      constexpr double kNothing = 1e-9;
      if (outside > kNothing) n.outside_in = outside;
      if (outside < -kNothing) n.outside_out = -outside;
    }
  }

  // Puts each node in a column to the right of all nodes from which it gets power. A band that
  // closes a loop is marked as `back` and has no effect on the columns.
  void find_columns() {
    std::vector<int> state(nodes_.size(), 0);  // 1: being visited, 2: done
    std::vector<std::size_t> order;
    const std::function<void(std::size_t)> visit = [&](std::size_t n) {
      state[n] = 1;
      for (Band& band : bands_) {
        if (band.from != n) continue;
        if (state[band.to] == 1) band.back = true;
        if (state[band.to] == 0) visit(band.to);
      }
      state[n] = 2;
      order.push_back(n);
    };
    for (const bool sources : {true, false})
      for (std::size_t n = 0; n < nodes_.size(); ++n)
        if (state[n] == 0 && (!sources || nodes_[n].outside_in > 0.0)) visit(n);
    for (auto n = order.rbegin(); n != order.rend(); ++n)
      for (const Band& band : bands_)
        if (band.from == *n && !band.back)
          nodes_[band.to].column = std::max(nodes_[band.to].column, nodes_[*n].column + 1);
    for (const Node& n : nodes_) last_ = std::max(last_, n.column);
  }

  // Stacks the nodes of each column from top to bottom, in the vertical order of the nodes that
  // supply them.
  void stack() {
    double most = 0.0;
    for (int c = 0; c <= last_; ++c) {
      double sum = 0.0;
      for (const Node& n : nodes_)
        if (n.column == c) sum += n.height();
      most = std::max(most, sum);
    }
    scale_ = std::min(1.0, 0.3 * (last_ + 1)) / most;
    for (int c = 0; c <= last_; ++c) {
      std::vector<std::size_t> column;
      for (std::size_t n = 0; n < nodes_.size(); ++n)
        if (nodes_[n].column == c) column.push_back(n);
      const auto wish = [&](std::size_t n) {
        double sum = 0.0, weight = 0.0;
        for (const Band& band : bands_) {
          if (band.to != n || band.back) continue;
          sum += band.power * nodes_[band.from].y;
          weight += band.power;
        }
        return weight > 0.0 ? sum / weight : 0.0;
      };
      std::stable_sort(column.begin(), column.end(),
                       [&](std::size_t a, std::size_t b) { return wish(a) > wish(b); });
      double total = kAir * static_cast<double>(column.size() - 1);
      for (const std::size_t n : column) total += scale_ * nodes_[n].height();
      double y = total / 2;
      for (const std::size_t n : column) {
        nodes_[n].y = y - scale_ * nodes_[n].height() / 2;
        y -= scale_ * nodes_[n].height() + kAir;
      }
      low_ = std::min(low_, -total / 2);
      high_ = std::max(high_, total / 2);
    }
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      dock(n, &Band::from, &Band::to, &Band::leaves);
      dock(n, &Band::to, &Band::from, &Band::arrives);
    }
  }

  // Sets the positions of the bands at one side of a node, in the vertical order of the
  // opposite ends of the bands.
  void dock(std::size_t n, std::size_t Band::*here, std::size_t Band::*there, double Band::*place) {
    std::vector<Band*> list;
    for (Band& band : bands_)
      if (band.*here == n) list.push_back(&band);
    std::stable_sort(list.begin(), list.end(), [&](const Band* a, const Band* b) {
      if (a->back != b->back) return b->back;
      return nodes_[a->*there].y > nodes_[b->*there].y;
    });
    double y = nodes_[n].y + scale_ * nodes_[n].height() / 2;
    for (Band* band : list) {
      band->*place = y - scale_ * band->power / 2;
      y -= scale_ * band->power;
    }
  }

  double x_of(const Node& n) const { return n.column; }

  void ribbon(const std::vector<Vec2>& line, double width, const std::string& style,
              const std::string& words) {
    std::vector<Vec2> area, under;
    const double half = std::max(width, kShown * (high_ - low_)) / 2;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Vec2 along =
          (line[std::min(i + 1, line.size() - 1)] - line[i == 0 ? 0 : i - 1]).normalized();
      const Vec2 across(-along.y(), along.x());
      area.push_back(line[i] + half * across);
      under.push_back(line[i] - half * across);
    }
    area.insert(area.end(), under.rbegin(), under.rend());
    f_.area(std::move(area), style);
    f_.marks.back().words = words;
  }

  static std::vector<Vec2> curve(const Vec2& a, const Vec2& b) {
    std::vector<Vec2> line;
    const double middle = (a.x() + b.x()) / 2;
    for (int i = 0; i <= kPieces; ++i) {
      const double t = static_cast<double>(i) / kPieces, s = 1 - t;
      line.emplace_back(
          s * s * s * a.x() + 3 * s * s * t * middle + 3 * s * t * t * middle + t * t * t * b.x(),
          (s * s * s + 3 * s * s * t) * a.y() + (3 * s * t * t + t * t * t) * b.y());
    }
    return line;
  }

  // Returns a line from the right side of one node to the left side of another. Between them, the
  // line is at the height `low`, which is below all nodes.
  std::vector<Vec2> loop(const Vec2& a, const Vec2& b, double low, double reach) const {
    std::vector<Vec2> line;
    const auto half_turn = [&](const Vec2& from, double to, double side) {
      const double r = (from.y() - to) / 2, y = (from.y() + to) / 2;
      for (int i = 0; i <= kPieces; ++i) {
        const double t = kPi * i / kPieces;
        line.emplace_back(from.x() + side * reach * std::sin(t), y + r * std::cos(t));
      }
    };
    half_turn(a, low, 1.0);
    std::vector<Vec2> first = std::move(line);
    line.clear();
    half_turn(b, low, -1.0);
    first.insert(first.end(), line.rbegin(), line.rend());
    return first;
  }

  std::string name_of(const Node& n) const {
    return n.mesh ? drive_.graph.meshes[n.index].name : drive_.graph.bodies[n.index].name;
  }

  static std::string share(double power) {
    const double value = 100 * power;
    return fmt::format("{:.{}f} %", value, value < 10 ? 2 : 1);
  }

  void draw() {
    f_.id = "power";
    f_.title = "Power flow.";
    f_.description =
        "Bands lead from the inputs through bodies and meshes to the output. The width of a band "
        "is proportional to its power. Losses leave downwards.";
    f_.caption =
        " The bands show powers in the frame of the housing, relative to the input power. The loss "
        "of a mesh leaves downwards. The number below the name of a mesh is the power that its "
        "teeth transmit in the frame of the mesh. A band that runs back below all others shows "
        "circulating power.";
    f_.bare = true;
    double low = low_ - 0.35;
    for (const Band& band : bands_) {
      const Node &a = nodes_[band.from], &b = nodes_[band.to];
      const double w = scale_ * band.power;
      const Vec2 from(x_of(a) + kBar, band.leaves), to(x_of(b) - kBar, band.arrives);
      const std::size_t body = a.mesh ? b.index : a.index;
      std::vector<Vec2> line;
      if (band.back) {
        low -= w / 2 + 0.05;
        line = loop(from, to, low, std::max(0.3, w));
        low -= w / 2 + 0.05;
        reach_ = std::max(reach_, std::max(0.3, w) + w / 2);
      } else {
        line = curve(from, to);
      }
      ribbon(line, w, "flow " + body_style(body),
             fmt::format("{} → {}: {}", name_of(a), name_of(b), share(band.power)));
    }
    f_.x = {"", "", -0.75 - reach_, last_ + 0.75 + reach_};
    top_ = high_ + 0.35;
    std::stable_sort(nodes_.begin(), nodes_.end(),
                     [](const Node& a, const Node& b) { return a.column < b.column; });
    for (const Node& n : nodes_) draw_node(n);
    f_.y = {"", "", std::min(low, low_ - 0.5), top_};
    f_.tall = (f_.y.hi - f_.y.lo) / (f_.x.hi - f_.x.lo);
  }

  void draw_node(const Node& n) {
    const double x = x_of(n), half = std::max(scale_ * n.height(), kShown) / 2;
    const double top = n.y + half, bottom = n.y - half;
    if (n.outside_in > 0.0)
      ribbon(
          {{x - 0.5, top - scale_ * n.outside_in / 2}, {x - kBar, top - scale_ * n.outside_in / 2}},
          scale_ * n.outside_in, "flow " + body_style(n.index), "in " + share(n.outside_in));
    if (n.outside_out > 0.0)
      ribbon({{x + kBar, bottom + scale_ * n.outside_out / 2},
              {x + 0.5, bottom + scale_ * n.outside_out / 2}},
             scale_ * n.outside_out, "flow " + body_style(n.index), "out " + share(n.outside_out));
    if (n.mesh) {
      const double loss = n.in - n.out;
      std::vector<Vec2> line;
      for (int i = 0; i <= kPieces; ++i) {
        const double t = kHalfPi * i / kPieces;
        line.emplace_back(x + kBar + 0.12 * std::sin(t),
                          bottom + scale_ * loss / 2 - 0.16 * (1 - std::cos(t)));
      }
      ribbon(line, scale_ * loss, "flow-loss", "loss " + share(loss));
      f_.text({x + kBar + 0.12, bottom - 0.16}, escaped("-" + share(loss)), Anchor::middle,
              "tick halo", {0.0, 14.0});
    }
    f_.bar({x - kBar, bottom}, {x + kBar, top},
           n.mesh ? "flow-mesh" : "flow-body " + body_style(n.index),
           name_of(n) + " " + share(n.height()));
    const bool end = n.outside_in > 0.0 || n.outside_out > 0.0;
    const double value = n.outside_in > 0.0    ? n.outside_in
                         : n.outside_out > 0.0 ? n.outside_out
                                               : n.height();
    std::string under = share(value);
    if (n.mesh)
      under = "rolling " + share(drive_.flow->mesh_power[n.index] / drive_.flow->power_in);
    write_name({x, top}, name_of(n), under, end);
  }

  // Writes a name and the words under it above a node. Words that would overlap the words of
  // another node are moved up and joined to their node by a line.
  void write_name(const Vec2& at, const std::string& name, const std::string& under, bool end) {
    const double px = kWidth / (f_.x.hi - f_.x.lo);
    const std::string& longest = name.size() > under.size() ? name : under;
    // The words lie above all bands that pass below them.
    double clear = at.y();
    for (const FigureMark& m : f_.marks)
      for (const Vec2& p : m.points)
        if (m.kind == FigureMark::Kind::area &&
            std::abs(p.x() - at.x()) * px <= label_width(longest) / 2)
          clear = std::max(clear, p.y());
    double lift = px * (clear - at.y());
    const auto box = [&] {
      return label_box({{px * at.x(), -px * at.y()}, {0.0, -18.0 - lift}, Anchor::middle}, longest);
    };
    const auto taken = [&](const PixelBox& other) { return meet(box(), other); };
    while (std::any_of(names_.begin(), names_.end(), taken)) lift += kLift;
    PixelBox own = box();
    own.top -= kLift / 2;
    own.bottom += kLift / 2;
    names_.push_back(own);
    if (lift > 0.0) f_.line({at, {at.x(), at.y() + lift / px}}, "leader");
    f_.text(at, escaped(name), Anchor::middle, end ? "panel halo" : "halo", {0.0, -24.0 - lift});
    f_.text(at, escaped(under), Anchor::middle, "tick halo", {0.0, -6.0 - lift});
    top_ = std::max(top_, at.y() + (lift + 2 * kLift) / px);
  }

  const Drive& drive_;
  Figure f_;
  std::vector<Node> nodes_;
  std::vector<Band> bands_;
  int last_ = 0;
  std::vector<PixelBox> names_;
  double scale_ = 1.0, low_ = 0.0, high_ = 0.0, reach_ = 0.0, top_ = 0.0;
};

}  // namespace

std::optional<Figure> power_figure(const Drive& drive) {
  if (!drive.flow || drive.flow->self_locking() || !(drive.flow->power_in > 0.0))
    return std::nullopt;
  return PowerDiagram(drive).figure();
}

}  // namespace gearwright
