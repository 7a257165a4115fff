#include "gearwright/scatter/linear_family.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "gearwright/base/parallel.hpp"
#include "gearwright/load/gap_places.hpp"
#include "gearwright/scatter/sample_points.hpp"

namespace gearwright {

namespace {

constexpr int kHeights = 33;                                         // over the face
constexpr double kBeyond = std::numeric_limits<double>::infinity();  // exceeds any value

// Returns heights over the face of gear 1 or, if the axes are parallel, over the common face.
std::vector<double> heights_of(const ContactPair& pair, bool crossed) {
  double lo = -kBeyond;
  double hi = kBeyond;
  for (const int which : {1, 2}) {
    if (which == 2 && crossed) continue;
    double least = kBeyond;
    double most = -kBeyond;
    for (const FlankPatch& p : pair.patches(which)) {
      least = std::min(least, p.z_lo);
      most = std::max(most, p.z_hi);
    }
    const double shift = which == 2 ? pair.mount().shift.r.z() : 0.0;
    lo = std::max(lo, least - shift);
    hi = std::min(hi, most - shift);
  }
  std::vector<double> heights;
  for (int i = 0; i < kHeights; ++i) heights.push_back(lo + (hi - lo) * i / (kHeights - 1));
  return heights;
}

// Returns the maximum of a curve through equidistant values. If the greatest value is not at an
// end, the result is the maximum of the parabola through this value and the two neighbouring
// values.
double greatest_of(const std::vector<double>& v) {
  const auto at = static_cast<std::size_t>(std::max_element(v.begin(), v.end()) - v.begin());
  if (at == 0 || at + 1 == v.size()) return v[at];
  const double bend = v[at - 1] - 2 * v[at] + v[at + 1];
  const double slope = v[at + 1] - v[at - 1];
  return bend < 0.0 ? v[at] - slope * slope / (8 * bend) : v[at];
}

// TE of each tooth pair at a position.
using Branches = std::map<int, double>;

Branches::const_iterator leader(const Branches& all) {
  return std::max_element(all.begin(), all.end(),
                          [](const auto& x, const auto& y) { return x.second < y.second; });
}

// Returns the least TE between two positions if every branch is linear between them. TE is least at
// one of the positions, or where the branches that lead at the two positions cross.
double least_between(const Branches& a, const Branches& b) {
  const auto first = leader(a), second = leader(b);
  const double least = std::min(first->second, second->second);
  const auto falls = b.find(first->first), rises = a.find(second->first);
  if (first->first == second->first || falls == b.end() || rises == a.end()) return least;
  const double ahead = first->second - rises->second;
  const double part = ahead / (ahead + second->second - falls->second);
  return std::min(least, first->second + part * (falls->second - first->second));
}

// True if the field of a member differs from the field of the nominal pair. Topographies are always
// equal and need no comparison.
bool changed(const RemovalField& member, const RemovalField& drawn) {
  return member.waves() != drawn.waves() || member.amounts() != drawn.amounts();
}

}  // namespace

// The differences of a member from the nominal pair.
struct LinearFamily::Member {
  std::array<double, 6> error;                   // member minus nominal; order of kErrorKinds
  std::array<const RemovalField*, 2> removal{};  // field of each gear; null if it is nominal
};

std::optional<LinearFamily> LinearFamily::of(const ContactSetup& drawn,
                                             const MemberRequest& request) {
  GW_EXPECTS(request.positions >= 2);
  LinearFamily family(drawn.with_fields({true, true}));
  const ContactErrors& errors = family.setup_.place().errors;
  const ContactPair pair = family.setup_.pair(errors, request.gear2_drives);
  for (const int which : {1, 2})
    family.left_[which - 1] =
        pair.patches(which).front().removal == family.setup_.removal(which, true);
  Deviation none;
  none.errors = errors;
  const auto exact = continuous_peak_to_peak(family.setup_, none, request).value;
  if (!exact) return std::nullopt;
  const bool crossed = family.setup_.place().axis_angle != Angle();
  GapSearch search(pair, heights_of(pair, crossed));
  for (int i = 0; i <= request.positions; ++i)
    family.add_position(search, pair.pitch() * (static_cast<double>(i) / request.positions - 0.5));
  family.correction_ = *exact - family.peak_to_peak(none);
  return family;
}

void LinearFamily::add_position(GapSearch& search, double phi) {
  std::vector<Row>& rows = positions_.emplace_back();
  for (const PairPlaces& p : search.places(phi)) {
    Row row{p.pair, {}};
    bool open = false;
    for (std::size_t i = 0; i < p.at.size(); ++i) {
      if (!p.at[i]) {
        open = false;
        continue;
      }
      if (!open) row.runs.emplace_back();
      open = true;
      Place& place = row.runs.back().emplace_back(Place{p.at[i]->te, {}, {}, {}});
      for (const ErrorKind kind : kErrorKinds)
        place.by_error[static_cast<std::size_t>(kind)] = search.slope(p, i, {kind});
      for (const int gear : {1, 2}) {
        const std::size_t g = gear - 1;
        const RemovalTurn& t = place.removal[g] = search.turn(p, i, gear);
        place.drawn[g] = setup_.removal(gear, left_[g])->at(t.u, t.z, t.piece).c;
      }
    }
    rows.push_back(std::move(row));
  }
}

double LinearFamily::greatest(const Row& row, const Member& m) const {
  double most = -kBeyond;
  std::vector<double> values;
  for (const std::vector<Place>& run : row.runs) {
    values.clear();
    for (const Place& place : run) {
      double te = place.te;
      for (std::size_t i = 0; i < m.error.size(); ++i) te += place.by_error[i] * m.error[i];
      for (std::size_t g = 0; g < 2; ++g) {
        const RemovalTurn& t = place.removal[g];
        if (m.removal[g]) te += t.te * (m.removal[g]->at(t.u, t.z, t.piece).c - place.drawn[g]);
      }
      values.push_back(te);
    }
    most = std::max(most, greatest_of(values));
  }
  return most;
}

double LinearFamily::peak_to_peak(const Deviation& deviation) const {
  const ContactErrors &e = deviation.errors, &d = setup_.place().errors;
  const auto slope = [&](int which) {
    const std::size_t g = which - 1;
    const Gear& gear = setup_.gear(which);
    return (e.helix_twist[g] - d.helix_twist[g]) * gear.reference_diameter / 2 *
           gear.spec.face_width;
  };
  Member member{{e.center_distance - d.center_distance, (e.crossing - d.crossing).rad(),
                 (e.intersecting - d.intersecting).rad(), e.axial - d.axial, slope(1), slope(2)},
                {}};
  const MemberSetup own(setup_, deviation);
  for (const int which : {1, 2}) {
    const std::size_t g = which - 1;
    const RemovalField* field = (*own).removal(which, left_[g]);
    if (field && changed(*field, *setup_.removal(which, left_[g]))) member.removal[g] = field;
  }
  std::vector<Branches> positions;
  std::vector<double> tops;
  for (const std::vector<Row>& rows : positions_) {
    Branches& branches = positions.emplace_back();
    double top = -kBeyond;
    for (const Row& row : rows) {
      const double te = greatest(row, member);
      branches.emplace(row.pair, te);
      top = std::max(top, te);
    }
    tops.push_back(top);
  }
  double least = kBeyond;
  for (std::size_t i = 1; i < positions.size(); ++i)
    least = std::min(least, least_between(positions[i - 1], positions[i]));
  return std::max(0.0, greatest_of(tops) - least + correction_);
}

Result<std::vector<double>> linear_spans(const ContactSetup& setup, const ScatterTask& task,
                                         int count) {
  if (auto error = check_family(setup, task.tolerances)) return *error;
  const auto family = LinearFamily::of(setup, task.member);
  if (!family) return nothing_touches(setup);
  const auto places = SamplePoints(task).first(0, count);
  std::vector<double> spans(places.size());
  parallel_for(
      places.size(),
      [&](std::size_t i) {
        spans[i] = family->peak_to_peak(deviation_at(setup, task.tolerances, places[i]));
      },
      task.threads);
  return spans;
}

}  // namespace gearwright
