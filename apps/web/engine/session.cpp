#include "apps/web/engine/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/web/engine/answering.hpp"
#include "gearwright/catalogue/columns.hpp"
#include "gearwright/catalogue/contact_quantities.hpp"
#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/report/contact_report.hpp"

namespace gearwright::web {

namespace {

bool is_number(const QuantityInfo& info) {
  return info.type == Type::number || info.type == Type::whole || info.type == Type::index;
}

// Adds a column for each quantity of the table that consists of numbers or words and has a fixed
// width.
void add_columns(const QuantityTable& table, const std::vector<ValueRecord>& rows,
                 ContactCurve& curve) {
  for (const RecordColumn& column : columns_of(table)) {
    const bool words = column.info().type == Type::word;
    if (column.width() == 0 || (!words && !is_number(column.info()))) continue;
    Numbers numbers;
    std::vector<std::string> texts;
    for (const ValueRecord& row : rows) {
      for (const Value* value : column.values(row)) {
        const auto* const word = std::get_if<std::string>(&value->variant());
        if (words) texts.push_back(word ? *word : std::string());
        if (!words) numbers.push_back(value->number().value_or(kNaN));
      }
    }
    ContactCurve::Column& made = curve.columns[column.name(".")];
    made.width = static_cast<int>(column.width());
    if (words) made.values = std::move(texts);
    if (!words) made.values = std::move(numbers);
  }
}

}  // namespace

Result<std::shared_ptr<Session>> Session::open(std::string text) {
  std::shared_ptr<Session> session(new Session(spec_text(std::move(text))));
  const auto spec = read(session->text_);
  if (!spec) return spec.error();
  if (auto error = only_in_mm(*spec, kInPage)) return *error;
  session->job_.spec = *spec;
  auto solved = solve(*spec, Scope::everything);
  if (!solved) return spelled(solved.error(), spec->given);
  session->job_ = std::move(solved).take();
  return session;
}

std::string Session::json(std::string_view verb) const {
  if (verb == "pair" && job_.pair) return json_text(job_json(job_, judge(job_)), 2) + "\n";
  return answer(verb, text_.text);
}

Result<ContactSetup*> Session::setup() {
  if (!job_.pair) return absent_input("gear2", "; tooth contact needs a pair of gears");
  if (!setup_) setup_ = setup_of(job_);
  if (!*setup_) return setup_->error();
  return const_cast<ContactSetup*>(&setup_->value());
}

Result<const ContactPair*> Session::contact_pair() {
  const auto made = setup();
  if (!made) return made.error();
  if (!pair_) pair_ = (*made)->pair(job_.spec.contact.driver == 2);
  return &*pair_;
}

Result<ContactPair> Session::pair_under(const std::array<std::size_t, 2>& keys,
                                        const std::array<double, 2>& values) {
  const auto made = setup();
  if (!made) return made.error();
  ContactErrors errors = (*made)->place().errors;
  for (const std::size_t i : {0, 1}) errors = with_error(**made, errors, keys[i], values[i]);
  return (*made)->pair(errors, job_.spec.contact.driver == 2);
}

Result<const ContactResult*> Session::found(int positions) {
  const auto pair = contact_pair();
  if (!pair) return pair.error();
  if (positions < 2 || positions > 4096)
    return refused("positions", positions, "must lie between 2 and 4096");
  if (!found_ || found_->positions.size() != static_cast<std::size_t>(positions))
    found_ = analyse_contact(**pair, {positions, 1, marking()});
  return &*found_;
}

Result<ContactCurve> Session::contact_curve(int positions) {
  const auto made = this->found(positions);
  if (!made) return made.error();
  const ContactResult& found = **made;
  ContactCurve curve{positions,           {}, 0.0, found.mean_slope, {}, found.contact_lost,
                     contact_words(found)};
  bool touches = false;
  for (const ContactPoint& p : found.positions) touches = touches || p.kind != TouchKind::none;
  curve.peak_to_peak_arcsec = touches ? found.peak_to_peak.arcsec() : kNaN;
  for (const Angle& a : found.harmonics) curve.harmonics_arcsec.push_back(a.arcsec());
  std::vector<ValueRecord> records;
  for (const ContactPoint& p : found.positions) records.push_back(position_quantities().of(p));
  add_columns(position_quantities().table(), records, curve);
  return curve;
}

Result<Json> Session::contact_figures(const ContactView& view) {
  const auto found = this->found(view.positions);
  if (!found) return found.error();
  const auto& gears = job_.pair->mounted().gears;
  const ContactScene scene = contact_scene({&gears[0], &gears[1]}, *pair_, marking(), **found);
  Json figures = Json::array();
  const auto add = [&](const std::optional<Figure>& f) {
    if (f) figures.push_back(shape(*f, view.width));
  };
  if (view.curves) {
    add(transmission_error_figure(scene, scene.driving));
    add(spectrum_figure(scene.driving));
  }
  const ContactPoint& now =
      scene.driving
          .positions[static_cast<std::size_t>(std::clamp(view.index, 0, view.positions - 1))];
  if (now.kind == TouchKind::none && view.patterns[0].gap.empty()) return figures;
  const FlankRaster gap = now.kind == TouchKind::none
                              ? FlankRaster()
                              : gearwright::gap_map(*pair_, now.rotation1, now.pair, {25, 49});
  for (const std::size_t i : {0, 1}) {
    FlankLayers layers;
    if (!view.patterns[i].gap.empty()) layers.pattern = &view.patterns[i];
    if (i == 0 && !gap.gap.empty()) layers.gap = &gap;
    if (now.kind != TouchKind::none) layers.now = &now;
    if (layers.pattern || layers.gap) add(flank_figure(scene, i, layers));
  }
  return figures;
}

Result<ContactPoint> Session::touch(double rotation1_deg) {
  const auto pair = contact_pair();
  if (!pair) return pair.error();
  ContactRequest request{2, 1, marking()};
  request.rotations = {Angle::degrees(rotation1_deg)};
  return analyse_contact(**pair, request).positions.front();
}

Result<std::string> Session::contact_point(double rotation1_deg) {
  const auto p = touch(rotation1_deg);
  if (!p) return p.error();
  Json json = to_json(position_quantities().of(*p));
  if (p->kind == TouchKind::none) json["kind"] = "none";
  return json_text(json);
}

Result<FlankRaster> Session::gap_map(double rotation1_deg, int k, const RasterSize& size) {
  const auto pair = contact_pair();
  if (!pair) return pair.error();
  return gearwright::gap_map(**pair, Angle::degrees(rotation1_deg), k, size);
}

}  // namespace gearwright::web
