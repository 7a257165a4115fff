// Converts the short forms of a drive into the graph of the drive. The short forms are planetary
// sets and trains of stages.
//
// A set has a sun, planets and a ring, or other members of the list below. A stage of a train is a
// pair of gears or a set.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/drive/drive.hpp"

namespace gearwright {

/// The gears of a set, in the order in which its meshes are formed.
enum class SetMember { sun, sun2, idler, planet, planet2, ring, ring2 };
inline constexpr std::size_t kSetMembers = 7;
const char* to_string(SetMember member);
constexpr bool is_ring(SetMember member) {
  return member == SetMember::ring || member == SetMember::ring2;
}
/// Returns z, which is < 0 for a ring, if the number of teeth has either sign.
inline int signed_teeth(SetMember member, int teeth) {
  return is_ring(member) ? -std::abs(teeth) : teeth;
}
/// Returns the names of all members, in the order of SetMember.
std::vector<std::string> set_member_names();

/// One number for all gears of a set, and numbers for single gears. The numbers for single gears
/// take precedence.
struct PerMember {
  std::optional<double> all;
  std::array<std::optional<double>, kSetMembers> each{};

  static std::vector<std::string> names() { return set_member_names(); }
  void set(const std::string& member, double number);
  std::optional<double> of(SetMember member) const {
    const auto& own = each[static_cast<std::size_t>(member)];
    return own ? own : all;
  }
  /// True if a gear has a number of its own.
  bool any() const {
    return std::any_of(each.begin(), each.end(), [](const auto& own) { return own.has_value(); });
  }
};

/// One number for all meshes, and numbers for single meshes by name. The numbers for single meshes
/// take precedence.
struct PerMesh {
  std::optional<double> all;
  std::vector<std::pair<std::string, double>> each{};

  /// Returns the names of the meshes of sets, each formed by the names of the two members.
  static std::vector<std::string> names();
  void set(const std::string& mesh, double number) { each.emplace_back(mesh, number); }
  std::optional<double> of(const std::string& mesh) const;
};

struct PlanetarySpec {
  /// z of each gear, absent if there is no such gear. The sign of a ring's number is ignored.
  std::array<std::optional<int>, kSetMembers> teeth{};
  int planets = 1;
  std::optional<double> normal_module;  ///< m_n  mm; if absent, no geometry is computed
  Angle normal_pressure_angle = Angle::degrees(20);
  PerMember profile_shift;  ///< x
  PerMember helix_deg;      ///< β; by default computed from β of the sun
  PerMember face_width;     ///< b  mm
  PerMember allowance;      ///< E_sn  mm
  std::string series;       ///< series of DIN 3967 for gears without an allowance; nominal teeth if
                            ///< empty
  PerMember tip_diameter;   ///< d_a  mm
  PerMember bore;           ///< mm, diameter of the bore, or outside diameter of the rim of a ring;
                            ///< `all` does not apply to rings
  PerMesh efficiency;
  PerMesh backlash;                               ///< j_n  mm
  bool backlash_is_mean = false;                  ///< true if `backlash` is the mean of a band
  PerMesh center_distance;                        ///< a  mm; `all` applies to the first mesh only
  double friction = 0.05;                         ///< μ
  std::optional<std::vector<std::string>> fixed;  ///< by default the ring, else ring2, else the sun
  std::vector<std::string> inputs;                ///< if empty, the sun, else sun2, else the
                                                  ///< carrier
  std::string output;                             ///< if empty, the carrier or, if it is fixed or
                                                  ///< an input, another central body
  std::vector<double> speeds_rpm;
  std::optional<double> torque_Nm;
  Spacing spacing = Spacing::nearest;
  std::vector<double> positions_deg;
  IdlerSide idler_side = IdlerSide::counter_clockwise;

  std::optional<int>& z(SetMember member) { return teeth[static_cast<std::size_t>(member)]; }
  const std::optional<int>& z(SetMember member) const {
    return teeth[static_cast<std::size_t>(member)];
  }
};

struct PairTeeth {
  double normal_module;  ///< m_n  mm
  Angle normal_pressure_angle = Angle::degrees(20);
  double helix_deg = 0.0;                            ///< β of the first gear
  std::optional<double> face_width{};                ///< b  mm; 10 m_n if absent
  std::array<std::optional<double>, 2> allowance{};  ///< E_sn  mm; 0 if absent
};

/// A mesh of a set and its name, which is formed by the names of the two members.
struct SetMesh {
  std::string name;
  SetMember first, second;
};
/// Returns the meshes of a set, in the order in which the graph has them.
std::vector<SetMesh> meshes_of(const PlanetarySpec& spec);

/// Two gears on fixed axes. If the second gear is a ring, its number of teeth is negative.
struct PairStage {
  std::array<int, 2> teeth{};
  std::array<std::optional<CylindricalSpec>, 2> specs;
  std::array<std::optional<double>, 2> shifts;
  PairModifications modifications{};
  std::array<std::optional<Bore>, 2> bores{};
  std::array<std::optional<DoubleHelical>, 2> double_helical{};
  std::optional<double> efficiency, center_distance, backlash;
  bool backlash_is_mean = false;  ///< true if `backlash` is the mean of a band
  /// Direction from the axis of the first gear to the axis of the second gear. The default is the
  /// direction of the stage before.
  std::optional<Angle> direction{};
  /// True if the second gear has the axis of the input of the train. This determines the direction.
  bool coaxial = false;

  /// Gives both gears teeth. The hand of the second gear is chosen to fit the first gear.
  void set_teeth(const PairTeeth& given);
  /// If a gear has the allowance 0, sets its allowance to the mean allowance of this series of DIN
  /// 3967. If `series` is empty, no allowance changes.
  void set_allowances(const std::string& series);
};

struct StageSpec {
  std::optional<PlanetarySpec> planetary;  ///< absent for a pair
  PairStage pair;
  std::vector<double> speeds_rpm{};   ///< speeds of the input of the pair
  std::optional<double> torque_Nm{};  ///< on the input of the pair
  double friction = 0.05;             ///< μ of the pair
};

/// Returns the mean of E_sns and E_sni, mm, of this series of DIN 3967 for a reference diameter.
/// Returns 0 without a series, and for a diameter that the series does not contain.
double mean_allowance(const std::string& series, double reference_diameter);

/// Returns the index of the body with this name.
///
/// Errors    `field` if there is no such body; the message lists the names of all bodies
Result<std::size_t> find_body(const DriveGraph& graph, const std::string& name,
                              const std::string& field);

/// Returns the graph of a planetary set. Its bodies have names such as sun, planet, ring and
/// carrier. Its meshes have names such as sun_planet and planet_ring.
///
/// Errors    `planetary.…` if a member is missing or has an impossible number of teeth, if the set
///           has no mesh, if there is less than one planet, or if a backlash is given without a
///           module; `drive.fixed`, `drive.input` or `drive.output` if there is no such body
Result<DriveGraph> graph_of(const PlanetarySpec& spec);

/// Returns the whole train, and its stages as separate drives. The names of bodies are s1_sun,
/// s2_gear1 and so on. If a body is the output of one stage and the input of the next one, its name
/// comes from the first of the two stages.
///
/// Formula   if the last stage is coaxial, its direction leads back to the axis of the input. If
///           the stage before it has no direction, a triangle gives this direction. The corners of
///           the triangle are the two axes of that stage and the axis of the input. The triangle
///           lies to the left of the line from the axis of the input to the first axis of that
///           stage
/// Errors    as graph_of(); `drive.input` if a later stage has several inputs; `drive.speed` and
///           `drive.torque` if they are given for a later stage; `stage[N].angle` if the centre
///           distances are unknown or do not permit a coaxial output; as check_graph() if the
///           output is coaxial
Result<DriveInput> train_of(const std::vector<StageSpec>& stages);

}  // namespace gearwright
