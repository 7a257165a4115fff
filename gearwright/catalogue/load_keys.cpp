#include "gearwright/catalogue/rating_keys.hpp"
#include "gearwright/load/pair_compliance.hpp"

namespace gearwright {

namespace {

std::optional<KeyFault> check_probe(LoadProbeInput& probe, const KeyGiven&) {
  if (probe.read_z.empty() || probe.z) return std::nullopt;
  return KeyFault{"read_z_mm",
                  "needs z_mm, because without z_mm (in plane strain) the displacement is the same "
                  "everywhere along the face"};
}

}  // namespace

const KeyTable& load_keys() {
  static const KeyTable table{
      "load",
      "Teeth under torque, for the verb `load` and, with drives, for the verbs `drive`, `rate` and "
      "`run`",
      {Key::number("torque_Nm", "T_1", KeyRange::above(0, kMaxInput), &LoadInput::torques, "",
                   "torque on gear 1; a list of torques gives the Harris map. For a drive, the key "
                   "is one torque on the input, and its default is the torque of the drive. For a "
                   "pair, the default of the verb `load` is the nominal torque of `[rating]`")
           .with_list(KeyList{1, kMostTorques, true})
           .with_fields({"torques"})
           .with_also({"torque", "moment", "t1"}),
       Key::number("output_torque_Nm", "T_2", KeyRange::above(0, kMaxInput),
                   &LoadInput::output_torques, "",
                   "torque on the driven gear of a pair, or a list of torques, instead of "
                   "`torque_Nm`. Losses are neglected, as in ISO 6336: T_1 = T_2 z_1/|z_2|. With "
                   "`driver = 2`, the driven gear is gear 1")
           .with_list(KeyList{1, kMostTorques, true})
           .with_fields({"output_torques", "torques"})
           .with_excludes({"torque_Nm"})
           .with_also({"t2", "torque2"}),
       Key::number("driver", "", KeyRange::between(1, 2), &LoadInput::driver, "1",
                   "gear that drives; if gear 2 drives, the sense of rotation does not change, and "
                   "the trailing flanks carry the load"),
       Key::number("positions", "", KeyRange::between(4, kMostLoadPositions), &LoadInput::positions,
                   "64", "positions over one pitch of gear 1"),
       Key::number("rotation1_deg", "", KeyRange::between(-1e6, 1e6), &LoadInput::rotations, "",
                   "rotations of gear 1, instead of positions")
           .with_list(KeyList{1, kMostLoadPositions})
           .with_fields({"rotations"}),
       Key::number(
           "slices", "", KeyRange::between(kLeastSlices, kMostSlices), &LoadInput::slices,
           "32; fewer on a narrow face, so that a slice is at least m_n/4 wide, or 0.4 m_n "
           "for helical teeth; still fewer for internal pairs and for a contact that is wider than "
           "the slices",
           "number of slices over the common face or, for point contact, over the face of each "
           "gear "
           "(on crossed axes, over the part that contact can reach); the width of a slice must be "
           "at least four times the half width of contact"),
       Key::word("accuracy", {"full", "draft"}, &LoadInput::accuracy, "\"full\"",
                 "`draft` uses a coarser mesh of the teeth and is two to three times as fast"),
       Key::number(
           "deflection_slope_um", "", KeyRange::between(-1e5, 1e5), &LoadInput::deflection_slope,
           "0",
           "additional approach of the flanks, linear along the common face, caused by "
           "housing and bearings or by shafts without `[gearN.shaft]`; this approach is added to "
           "the deflection of `[gearN.shaft]`; > 0 towards +z; only for line contact"),
       Key::number("deflection_bow_um", "", KeyRange::between(-1e5, 1e5),
                   &LoadInput::deflection_bow, "0",
                   "additional approach of the flanks that is parabolic along the face; the key "
                   "gives the approach in the middle of the face"),
       Key::text("floating", &LoadInput::floating, "all bodies stay centred",
                 "body of a drive that is free to move radially (the sun, the ring or the carrier "
                 "of a planetary set)"),
       Key::number(
           "pin_error_um", "", KeyRange::between(-1e5, 1e5), &LoadInput::pin_errors, "0",
           "tangential position error of the pin of each planet of a drive, > 0 counter-clockwise; "
           "a single number applies to the first planet. If planets mesh with each other, the list "
           "contains all numbers of the first planet body, then all numbers of the second")
           .with_list(KeyList{1, 1000, true})
           .with_fields({"pin_errors"}),
       {.key = "probe",
        .kind = KeyKind::table,
        .list = KeyList{.most = kMostProbes,
                        .must = "must be a list of 1 to {} tables, [[load.probe]]",
                        .first = 0},
        .place = &LoadInput::probes,
        .tables = {load_probe_keys},
        .meaning = "points at which the compliance of one tooth is computed, each a table "
                   "`[[load.probe]]`",
        .fields = {"probe"}}}};
  return table;
}

const KeyTable& load_probe_keys() {
  static const KeyTable table{
      "load_probe",
      "Compliance of tooth 0 under a unit line force normal to its flank at y > 0",
      {Key::number("gear", "", KeyRange::between(1, 2), &LoadProbeInput::gear, "1",
                   "number of the gear"),
       Key::positive("diameter_mm", "", &LoadProbeInput::diameter, kRequired,
                     "diameter at which the load acts on the flank"),
       Key::number(
           "z_mm", "", {}, &LoadProbeInput::z,
           "the load covers the whole face of a wide gear, in plane strain",
           "start and end of the loaded part of the face, measured from the middle of the face")
           .with_list(
               {.least = 2,
                .most = 2,
                .order = {true, "must be the start and the end of the load, in rising order"}}),
       Key::positive("half_width_mm", "a", &LoadProbeInput::half_width, "0.05 m_n",
                     "half width of the Hertz strip under the load"),
       Key::number(
           "read_z_mm", "", {}, &LoadProbeInput::read_z, "",
           "positions along the face at which the displacement is computed; only with `z_mm`")
           .with_list(KeyList{1, kMostReadings})},
      check_probe};
  return table;
}

}  // namespace gearwright
