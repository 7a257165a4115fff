#include "gearwright/cad/gear_body.hpp"

namespace gearwright {

Result<ToothedBody> gear_body(const Gear& gear, const std::string& name,
                              const std::optional<Bore>& bore) {
  if (!gear.tooth)
    return absent_input("cut_by", "; an internal gear's outline is cut by a pinion cutter");
  if (!gear.exists()) {
    const std::string why =
        gear.warnings.empty() ? "there is no such tooth" : gear.warnings.back().message;
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

}  // namespace gearwright
