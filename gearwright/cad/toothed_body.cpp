#include "gearwright/cad/toothed_body.hpp"

#include <cmath>
#include <utility>

#include "gearwright/cad/modified_teeth.hpp"
#include "gearwright/contact/contact_setup.hpp"

namespace gearwright {

std::vector<Band> SolidGear::bands() const {
  std::vector<Band> all = body->bands();
  for (Band& band : all) {
    band.middle += height;
    band.turn += turn - band.twist * height;
  }
  return all;
}

double SolidGear::bottom() const { return height - body->face_width / 2.0; }
double SolidGear::top() const { return height + body->face_width / 2.0; }

std::vector<SolidGear> ToothedBody::gears() const {
  std::vector<SolidGear> all{{this}};
  for (const ToothedBody& gear : above) all.push_back({&gear, gear.height, gear.turn});
  return all;
}

std::vector<Band> ToothedBody::bands() const {
  if (!two_helices) return {{twist, face_width, 0.0, 0.0}};
  const double width = (face_width - two_helices->gap) / 2.0;
  const double middle = (two_helices->gap + width) / 2.0;
  return {{-twist, width, -middle, two_helices->stagger}, {twist, width, middle, 0.0}};
}

Result<ToothedBody> gear_body(const Gear& gear, const std::string& name,
                              const std::optional<Bore>& bore) {
  if (!gear.tooth)
    return absent_input(
        "cut_by",
        "; the outline of an internal gear depends on its pinion cutter, so give the cutter");
  if (!gear.exists()) {
    const std::string why =
        gear.warnings.empty() ? "no tooth is left" : gear.warnings.back().message;
    return Error{"teeth", std::to_string(gear.spec.teeth), why};
  }
  ToothedBody body;
  body.name = name;
  body.outline = gear.tooth->outline;
  body.twist = gear.twist();
  body.face_width = gear.spec.face_width;
  body.bore = bore;
  return body;
}

std::optional<Error> modify(ToothedBody& body, const Gear& gear, const BothFlanks& flanks) {
  if (!any_modification(flanks)) return std::nullopt;
  if (!gear.root_form_radius()) {
    body.unmodified = "the gear has no usable flank";
    return std::nullopt;
  }
  const auto removal = removal_of(gear, flanks);
  if (!removal) return removal.error();
  if (auto teeth = ModifiedTeeth::of(body, *removal)) {
    body.modified = std::make_shared<const ModifiedTeeth>(std::move(teeth).take());
  } else {
    body.unmodified = teeth.error().rule;
  }
  return std::nullopt;
}

Result<ToothedBody> rack_body(const RackGeometry& rack, const std::string& name) {
  GW_EXPECTS(rack.height > rack.dedendum);
  auto outline = rack_outline(rack);
  if (!outline) return outline.error();
  ToothedBody body;
  body.name = name;
  body.outline = std::move(outline).take();
  body.face_width = rack.face_width;
  body.rack = RackBlock{rack.transverse_pitch, rack.height, std::tan(rack.helix_angle.rad()),
                        rack.fillet_radius};
  return body;
}

}  // namespace gearwright
