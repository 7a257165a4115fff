#include "gearwright/catalogue/load_keys.hpp"

namespace gearwright {

namespace {

std::optional<KeyFault> check_probe(LoadProbeInput& probe, const KeyGiven&) {
  if (probe.read_z.empty() || probe.z) return std::nullopt;
  return KeyFault{"read_z_mm",
                  "needs z_mm, because in plane strain the displacement is the same everywhere"};
}

}  // namespace

const KeyTable& load_keys() {
  using Range = KeyRange;
  static const KeyTable table{
      "load",
      "Teeth under torque: the verb `load`",
      {Key::number("torque_Nm", "T_1", Range::above(0, kMaxInput), &LoadInput::torques, "",
                   "torque on gear 1; a list gives the Harris map")
           .with_list(KeyList{1, kMostTorques, true})
           .with_fields({"torques"})
           .with_also({"torque", "moment", "t1"}),
       Key::number(
           "driver", "", Range::between(1, 2), &LoadInput::driver, "1",
           "1, or 2: gear 2 pushes in the same sense of rotation, and the non-working flanks "
           "carry"),
       Key::number("positions", "", Range::between(4, kMostLoadPositions), &LoadInput::positions,
                   "64", "positions over one pitch of gear 1"),
       Key::number("rotation1_deg", "", Range::between(-1e6, 1e6), &LoadInput::rotations, "",
                   "rotations of gear 1, in place of positions")
           .with_list(KeyList{1, kMostLoadPositions})
           .with_fields({"rotations"}),
       Key::number(
           "slices", "", Range::between(4, kMostSlices), &LoadInput::slices,
           "32; on a narrow face, slices of width m_n/4, or 0.4 m_n for helical teeth, and wider "
           "for internal pairs",
           "slices over the common face, each at least four half widths of contact; for point "
           "contact over each gear's face"),
       Key::word("accuracy", {"full", "draft"}, &LoadInput::accuracy, "\"full\"",
                 "`draft`: a coarser mesh of the teeth, two to three times as fast"),
       Key::number("deflection_slope_um", "", Range::between(-1e5, 1e5),
                   &LoadInput::deflection_slope, "0",
                   "further approach of the flanks along the face, from shafts: over the common "
                   "face, > 0 towards +z; for line contact"),
       Key::number("deflection_bow_um", "", Range::between(-1e5, 1e5), &LoadInput::deflection_bow,
                   "0", "further approach as a parabola; its height in the middle of the face"),
       {.key = "probe",
        .kind = KeyKind::table,
        .list = KeyList{.most = kMostProbes,
                        .must = "must be a list of tables, [[load.probe]], 1 to {} of them",
                        .first = 0},
        .place = &LoadInput::probes,
        .tables = {load_probe_keys},
        .meaning = "`[[load.probe]]`: a tooth's own compliance",
        .fields = {"probe"}}}};
  return table;
}

const KeyTable& load_probe_keys() {
  using Range = KeyRange;
  static const KeyTable table{
      "load_probe",
      "A tooth's own compliance: a unit line force on tooth 0, normal to its flank at y > 0",
      {Key::number("gear", "", Range::between(1, 2), &LoadProbeInput::gear, "1", "which gear"),
       Key::positive("diameter_mm", "", &LoadProbeInput::diameter, kRequired, "where on the flank"),
       Key::number("z_mm", "", {}, &LoadProbeInput::z,
                   "the whole face, in plane strain (a wide gear)",
                   "the loaded part of the face, from its middle")
           .with_list({.least = 2,
                       .most = 2,
                       .order = {true, "must grow: where the load begins, then where it ends"}}),
       Key::positive("half_width_mm", "a", &LoadProbeInput::half_width, "0.05 m_n",
                     "half width of the Hertz strip under the load"),
       Key::number("read_z_mm", "", {}, &LoadProbeInput::read_z, "",
                   "position along the face at which the displacement is computed; with `z_mm`")
           .with_list(KeyList{1, kMostReadings})},
      check_probe};
  return table;
}

}  // namespace gearwright
