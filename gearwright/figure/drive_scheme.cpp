#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "gearwright/figure/drive_figures.hpp"
#include "gearwright/figure/drive_words.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

// Lengths in units of the picture. The greatest radius is kTall or kTallSet. The distance between
// neighbouring slots (axial sections, drive_places.hpp) is kSlot.
constexpr double kTall = 2.0, kSlot = 2.7;
constexpr double kTallSet = 3.0;   // with planetary sets, whose names need room between the lines
constexpr double kBeside = 8.0;    // px from a gear to its name, on the right or on the left
constexpr double kHalf = 0.3;      // half the length of a bar of teeth
constexpr double kWeb = 1.2;       // from the middle of a slot to the web of a carrier
constexpr double kBell = 1.45;     // from the middle of a slot to the bell of a ring
constexpr double kLevel = 0.2;     // distance between coaxial shafts
constexpr double kApart = 0.05;    // half the gap between the bars of a mesh
constexpr double kEnd = 1.5;       // from the last web to the end of the outer shaft
constexpr double kLine = 18.0;     // px between lines of words
constexpr double kName = 22.0;     // px, height of a name above its shaft
constexpr double kBack = 0.45;     // from the teeth of a rack to its back
constexpr double kMargins = 24.0;  // px, both margins of a picture without axes
constexpr double kFurther = 2.5;   // from the end of a shaft to the end of the next shaft inside it

// A vertical line from the shaft of a body to a gear or a carrier. For a ring, the line is the web
// of the bell, which is the part that joins the ring to its shaft.
struct Rise {
  double x, to;
};

class Scheme {
 public:
  Scheme(const Drive& drive, const DrivePlaces& places, double width)
      : drive_(drive), graph_(drive.graph), places_(places), drawn_(width - kMargins) {}

  Figure figure() {
    f_.id = "scheme";
    f_.title = "The kinematic scheme.";
    f_.description =
        "Gears are drawn as lines with bars for their teeth, and shafts as lines. Each carrier is "
        "drawn with one planet. Fixed bodies are marked. Speeds and torques are at the ends of the "
        "shafts.";
    f_.caption =
        " The picture is a half section. Planetary sets are drawn above their axis, with one "
        "planet each. Radii are to scale, but lengths along the axes are not.";
    f_.bare = true;
    unfold();
    if (!is_plane_)
      f_.caption += " Axes in other directions are turned into the plane of the picture.";
    if (std::any_of(graph_.gears.begin(), graph_.gears.end(),
                    [](const DriveGear& gear) { return gear.rack.has_value(); }))
      f_.caption += " Racks are drawn in section and move perpendicular to the picture.";
    measure();
    draw_gears();
    draw_carriers();
    draw_shafts();
    frame();
    return std::move(f_);
  }

 private:
  bool rides(std::size_t body) const { return graph_.bodies[body].carrier.has_value(); }
  bool is_end(std::size_t body) const {
    return graph_.is_input(body) || graph_.output == body || graph_.is_fixed(body);
  }
  // True if the shaft of a body ends at the left. The shafts of inputs end at the left, and the
  // shaft of the output ends at the right. The shaft of a fixed body ends at the left, or at the
  // right if an input has the same axis.
  bool leaves_left(std::size_t body) const {
    return graph_.output != body && (graph_.is_input(body) || !left_taken(body));
  }
  bool left_taken(std::size_t body) const {
    return std::any_of(graph_.inputs.begin(), graph_.inputs.end(), [&](std::size_t in) {
      return (places_.axes[in] - places_.axes[body]).norm() < 1e-9;
    });
  }

  double slot_x(int slot) const { return kSlot * slot; }
  double axis_y(std::size_t body) const { return scale_ * heights_[body]; }

  // Computes the heights of the axes. Axes that do not lie in one plane are unfolded into the plane
  // of the picture, so that each mesh keeps its centre distance.
  void unfold() {
    for (const Vec2& axis : places_.axes) heights_.push_back(axis.x());
    const auto across = [&](const DriveMesh& m) -> Vec2 {
      return places_.axes[graph_.gear(m, 1).body] - places_.axes[graph_.gear(m, 0).body];
    };
    is_plane_ = std::all_of(graph_.meshes.begin(), graph_.meshes.end(), [&](const DriveMesh& m) {
      return graph_.frame(m) || std::abs(across(m).y()) < 1e-6 * across(m).norm();
    });
    std::vector<char> placed(heights_.size(), is_plane_);
    placed[graph_.inputs.front()] = 1;
    const auto place = [&](std::size_t from, std::size_t to, double apart) {
      if (!placed[from] || placed[to]) return false;
      heights_[to] = heights_[from] + apart;
      placed[to] = 1;
      return true;
    };
    for (bool found = true; found;) {
      found = false;
      for (const DriveMesh& m : graph_.meshes) {
        const std::size_t a = graph_.gear(m, 0).body, b = graph_.gear(m, 1).body;
        if (const auto carrier = graph_.frame(m)) {
          for (const std::size_t body : {a, b})
            if (!rides(body))
              found = place(body, *carrier, 0.0) || place(*carrier, body, 0.0) || found;
          continue;
        }
        const double apart = std::copysign(across(m).norm(), across(m).x());
        found = place(a, b, apart) || place(b, a, -apart) || found;
      }
    }
  }

  void measure() {
    double most = 0.0;
    for (const double r : places_.radii) most = std::max(most, r);
    scale_ = (drive_.sets.empty() ? kTall : kTallSet) / most;
    rises_.resize(graph_.bodies.size());
    for (std::size_t g = 0; g < graph_.gears.size(); ++g) radii_.push_back(working_radius(g));
  }

  // Returns the radius of the working pitch circle of a gear in its first mesh. If the gear has no
  // mesh, returns its own radius.
  double working_radius(std::size_t g) const {
    for (std::size_t m = 0; m < graph_.meshes.size(); ++m) {
      const auto& gears = graph_.meshes[m].gears;
      if (gears[0] != g && gears[1] != g) continue;
      const std::size_t a = graph_.gears[gears[0]].body, b = graph_.gears[gears[1]].body;
      const double distance = (places_.axes[a] - places_.axes[b]).norm();
      const int sum = graph_.gears[gears[0]].teeth + graph_.gears[gears[1]].teeth;
      return scale_ * distance * std::abs(graph_.gears[g].teeth) / std::abs(sum);
    }
    return scale_ * places_.radii[g];
  }

  std::string stick(std::size_t body) const { return "stick " + body_style(body); }

  void draw_gears() {
    for (std::size_t g = 0; g < graph_.gears.size(); ++g) {
      const DriveGear& gear = graph_.gears[g];
      const SlotRange slots = places_.slots[g];
      const double from = slot_x(slots.first) - kHalf, to = slot_x(slots.last) + kHalf;
      if (gear.rack) {
        draw_rack(g, from, to);
        continue;
      }
      const double x = (from + to) / 2, y = axis_y(gear.body);
      const std::string style = stick(gear.body);
      const auto bar = [&](double at) {
        f_.line({{from, at}, {to, at}}, "bar-stick " + body_style(gear.body));
      };
      std::string name = escaped(gear.name) + fmt::format(" {}", std::abs(gear.teeth));
      if (rides(gear.body) && graph_.bodies[gear.body].count > 1)
        name = fmt::format("{} × {}", graph_.bodies[gear.body].count, name);
      if (gear.is_ring()) {
        const double r = radii_[g] + kApart;
        bar(y + r);
        if (graph_.is_fixed(gear.body)) {
          ground({x, y + r}, true);
          f_.text({x, y + r + 0.28}, name, Anchor::middle, "", {0.0, -4.0});
        } else {
          const double side = bell_side(gear.body, slots);
          f_.line({{x, y + r}, {side, y + r}}, style);
          rises_[gear.body].push_back({side, y + r});
          f_.text({x, y + r}, name, Anchor::middle, "", {0.0, -7.0});
        }
        top_ = std::max(top_, y + r + 0.9);
        continue;
      }
      const double r = radii_[g] - kApart;
      const bool whole = rides(gear.body) || !in_a_set(g);
      bar(y + r);
      if (whole) bar(y - r);
      if (rides(gear.body)) {
        f_.line({{x, y - r}, {x, y + r}}, style);
      } else if (whole) {
        f_.line({{x, y - r}, {x, y + r}}, style);
        rises_[gear.body].push_back({x, y});
      } else {
        rises_[gear.body].push_back({x, y + r});
      }
      // figure_labels.cpp moves the name if it would overlap a line or another name.
      f_.point({x, y + r * 0.55}, 0.0, "", name, {kBeside, 0.0});
      f_.marks.back().label_style = "halo";
      top_ = std::max(top_, y + r + 0.35);
      bottom_ = std::min(bottom_, whole ? y - r - 0.35 : y - 0.9);
      right_ = std::max(right_, to + 0.3);
      left_ = std::min(left_, from - 0.3);
    }
  }

  // Draws the section of a rack perpendicular to its travel, with the teeth at the datum line and
  // the body behind them. The name of the body is written beyond its back.
  void draw_rack(std::size_t g, double from, double to) {
    const DriveGear& gear = graph_.gears[g];
    const auto mesh = std::find_if(graph_.meshes.begin(), graph_.meshes.end(),
                                   [&](const DriveMesh& m) { return m.gears[1] == g; });
    const double y = axis_y(gear.body), x = (from + to) / 2;
    const double out = std::copysign(1.0, y - axis_y(graph_.gear(*mesh, 0).body));
    const double teeth = y + out * kApart, back = teeth + out * kBack;
    f_.line({{from, teeth}, {to, teeth}}, "bar-stick " + body_style(gear.body));
    f_.line({{from, teeth}, {from, back}, {to, back}, {to, teeth}}, stick(gear.body));
    std::string name = escaped(gear.name);
    if (gear.rack->teeth) name += fmt::format(" {}", *gear.rack->teeth);
    f_.point({to, (teeth + back) / 2}, 0.0, "", name, {kBeside, 0.0});
    f_.marks.back().label_style = "halo";
    left_ = std::min(left_, from - 0.3);
    right_ = std::max(right_, to + 0.3);
    std::vector<std::string> lines =
        is_end(gear.body) ? end_words(drive_, gear.body) : std::vector<std::string>{};
    const auto count = static_cast<double>(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double line = static_cast<double>(i);
      const double down = out > 0.0 ? -9.0 - kLine * (count - 1.0 - line) : kLine * (line + 1.0);
      f_.text({x, back}, lines[i], Anchor::middle, i == 0 ? "panel halo" : "tick halo",
              {0.0, down});
    }
    beyond_.push_back({back, out * (kLine * count + 9.0)});
  }

  bool in_a_set(std::size_t g) const {
    return std::any_of(graph_.meshes.begin(), graph_.meshes.end(), [&](const DriveMesh& m) {
      return (m.gears[0] == g || m.gears[1] == g) && graph_.frame(m);
    });
  }

  // Returns the position of the bell of a ring. The bell is beyond the slots of the ring. If the
  // body is an input, the output or fixed, the bell is on the side on which the shaft of the body
  // ends. Otherwise, the bell is on the side of the other gears of the body.
  double bell_side(std::size_t body, const SlotRange& slots) const {
    return goes_right(body, slots) ? slot_x(slots.last) + kBell : slot_x(slots.first) - kBell;
  }
  bool goes_right(std::size_t body, const SlotRange& slots) const {
    if (is_end(body)) return !leaves_left(body);
    for (std::size_t g = 0; g < graph_.gears.size(); ++g)
      if (graph_.gears[g].body == body && places_.slots[g].first > slots.last) return true;
    for (std::size_t g = 0; g < graph_.gears.size(); ++g)
      if (graph_.gears[g].body == body && places_.slots[g].last < slots.first) return false;
    return true;
  }

  void draw_carriers() {
    for (const PlanetSet& set : drive_.sets) {
      const std::size_t carrier = set.group.carrier;
      SlotRange all{1000, -1};
      double top = 0.0;
      for (const std::size_t rider : set.group.riders) {
        SlotRange own{1000, -1};
        for (std::size_t g = 0; g < graph_.gears.size(); ++g) {
          if (graph_.gears[g].body != rider) continue;
          own = {std::min(own.first, places_.slots[g].first),
                 std::max(own.last, places_.slots[g].last)};
        }
        if (own.last < 0) continue;
        all = {std::min(all.first, own.first), std::max(all.last, own.last)};
      }
      if (all.last < 0) continue;
      const bool right = goes_right(carrier, all);
      const double web = right ? slot_x(all.last) + kWeb : slot_x(all.first) - kWeb;
      const double far = right ? slot_x(all.first) - kHalf - 0.12 : slot_x(all.last) + kHalf + 0.12;
      for (const std::size_t rider : set.group.riders) {
        const double y =
            axis_y(carrier) + scale_ * (places_.axes[rider] - places_.axes[carrier]).norm();
        f_.line({{far, y}, {web, y}}, stick(carrier));
        top = std::max(top, y);
      }
      rises_[carrier].push_back({web, top});
      left_ = std::min(left_, web - 0.2);
      right_ = std::max(right_, web + 0.2);
    }
  }

  struct Shaft {
    std::size_t body;
    double from, to, y;
    bool left = false, right = false;  // true if the shaft ends at this side of the picture
    int level = 0;
  };

  void draw_shafts() {
    for (const auto& rises : rises_)
      for (const Rise& rise : rises) {
        left_ = std::min(left_, rise.x - 0.25);
        right_ = std::max(right_, rise.x + 0.25);
      }
    std::map<long, std::vector<Shaft>> axes;  // by the position of their axis
    for (std::size_t b = 0; b < graph_.bodies.size(); ++b) {
      if (rides(b) || rises_[b].empty()) continue;
      const auto [lo, hi] =
          std::minmax_element(rises_[b].begin(), rises_[b].end(),
                              [](const Rise& p, const Rise& q) { return p.x < q.x; });
      Shaft shaft{b, lo->x, hi->x, axis_y(b)};
      if (is_end(b)) (leaves_left(b) ? shaft.left : shaft.right) = true;
      axes[std::lround(1e6 * shaft.y)].push_back(shaft);
    }
    for (auto& [place, shafts] : axes) draw_axis(shafts);
  }

  // Shafts that overlap get different levels. Of two such shafts, the longer one is drawn inside
  // the other.
  void draw_axis(std::vector<Shaft>& shafts) {
    for (Shaft& s : shafts) {
      if (s.left) s.from = left_;
      if (s.right) s.to = right_;
    }
    std::stable_sort(shafts.begin(), shafts.end(),
                     [](const Shaft& a, const Shaft& b) { return a.to - a.from > b.to - b.from; });
    int most = 0;
    for (std::size_t i = 0; i < shafts.size(); ++i) {
      for (bool clash = true; clash;) {
        clash = false;
        for (std::size_t k = 0; k < i; ++k)
          clash =
              clash || (shafts[k].level == shafts[i].level && shafts[k].from < shafts[i].to + 0.1 &&
                        shafts[k].to > shafts[i].from - 0.1);
        if (clash) ++shafts[i].level;
      }
      most = std::max(most, shafts[i].level);
    }
    const double y = shafts.front().y;
    for (Shaft& s : shafts) {
      const double out = kEnd + kFurther * (most - s.level);
      if (s.left) s.from = left_ - out;
      if (s.right) s.to = right_ + out;
      left_most_ = std::min(left_most_, s.from - 0.3);
      right_most_ = std::max(right_most_, s.to + 0.3);
    }
    const auto from = [](const Shaft& a, const Shaft& b) { return a.from < b.from; };
    const auto to = [](const Shaft& a, const Shaft& b) { return a.to < b.to; };
    f_.line({{std::min_element(shafts.begin(), shafts.end(), from)->from - 0.3, y},
             {std::max_element(shafts.begin(), shafts.end(), to)->to + 0.3, y}},
            "thin dashdot");
    for (const Shaft& s : shafts) {
      const double at = y + kLevel * (s.level + 0.25);
      if (s.to > s.from) f_.line({{s.from, at}, {s.to, at}}, "shaft " + body_style(s.body));
      for (const Rise& rise : rises_[s.body])
        f_.line({{rise.x, at}, {rise.x, rise.to}}, stick(s.body));
      if (s.left || s.right) end_of(s.body, {s.left ? s.from : s.to, at}, s.left, s.level > 0);
    }
    bottom_ = std::min(bottom_, y - 1.0);
    top_ = std::max(top_, y + 0.8);
  }

  // Writes the name of a body above the end of its shaft, and its speed and torque below. If the
  // shaft is hollow, all words are above, because the inner shaft is drawn below.
  void end_of(std::size_t body, const Vec2& at, bool left, bool hollow) {
    if (graph_.is_fixed(body)) ground(at, false);
    const Anchor anchor = left ? Anchor::start : Anchor::end;
    const std::vector<std::string> lines = end_words(drive_, body);
    const double lift = hollow ? -kLine * static_cast<double>(lines.size() - 1) : 0.0;
    f_.text(at, lines.front(), anchor, "panel halo", {0.0, lift - 7.0});
    for (std::size_t i = 1; i < lines.size(); ++i)
      f_.text(at, lines[i], anchor, "tick halo",
              {0.0, (hollow ? lift + 8.0 : 20.0) + kLine * static_cast<double>(i - 1)});
    beyond_.push_back({at.y(), kName - lift});
    if (hollow) {
      top_ = std::max(top_, at.y() + 1.3);
    } else {
      beyond_.push_back({at.y(), -kLine * static_cast<double>(lines.size())});
      bottom_ = std::min(bottom_, at.y() - 1.2);
    }
  }

  // Draws the symbol of a fixed body above a ring or across the end of a shaft.
  void ground(const Vec2& at, bool above) {
    const Vec2 along = above ? Vec2(1, 0) : Vec2(0, 1),
               out = above ? Vec2(0, 1) : Vec2(at.x() < 0 ? -1 : 1, 0);
    const Vec2 base = at + (above ? 0.14 : 0.0) * out;
    if (above) f_.line({at, base}, "ground");
    f_.line({base - 0.3 * along, base + 0.3 * along}, "ground");
    for (int k = -2; k <= 2; ++k) {
      const Vec2 foot = base + 0.13 * k * along;
      f_.line({foot, foot + 0.13 * out + 0.1 * along}, "thin");
    }
  }

  void frame() {
    f_.x = {"", "", std::min(left_, left_most_) - 0.1, std::max(right_, right_most_) + 0.1};
    for (const auto& [y, px] : beyond_) {
      const double end = y + px * (f_.x.hi - f_.x.lo) / drawn_;
      top_ = std::max(top_, end);
      bottom_ = std::min(bottom_, end);
    }
    f_.y = {"", "", bottom_ - 0.1, top_ + 0.1};
    f_.tall = (f_.y.hi - f_.y.lo) / (f_.x.hi - f_.x.lo);
  }

  const Drive& drive_;
  const DriveGraph& graph_;
  const DrivePlaces& places_;
  double drawn_;  // px, width of the plot
  Figure f_;
  double scale_ = 1.0;
  std::vector<double> heights_;           // height of each axis, mm
  bool is_plane_ = true;                  // true if all axes in the housing lie in one plane
  std::vector<double> radii_;             // radius of each gear, in units of the picture
  std::vector<std::vector<Rise>> rises_;  // rises of each body
  std::vector<std::pair<double, double>>
      beyond_;  // px by which some words extend beyond a height, above (> 0) or below it
  double left_ = 0.0, right_ = 0.0, top_ = 0.0, bottom_ = 0.0;
  double left_most_ = 0.0, right_most_ = 0.0;
};

}  // namespace

std::string body_style(std::size_t body) { return fmt::format("b{}", body % 8); }

Figure scheme_figure(const Drive& drive, const DrivePlaces& places, double width) {
  return Scheme(drive, places, width).figure();
}

}  // namespace gearwright
