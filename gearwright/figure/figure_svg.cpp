#include "gearwright/figure/figure_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/figure/contour.hpp"
#include "gearwright/figure/figure_labels.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/figure/ticks.hpp"

namespace gearwright {

namespace {

using Kind = FigureMark::Kind;

constexpr double kEdge = 12.0;  // px of margin around everything
constexpr double kHead = 34.0;  // px above the plot, for the words of the y axis
constexpr double kFoot = 44.0;  // px below the plot, for numbers and words of the x axis
constexpr double kLane = 22.0;
constexpr double kColumn = 24.0,
                 kBesidePlot = 12.0;          // px; a column of names beside the plot is wider than
                                              // the names by kColumn, and the leader lines end at
                                              // the distance kBesidePlot from the plot
constexpr double kLeaderGap = 19.0;           // px between the names of a column
constexpr double kShade = 19.0;               // px, width and greatest step height of a map's key
constexpr double kAcross = 58.0, kUp = 26.0;  // px, least distance between ticks on x, on y

double width_of(std::string_view markup) { return label_width(without_tags(markup)); }

// An axis on the screen, from the value lo at `from` px to the value hi at `to` px.
struct Scale {
  double lo, hi, from, to;
  bool log = false;
  bool plane = false;
  double operator()(double v) const {
    if (std::isinf(v)) return (v > 0) == (hi > lo) ? to : from;
    const double share = log ? std::log(v / lo) / std::log(hi / lo) : (v - lo) / (hi - lo);
    if (plane) return from + share * (to - from);
    // A coordinate is limited to at most one axis length beyond the plot.
    const double length = std::abs(to - from);
    return std::clamp(from + share * (to - from), std::min(from, to) - length,
                      std::max(from, to) + length);
  }
  std::string attribute() const {
    return fmt::format("{:.9g} {:.9g} {} {}{}", lo, hi, pixel(from), pixel(to), log ? " log" : "");
  }
};

Ticks whole_ticks(double lo, double hi, int most) {
  Ticks ticks{{}, 0};
  const int step = std::max(1, static_cast<int>(std::ceil((hi - lo) / most)));
  for (int k = static_cast<int>(std::ceil(lo)); k <= hi; ++k)
    if (k == 1 || k % step == 0) ticks.values.push_back(k);
  return ticks;
}

std::vector<AxisName> names_on(const FigureAxis& axis, double px, double apart) {
  if (!axis.names.empty()) return axis.names;
  const auto [lo, hi] = std::minmax(axis.lo, axis.hi);
  const int most = std::clamp(static_cast<int>(px / apart), 3, 10);
  const Ticks ticks = axis.log     ? log_ticks(lo, hi, apart / 2 * std::log10(hi / lo) / px)
                      : axis.whole ? whole_ticks(lo, hi, most)
                                   : round_ticks(lo, hi, most);
  std::vector<AxisName> names;
  for (const double v : ticks.values) names.push_back({v, tick_text(v, ticks.decimals)});
  return names;
}

std::string words_of(const FigureAxis& axis) {
  return escaped(axis.words) + (axis.symbol.empty() ? "" : " " + symbol_svg(axis.symbol)) +
         escaped(axis.unit.empty() ? "" : ", " + axis.unit);
}

struct Layout {
  double left, right, top, bottom;  // px, of the plot
  double foot, height;              // px: y of the x axis below the lanes; height of the figure
  double note = 20.0;               // px, height of the line of the note
  // px, height of the line of words above each lane; 0 if the words are to the left of the lane
  double lane_words = 0.0;
  std::vector<AxisName> across, up;

  static double column(const Figure& f, Anchor side) {
    double wide = 0.0;
    for (const FigureLeader& l : f.leaders)
      if (l.anchor == side) wide = std::max(wide, kColumn + width_of(l.text()));
    return wide;
  }

  Layout(const Figure& f, double width) {
    if (f.plane) {
      left = column(f, Anchor::end);
      top = 0.0;
      right = width - column(f, Anchor::start);
      foot = bottom = height = f.tall * (right - left);
      return;
    }
    if (f.bare) {
      left = top = kEdge;
      right = width - kEdge;
      foot = bottom = top + f.tall * (right - left);
      height = bottom + kEdge;
      return;
    }
    // Widths of the words to the right and to the left of the plot.
    double beside = 0.0, before = 0.0;
    for (const FigureMark& m : f.marks) {
      if (m.kind != Kind::text || m.anchor != Anchor::start) continue;
      if (std::isinf(m.points[0].x()) && m.points[0].x() > 0 && m.offset.x() > 0)
        beside = std::max(beside, m.offset.x() + width_of(m.text()));
    }
    if (f.shades)
      beside =
          std::max(beside, 22 + kShade + std::max(label_width("000000"), width_of(f.shades->most)));
    for (const FigureLane& lane : f.lanes) before = std::max(before, width_of(lane.words));
    if (before > width / 4) {
      before = 0.0;
      lane_words = 16.0;
    }
    const double tall = f.tall * (width - beside - 100);
    up = names_on(f.y, std::max(120.0, tall), kUp);
    for (const AxisName& n : up) before = std::max(before, width_of(n.markup));
    left = before + kEdge + 8;
    right = width - kEdge - std::max(beside, 10.0);
    // The note gets a line of its own if it does not fit next to the name of the y axis.
    note = width_of(words_of(f.y)) + width_of(f.note) > width - 4 * kEdge ? 38.0 : 20.0;
    top = kHead + (f.note.empty() ? 0.0 : note - 20.0);
    bottom = top + std::max(110.0, f.tall * (right - left));
    foot = bottom + (f.lanes.empty() ? 0.0 : 8 + lane() * static_cast<double>(f.lanes.size()));
    height = foot + kFoot;
    across = names_on(f.x, right - left, kAcross);
  }
  double lane() const { return kLane + lane_words; }
};

class Writer {
 public:
  Writer(const Figure& figure, double width)
      : f_(figure),
        width_(width),
        at_(figure, width),
        x_{f_.x.lo, f_.x.hi, at_.left, at_.right, f_.x.log, f_.plane},
        y_{f_.y.lo, f_.y.hi, at_.bottom, at_.top, f_.y.log, f_.plane},
        svg_(f_.id, width, at_.height, f_.title, f_.description) {}

  std::string str() {
    if (!f_.bare) {
      words();
      grid();
    }
    if (!f_.definitions.empty()) svg_.define(f_.definitions);
    svg_.begin_group(fmt::format(
        "class=\"plot\" data-x=\"{}\" data-y=\"{}\" data-pitch=\"{:.9g}\"{}", x_.attribute(),
        y_.attribute(), f_.pitch, f_.bare && !f_.plane ? " data-bare=\"\"" : ""));
    if (!f_.leaders.empty())
      svg_.begin_clip(at_.left, at_.top, at_.right - at_.left, at_.bottom - at_.top);
    int frame = -1, group = -1;
    const auto close = [&] {
      if (frame >= 0 || group >= 0) svg_.end_group();
      origin_ = Vec2::Zero();
    };
    for (const FigureMark& m : f_.marks) {
      if (m.frame != frame || m.group != group) {
        close();
        if (m.frame >= 0) begin_frame(m.frame);
        if (m.group >= 0) begin_turning(f_.groups[static_cast<std::size_t>(m.group)]);
      }
      frame = m.frame;
      group = m.group;
      mark(m);
    }
    close();
    if (f_.slide) slide(*f_.slide);
    if (!f_.leaders.empty()) svg_.end_group();
    for (const Anchor side : {Anchor::start, Anchor::end}) leaders(side);
    labels();
    svg_.end_group();
    for (std::size_t i = 0; i < f_.lanes.size(); ++i)
      lane(f_.lanes[i], at_.bottom + 8 + at_.lane() * static_cast<double>(i));
    if (f_.shades) shades(*f_.shades);
    return svg_.str();
  }

 private:
  Vec2 px(const Vec2& p) const { return Vec2(x_(p.x()), y_(p.y())) - origin_; }
  double per_unit() const { return std::abs((x_.to - x_.from) / (x_.hi - x_.lo)); }  // px per x

  void begin_frame(int frame) {
    svg_.begin_group(fmt::format("data-frame=\"{}\" data-frames=\"{}\"{}", frame, f_.frames,
                                 frame == 0 ? "" : " visibility=\"hidden\""));
  }

  // Begins a group of marks whose positions are relative to the point about which they turn.
  void begin_turning(const FigureGroup& group) {
    const Vec2 about = px(group.about);
    svg_.begin_group(fmt::format("transform=\"translate({} {})\" data-turn=\"{:.12g}\"",
                                 pixel(about.x()), pixel(about.y()), group.per_pitch));
    origin_ = about;
  }

  void leaders(Anchor side) {
    std::vector<const FigureLeader*> ones;
    std::vector<double> wanted;
    for (const FigureLeader& l : f_.leaders) {
      if (l.anchor != side) continue;
      ones.push_back(&l);
      wanted.push_back(px(l.at).y());
    }
    const std::vector<double> placed = spread(wanted, kLeaderGap, 12.0, at_.height - 10.0);
    const double out = side == Anchor::start ? 1.0 : -1.0;
    const double x = (side == Anchor::start ? at_.right : at_.left) + out * kBesidePlot;
    for (std::size_t i = 0; i < ones.size(); ++i) {
      const Vec2 from = px(ones[i]->at);
      svg_.polyline({from, {x - 8 * out, placed[i]}, {x, placed[i]}}, "leader");
      svg_.text({x, placed[i]}, ones[i]->text(), side, ones[i]->style, {3 * out, 4.0});
    }
  }

  void words() {
    svg_.text({kEdge, 20}, words_of(f_.y), Anchor::start, "panel");
    if (!f_.note.empty()) svg_.text({at_.right, at_.note}, escaped(f_.note), Anchor::end, "panel");
    // The label of the x axis can be wider than the plot, but the border of the picture must not
    // cut it off.
    const double half = std::min(width_, width_of(words_of(f_.x))) / 2;
    const double middle = std::clamp((at_.left + at_.right) / 2, half, width_ - half);
    svg_.text({middle, at_.foot + 36}, words_of(f_.x), Anchor::middle, "tick");
  }

  void grid() {
    for (const auto& [v, markup] : at_.up) {
      svg_.line({at_.left, y_(v)}, {at_.right, y_(v)}, v == 0.0 ? "axis" : "grid");
      svg_.text({at_.left - 7, y_(v) + 4}, markup, Anchor::end, "tick");
    }
    for (const auto& [v, markup] : at_.across) {
      svg_.line({x_(v), at_.top}, {x_(v), at_.foot + 4}, "grid");
      svg_.text({x_(v), at_.foot + 17}, markup, Anchor::middle, "tick");
    }
    svg_.line({at_.left, at_.foot}, {at_.right, at_.foot}, "axis");
  }

  std::string clip() {
    if (clip_.empty()) {
      clip_ = f_.id + "-plot";
      svg_.define_clip(clip_, at_.left - 1, at_.top - 1, at_.right - at_.left + 2,
                       at_.bottom - at_.top + 2);
    }
    return fmt::format("clip-path=\"url(#{})\"", clip_);
  }

  void mark(const FigureMark& m) {
    const std::string name = m.words.empty() || m.kind == Kind::text ? "" : escaped(m.words);
    switch (m.kind) {
      case Kind::line:
      case Kind::area: {
        std::string d;
        bool on = false;
        const char* const end = m.kind == Kind::area ? "Z" : "";
        for (const Vec2& p : m.points) {
          if (is_new_piece(p)) {
            if (on) d += end;
            on = false;
            continue;
          }
          const Vec2 at = px(p);
          d += (on ? "L" : "M") + pixel(at.x()) + " " + pixel(at.y());
          on = true;
        }
        if (d.empty()) break;
        const std::string inside = f_.plane ? "" : clip();
        const char* const shown = m.kind == Kind::area ? "value" : "name";
        svg_.path(d + end, m.style,
                  inside + (name.empty() ? "" : fmt::format(" data-{}=\"{}\"", shown, name)));
        if (m.head) head(m);
        break;
      }
      case Kind::bar: {
        const Vec2 a = px(m.points[0]), b = px(m.points[1]);
        const Vec2 lo = a.cwiseMin(b), size = (a - b).cwiseAbs();
        svg_.rect(lo.x(), lo.y(), size.x(), size.y(), m.style, name);
        break;
      }
      case Kind::dot: svg_.dot(px(m.points[0]), m.radius, m.style, m.words); break;
      case Kind::text: svg_.text(px(m.points[0]), m.text(), m.anchor, m.style, m.offset); break;
      case Kind::circle: svg_.circle(px(m.points[0]), m.radius * per_unit(), m.style); break;
      case Kind::cross: svg_.cross(px(m.points[0]), 5.0, m.style); break;
      case Kind::shape: {
        std::string turning = fmt::format("data-gear=\"{}\"", m.gear);
        if (m.per_pitch != 0.0) turning += fmt::format(" data-turn=\"{:.12g}\"", m.per_pitch);
        if (m.points.size() > 1) {
          const Vec2 moved = px(m.points[1]) - px(m.points[0]);
          turning +=
              fmt::format(" data-travel=\"{} {}\"", fixed(moved.x(), 6), fixed(moved.y(), 6));
        }
        svg_.use(m.words, px(m.points[0]), per_unit() * m.radius, m.turned, m.style, turning);
        break;
      }
    }
  }

  void head(const FigureMark& m) {
    const Vec2 tip = px(m.points.back()), from = px(m.points[m.points.size() - 2]);
    const Vec2 along = (tip - from).normalized(), across = 4.0 * Vec2(-along.y(), along.x());
    const Vec2 back = tip - 9.0 * along;
    const bool action = m.style.find("action") != std::string::npos;
    svg_.polygon({tip, back + across, back - across},
                 m.gear >= 0 ? std::string("head ") + kInk[static_cast<std::size_t>(m.gear)]
                 : action    ? "mark action-dot"
                             : "mark");
  }

  void slide(const FigureSlide& s) {
    const Vec2 step = px(s.at + s.step) - px(s.at);
    for (int k = static_cast<int>(std::floor(s.from)); k <= static_cast<int>(std::floor(s.to));
         ++k) {
      svg_.begin_group(
          fmt::format("visibility=\"hidden\" data-tooth=\"{}\" data-from=\"{:.6f}\" "
                      "data-to=\"{:.6f}\" data-dx=\"{}\" data-dy=\"{}\"",
                      k, s.from, s.to, pixel(step.x()), pixel(step.y())));
      svg_.dot(px(s.at), 5.0, s.style);
      svg_.end_group();
    }
  }

  void labels() {
    const auto place = [this](const Vec2& p) { return px(p); };
    write_labels(svg_, f_, {{at_.left, at_.top, at_.right, at_.bottom}, place, per_unit()});
  }

  void lane(const FigureLane& lane, double y) {
    if (at_.lane_words > 0.0)
      svg_.text({at_.left, y + 12}, escaped(lane.words), Anchor::start, "tick halo");
    else
      svg_.text({at_.left - 8, y + 14}, escaped(lane.words), Anchor::end, "tick");
    y += at_.lane_words;
    svg_.line({at_.left, y + (kLane - 4) / 2}, {at_.right, y + (kLane - 4) / 2}, "grid");
    for (const FigureLane::Block& block : lane.blocks) {
      const double from = std::max(x_(block.from), at_.left),
                   to = std::min(x_(block.to), at_.right);
      if (to <= from) continue;
      svg_.rect(from, y, to - from, kLane - 4, block.style);
      if (to - from > 8 + width_of(block.words) && !block.words.empty())
        svg_.text({(from + to) / 2, y + 14}, escaped(block.words), Anchor::middle, "inzone");
    }
  }

  void shades(const FigureShades& key) {
    const std::size_t n = key.levels.size() + 1;
    const double x = at_.right + 14;
    const double tall = std::min(kShade, (at_.bottom - at_.top - 40) / static_cast<double>(n));
    double y = at_.top + 4;
    svg_.text({x + kShade + 7, y + 8}, escaped(key.most), Anchor::start, "tick");
    for (std::size_t i = n; i-- > 0; y += tall) {
      svg_.rect(x, y, kShade, tall, shade_style(i, n));
      if (i > 0 && (tall > 15 || (i % 2 == 0 && i + 1 < n)))
        svg_.text({x + kShade + 7, y + tall + 4}, fmt::format("{:g}", key.levels[i - 1]),
                  Anchor::start, "tick");
    }
    if (key.nothing.empty()) return;
    svg_.rect(x, y + 12, kShade, kShade, "zone none");
    svg_.text({x, y + 26 + kShade}, escaped(key.nothing), Anchor::start, "tick");
  }

  const Figure& f_;
  double width_;
  Layout at_;
  Scale x_, y_;
  Svg svg_;
  std::string clip_;
  Vec2 origin_ = Vec2::Zero();  // px, point from which the marks of the current group are measured
};

}  // namespace

std::string figure_svg(const Figure& figure, double width) {
  GW_EXPECTS(width >= 240.0);
  for (const FigureAxis* axis : {&figure.x, &figure.y})
    GW_EXPECTS(std::isfinite(axis->lo) && std::isfinite(axis->hi) && axis->lo != axis->hi &&
               (!axis->log || axis->lo > 0.0));
  return Writer(figure, width).str();
}

std::string figure_html(const Figure& figure, double width, std::string_view attributes,
                        std::string_view control) {
  std::string caption = fmt::format("<strong>{}</strong>{}", escaped(figure.title), figure.caption);
  if (const auto it = std::find_if(figure.leaders.begin(), figure.leaders.end(),
                                   [](const FigureLeader& l) { return l.length.has_value(); });
      it != figure.leaders.end())
    caption += fmt::format(" Lengths have the unit {}.",
                           it->length->unit == "in" ? "inch" : it->length->unit);
  for (const FigureKey& key : figure.keys)
    caption += " " + caption_key(key.style, escaped(key.words));
  return captioned(figure_svg(figure, width) + std::string(control), caption, attributes);
}

std::string html_of(const std::optional<Figure>& figure) {
  return figure ? figure_html(*figure) : std::string();
}

}  // namespace gearwright
