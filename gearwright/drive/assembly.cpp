#include "gearwright/drive/assembly.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/drive/drive_geometry.hpp"

namespace gearwright {

namespace {

/// Greatest allowed difference, degrees, between an angle that the user gives and the nearest angle
/// at which a planet can be assembled. Drawings give angles with two decimals.
constexpr double kSamePlace = 0.01;
/// Greatest change of a number of teeth that is tried for a proposal.
constexpr int kMostTeethChanged = 12;

using Row = std::vector<long long>;  // row of [A | b] for one mesh

// Returns the row of [A | b] for each mesh. The rotation χ of a planet body has the coefficient z
// of its gear, and b is −z of the central gear.
std::vector<Row> mesh_conditions(const DriveGraph& graph, const PlanetGroup& group) {
  std::vector<Row> rows;
  for (const std::size_t m : group.meshes) {
    Row row(group.riders.size() + 1, 0);
    for (const int side : {0, 1}) {
      const DriveGear& gear = graph.gear(graph.meshes[m], side);
      const auto rider = std::find(group.riders.begin(), group.riders.end(), gear.body);
      if (rider == group.riders.end()) {
        row.back() -= gear.factor();
      } else {
        row[static_cast<std::size_t>(rider - group.riders.begin())] += gear.factor();
      }
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

// Returns N* = gcd |y·b|, where the rows y form a saturated basis of y·A = 0. Euclid's algorithm
// transforms [A | b] by unimodular steps so that A has echelon form. In every row whose part in A
// is then 0, the last column is a value y·b.
long long places_of(std::vector<Row> rows, std::size_t riders) {
  std::size_t top = 0;
  for (std::size_t column = 0; column < riders; ++column) {
    for (;;) {
      std::size_t least = rows.size();
      std::size_t entries = 0;
      for (std::size_t r = top; r < rows.size(); ++r) {
        if (rows[r][column] == 0) continue;
        ++entries;
        if (least == rows.size() || std::abs(rows[r][column]) < std::abs(rows[least][column]))
          least = r;
      }
      if (entries == 0) break;
      std::swap(rows[top], rows[least]);
      if (entries == 1) {
        ++top;
        break;
      }
      for (std::size_t r = top + 1; r < rows.size(); ++r) {
        const long long times = rows[r][column] / rows[top][column];
        for (std::size_t c = 0; c < rows[r].size(); ++c) rows[r][c] -= times * rows[top][c];
      }
    }
  }
  long long places = 0;
  for (std::size_t r = top; r < rows.size(); ++r) places = std::gcd(places, rows[r].back());
  return places;
}

// Lists numbers of teeth of single gears with which an equal pitch is possible, for example "ring
// 68 or 72, sun 18". For each gear, only the smallest change is listed. If the same change is
// possible upwards and downwards, both numbers are listed. Changes above kMostTeethChanged are not
// tried.
std::string teeth_that_assemble(const DriveGraph& graph, const PlanetGroup& group) {
  std::vector<std::size_t> gears;
  for (const std::size_t m : group.meshes)
    for (const std::size_t g : graph.meshes[m].gears) add_once(gears, g);
  std::vector<std::string> proposals;
  for (const std::size_t g : gears) {
    for (int change = 1; change <= kMostTeethChanged; ++change) {
      std::vector<std::string> found;
      for (const int sign : {-1, 1}) {
        DriveGraph other = graph;
        int& teeth = other.gears[g].teeth;
        teeth += graph.gears[g].is_ring() ? -sign * change : sign * change;
        if (std::abs(teeth) < 5 || check_graph(other)) continue;
        if (assembly_places(other, group) % group.count == 0)
          found.push_back(std::to_string(std::abs(teeth)));
      }
      if (found.empty()) continue;
      proposals.push_back(fmt::format("{} {}", graph.gears[g].name, fmt::join(found, " or ")));
      break;
    }
  }
  return fmt::format("{}", fmt::join(proposals, ", "));
}

// Lists the nearest numbers of planets below and above `count` that can be equally spaced. They are
// at most `most`.
std::string counts_that_assemble(long long places, long long count, long long most) {
  std::vector<std::string> found;
  for (long long n = std::min(count - 1, most); n >= 1 && found.empty(); --n)
    if (places % n == 0) found.push_back(std::to_string(n));
  for (long long n = count + 1; n <= std::min({places, 2 * count, most}); ++n) {
    if (places % n != 0) continue;
    found.push_back(std::to_string(n));
    break;
  }
  return fmt::format("{}", fmt::join(found, " or "));
}

Result<std::vector<Rational>> given_places(const std::vector<double>& degrees, long long places,
                                           int count) {
  if (degrees.size() != static_cast<std::size_t>(count))
    return Error{"drive.positions", fmt::format("{} angles", degrees.size()),
                 fmt::format("must contain one angle for each of the {} planets", count)};
  std::vector<Rational> turns;
  for (const double given : degrees) {
    const double u = (given - degrees.front()) / 360.0;
    // If any angle is possible, the angles are rounded to a millionth of a degree.
    const long long grid = places > 0 ? places : 360'000'000;
    const double n = std::round(u * static_cast<double>(grid));
    const double off = std::abs(u - n / static_cast<double>(grid)) * 360.0;
    if (off > kSamePlace)
      return refused(
          "drive.positions", given,
          fmt::format("a planet cannot be assembled at this position; the possible positions are "
                      "multiples of {}°, and the nearest of them is {}°",
                      format_number(360.0 / static_cast<double>(places)),
                      format_number(degrees.front() + 360.0 * n / static_cast<double>(grid))));
    turns.push_back(Rational::of(static_cast<long long>(n), grid).frac());
  }
  return turns;
}

// True if the turns, which are in [0, 1), are the multiples of 1/N in any order.
bool equal_pitch(const std::vector<Rational>& turns) {
  std::vector<char> taken(turns.size(), 0);
  for (const Rational& u : turns) {
    const Rational pitches = u * Rational(static_cast<long long>(turns.size()));
    if (!pitches.whole()) return false;
    char& here = taken[static_cast<std::size_t>(*pitches.numerator())];
    if (here) return false;
    here = 1;
  }
  return true;
}

// Returns the clocking of each copy of a stepped planet. Each of its two gears must mesh with
// exactly one central gear. Returns none for any other planet.
std::optional<std::vector<Rational>> clocking(const DriveGraph& graph, const PlanetGroup& group,
                                              const std::vector<Rational>& turns) {
  if (group.riders.size() != 1 || group.meshes.size() != 2) return std::nullopt;
  std::array<const DriveGear*, 2> own{}, central{};
  for (const std::size_t k : {0, 1}) {
    const DriveMesh& mesh = graph.meshes[group.meshes[k]];
    const int rider = graph.gear(mesh, 0).body == group.riders[0] ? 0 : 1;
    own[k] = &graph.gear(mesh, rider);
    central[k] = &graph.gear(mesh, 1 - rider);
  }
  if (own[0] == own[1]) return std::nullopt;
  const long long z1 = own[0]->teeth;
  const long long z2 = own[1]->teeth;
  const Rational step = Rational::of(1, std::lcm(z1, z2));
  std::vector<Rational> list;
  for (const Rational& u : turns) {
    // The clocking is −u (z_s/z_p1 − z_r/z_p2), with z_r < 0 for a ring. Each central gear may be a
    // sun or a ring. [T13.14]
    const Rational angle =
        u * (Rational::of(central[1]->factor(), z2) - Rational::of(central[0]->factor(), z1));
    list.push_back((angle / step).frac() * step);
  }
  return list;
}

}  // namespace

long long assembly_places(const DriveGraph& graph, const PlanetGroup& group) {
  return places_of(mesh_conditions(graph, group), group.riders.size());
}

Result<Assembly> assemble(const DriveGraph& graph, const PlanetGroup& group,
                          const DriveGeometry* geometry) {
  Assembly made;
  made.places = assembly_places(graph, group);
  const long long n = group.count;
  for (const std::size_t rider : group.riders) {
    if (graph.bodies[rider].positions_deg.empty()) continue;
    auto turns = given_places(graph.bodies[rider].positions_deg, made.places, group.count);
    if (!turns) return turns.error();
    made.turns = std::move(turns).take();
    made.equal = equal_pitch(made.turns);
    return made;
  }
  const Spacing spacing = graph.bodies[group.riders.front()].spacing.value_or(graph.spacing);
  const bool divides = made.places % n == 0;
  const auto at_equal_pitch = [&] {
    for (long long i = 0; i < n; ++i) made.turns.push_back(Rational::of(i, n));
    made.equal = true;
  };
  if (spacing == Spacing::equal_clocked) {
    at_equal_pitch();
    if (auto list = clocking(graph, group, made.turns)) {
      made.clocking = std::move(*list);
      return made;
    }
    if (!divides)
      return Error{"drive.spacing", "equal_clocked",
                   "is possible only for a stepped planet with two gears, each of which meshes "
                   "with one central gear; use \"nearest\""};
    return made;
  }
  if (divides) {
    at_equal_pitch();
    if (spacing != Spacing::opposite || n % 2 == 0) return made;
  }
  if (spacing == Spacing::equal) {
    const std::string others = teeth_that_assemble(graph, group);
    const auto most = geometry ? most_copies(graph, group, *geometry) : std::nullopt;
    return Error{
        "drive.spacing", "equal",
        fmt::format("{} planets cannot be assembled at equal pitch, because {} is not a divisor of "
                    "{}, the number of possible positions per revolution. One of these changes "
                    "would help: {}{} planets; spacing \"nearest\"",
                    n, n, made.places, others.empty() ? "" : others + "; ",
                    counts_that_assemble(made.places, n, most.value_or(2 * n)))};
  }
  if (spacing == Spacing::opposite && (n % 2 != 0 || made.places % 2 != 0))
    return Error{"drive.spacing", "opposite",
                 fmt::format("needs an even number of planets and an even number of possible "
                             "positions per revolution, but these numbers are {} and {}. Use "
                             "\"nearest\"",
                             n, made.places)};
  for (long long i = 0; i < n; ++i)
    made.turns.push_back(Rational::of((2 * i * made.places + n) / (2 * n), made.places));
  return made;
}

}  // namespace gearwright
