#include "gearwright/base/subject.hpp"

namespace gearwright {

namespace {

struct NamedMember {
  std::string_view name;
  GearMember member;
};
constexpr NamedMember kMembers[] = {{"", GearMember::none},
                                    {"teeth", GearMember::teeth},
                                    {"normal_module", GearMember::normal_module},
                                    {"helix_angle", GearMember::helix_angle},
                                    {"profile_shift", GearMember::profile_shift},
                                    {"thickness_allowance", GearMember::thickness_allowance},
                                    {"face_width", GearMember::face_width},
                                    {"tip_diameter", GearMember::tip_diameter},
                                    {"tip_fillet.end_radius", GearMember::tip_end_radius},
                                    {"cut_by", GearMember::cutter},
                                    {"bore.diameter", GearMember::bore},
                                    {"bore.keyway_width", GearMember::keyway},
                                    {"bore.keyway_depth", GearMember::keyway},
                                    {"pair.center_distance", GearMember::center_distance}};

}  // namespace

Subject subject_of(std::string_view field) {
  Subject subject;
  const std::string_view first = field.substr(0, field.find('.'));
  if (first == "gear1" || first == "gear2") {
    subject.gear = first == "gear1" ? 1 : 2;
    field.remove_prefix(first.size() == field.size() ? first.size() : first.size() + 1);
  }
  subject.member = GearMember::other;
  for (const NamedMember& known : kMembers)
    if (field == known.name) subject.member = known.member;
  return subject;
}

}  // namespace gearwright
