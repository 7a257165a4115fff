#include "gearwright/catalogue/load_keys.hpp"

namespace gearwright {

const KeyTable& load_keys() {
  using Range = KeyRange;
  static const KeyTable table{
      "load",
      "Teeth under torque: the verb `load`",
      {{.key = "torque_Nm",
        .symbol = "T_1",
        .range = Range::above(0, kMaxInput),
        .list = KeyList{1, kMostTorques, true},
        .meaning = "torque on gear 1; a list makes the Harris map",
        .fields = {"torques"},
        .also = {"torque", "moment", "t1"}},
       {.key = "driver",
        .kind = KeyKind::whole,
        .range = Range::between(1, 2),
        .place = &LoadInput::driver,
        .fallback = "1",
        .meaning =
            "1, or 2: gear 2 pushes in the same sense of rotation, and the non-working flanks "
            "carry"},
       {.key = "positions",
        .kind = KeyKind::whole,
        .range = Range::between(4, kMostLoadPositions),
        .place = &LoadInput::positions,
        .fallback = "64",
        .meaning = "positions over one pitch of gear 1"},
       {.key = "rotation1_deg",
        .range = Range::between(-1e6, 1e6),
        .list = KeyList{1, kMostLoadPositions},
        .meaning = "rotations of gear 1, in place of positions",
        .fields = {"rotations"}},
       {.key = "slices",
        .kind = KeyKind::whole,
        .range = Range::between(4, kMostSlices),
        .place = &LoadInput::slices,
        .fallback = "32; on a narrow face as many as are m_n/4 wide, 0.4 m_n of helical teeth, "
                    "of internal pairs wider still",
        .meaning =
            "slices over the common face; none narrower than four half widths of contact. Of "
            "teeth that touch at points over each gear's face"},
       {.key = "accuracy",
        .kind = KeyKind::word,
        .words = {"full", "draft"},
        .place = &LoadInput::accuracy,
        .fallback = "\"full\"",
        .meaning = "`draft`: a coarser mesh of the teeth, two to three times as fast"},
       {.key = "deflection_slope_um",
        .range = Range::between(-1e5, 1e5),
        .place = &LoadInput::deflection_slope,
        .fallback = "0",
        .meaning =
            "further approach of the flanks along the face, from shafts: over the common face, "
            "> 0 towards +z; of teeth that touch along lines"},
       {.key = "deflection_bow_um",
        .range = Range::between(-1e5, 1e5),
        .place = &LoadInput::deflection_bow,
        .fallback = "0",
        .meaning = "and as a parabola, its height in the middle of the face"},
       {.key = "probe",
        .kind = KeyKind::table,
        .list = KeyList{1, kMostProbes},
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
      {{.key = "gear",
        .kind = KeyKind::whole,
        .range = Range::between(1, 2),
        .place = &LoadProbeInput::gear,
        .fallback = "1",
        .meaning = "which gear"},
       {.key = "diameter_mm",
        .range = Range::positive(),
        .place = &LoadProbeInput::diameter,
        .required = true,
        .meaning = "where on the flank"},
       {.key = "z_mm",
        .list = KeyList{2, 2},
        .fallback = "the whole face, in plane strain (a wide gear)",
        .meaning = "the loaded part of the face, from its middle"},
       {.key = "half_width_mm",
        .symbol = "a",
        .range = Range::positive(),
        .place = &LoadProbeInput::half_width,
        .fallback = "0.05 m_n",
        .meaning = "half width of the Hertz strip under the load"},
       {.key = "read_z_mm",
        .list = KeyList{1, kMostReadings},
        .meaning = "where along the face the displacement is read; with `z_mm`"}}};
  return table;
}

}  // namespace gearwright
