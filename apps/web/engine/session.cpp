#include "apps/web/engine/session.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/catalogue/columns.hpp"
#include "gearwright/catalogue/contact_quantities.hpp"
#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/result_rows.hpp"
#include "gearwright/report/contact_report.hpp"

namespace gearwright::web {

namespace {

constexpr int kPatternScene = 64;  // positions per pitch of the contact that pattern() starts from

bool is_number(const QuantityInfo& info) {
  return info.type == Type::number || info.type == Type::whole || info.type == Type::index;
}

// Adds a column for each quantity of the table that consists of numbers or words and has a fixed
// width.
void add_columns(const QuantityTable& table, const std::vector<ValueRecord>& rows, Json& curve) {
  for (const RecordColumn& column : columns_of(table)) {
    const bool words = column.info().type == Type::word;
    if (column.width() == 0 || (!words && !is_number(column.info()))) continue;
    Numbers numbers;
    Json texts = Json::array();
    for (const ValueRecord& row : rows) {
      for (const Value* value : column.values(row)) {
        const auto* const word = std::get_if<std::string>(&value->variant());
        if (words) texts.push_back(word ? *word : std::string());
        if (!words) numbers.push_back(value->number().value_or(kNoNumber));
      }
    }
    curve["width"][column.name(".")] = column.width();
    curve["columns"][column.name(".")] = words ? std::move(texts) : row(numbers);
  }
}

}  // namespace

Result<std::shared_ptr<Session>> Session::open(std::string text) {
  auto session = opened(spec_text(std::move(text)));
  if (!session) return session;
  if (auto error = only_in_mm((*session)->job_.spec, kInPage)) return *error;
  return session;
}

Result<std::shared_ptr<Session>> Session::opened(SpecText text) {
  std::shared_ptr<Session> session(new Session(std::move(text)));
  const auto spec = read(session->text_);
  if (!spec) return spec.error();
  session->job_.spec = *spec;
  if (spec->drive) return session;  // json("drive") reports the errors of a drive
  auto solved = solve_any(*spec, Scope::everything);
  if (!solved) return spelled(solved.error(), spec->given);
  session->job_ = std::move(solved).take();
  return session;
}

Json Session::drawn(Figure figure, double width) const {
  return shape(in_units(units_, std::move(figure)), width);
}

const Answered& Session::answered(const std::string& verb) {
  if (!answered_ || answered_verb_ != verb) {
    answered_ = gearwright::web::answered(verb, text_.text);
    answered_verb_ = verb;
  }
  return *answered_;
}

std::string Session::json(const std::string& verb) {
  if (verb == "pair" && has_pair()) return json_text(job_json(job_, judge(job_)), 2) + "\n";
  return answered(verb).json;
}

Result<std::string> Session::rows(const std::string& verb) {
  if (gears() > 0 && (verb == "gear" || verb == "pair")) return json_text(job_rows(job_, units_));
  const std::optional<Answer>& answer = answered(verb).answer;
  return json_text(answer && answer->rows ? answer->rows(units_) : Json::array());
}

Result<Session::Touching> Session::make_touching() const {
  Touching made;
  const bool gear2_drives = job_.spec.contact.driver == 2;
  if (job_.rack) {
    auto pair = gearwright::contact_pair(*job_.rack, errors_of(job_), rack_options(job_, nullptr));
    if (!pair) return pair.error();
    made.pair = std::move(pair).take();
    return made;
  }
  if (!job_.pair) return absent_input("gear2", "; tooth contact needs a pair of gears");
  auto setup = setup_of(job_, errors_of(job_));
  if (!setup) return setup.error();
  made.setup = std::move(setup).take();
  const ContactErrors& errors = made.setup->place().errors;
  if (job_.halves[0]) {
    made.halves.emplace(*made.setup, job_.halves[0]->given.stagger_pitches);
    made.both = made.halves->pair(errors, gear2_drives);
  }
  made.pair = made.both ? made.both->half[0] : made.setup->shared_pair(errors, gear2_drives);
  return made;
}

Result<const Session::Touching*> Session::touching() {
  if (!touching_) touching_ = make_touching();
  if (!*touching_) return touching_->error();
  return &touching_->value();
}

Result<std::vector<double>> Session::te_under(const std::array<std::size_t, 2>& keys,
                                              const std::array<double, 2>& values, int positions) {
  const auto made = touching();
  if (!made) return made.error();
  const Touching& t = **made;
  if (!t.setup) return two_gears_error(job_.spec).value();
  ContactErrors errors = t.setup->place().errors;
  for (const std::size_t i : {0, 1}) errors = with_error(*t.setup, errors, keys[i], values[i]);
  const bool gear2_drives = job_.spec.contact.driver == 2;
  if (t.halves) return transmission_error(t.halves->pair(errors, gear2_drives).mesh, positions);
  return transmission_error(t.setup->pair(errors, gear2_drives), positions);
}

Result<Session::Found> Session::analyse(const ContactRequest& request) {
  const auto made = touching();
  if (!made) return made.error();
  const Touching& t = **made;
  Found found;
  if (!t.both) {
    found.whole = analyse_contact(*t.pair, request);
    found.flanks = {{contact_scene(job_.flanked_gears(), *t.pair, marking(), found.whole), t.pair}};
    return found;
  }
  HalvesContact both = analyse_contact(t.both->mesh, request);
  found.flanks =
      flanks_of(job_.flanked_gears(), *t.both, marking(), {&both.half[0], &both.half[1]});
  found.whole = std::move(both.whole);
  return found;
}

Result<const Session::Found*> Session::found(int positions) {
  if (positions < 2 || positions > 4096)
    return refused("positions", positions, "must lie between 2 and 4096");
  if (!found_ || found_->whole.positions.size() != static_cast<std::size_t>(positions)) {
    auto made = analyse({positions, 1, marking()});
    if (!made) return made.error();
    found_ = std::move(made).take();
  }
  return &*found_;
}

Result<Json> Session::contact_curve(int positions) {
  const auto made = this->found(positions);
  if (!made) return made.error();
  const ContactResult& found = (*made)->whole;
  Numbers harmonics;  // none for a rack, whose transmission error is a length
  for (const Angle& a : found.harmonics)
    if (!found.rack) harmonics.push_back(a.arcsec());
  const bool known = !found.rack && any_contact(found);
  Json curve{{"n", positions},
             {"peakToPeakArcsec", known ? found.peak_to_peak.arcsec() : kNoNumber},
             {"meanSlope", found.mean_slope},
             {"harmonicsArcsec", row(harmonics)},
             {"contactLost", found.contact_lost},
             {"words", contact_words(found)}};
  std::vector<ValueRecord> records;
  for (const ContactPoint& p : found.positions) records.push_back(position_quantities().of(p));
  add_columns(position_quantities().table(), records, curve);
  return curve;
}

Result<Json> Session::contact_figures(const ContactFigureView& view) {
  const auto made = this->found(view.positions);
  if (!made) return made.error();
  const Found& found = **made;
  Json figures = Json::array();
  const auto add = [&](const std::optional<Figure>& f) {
    if (f) figures.push_back(drawn(*f, view.width));
  };
  if (view.curves) {
    ContactScene scene = found.flanks[0];
    scene.driving = found.whole;
    add(transmission_error_figure(scene, scene.driving));
    add(spectrum_figure(scene.driving));
  }
  std::size_t raster = 0;  // index of the next pattern
  for (const FlankContact& flanks : found.flanks) {
    const ContactPoint& now =
        flanks.driving
            .positions[static_cast<std::size_t>(std::clamp(view.index, 0, view.positions - 1))];
    FlankRaster gap;
    if (now.kind != TouchKind::none) gap = flanks.gap(now, {25, 49});
    for (const std::size_t i : {0, 1}) {
      if (!flanks.gears[i]) continue;
      FlankLayers layers;
      if (raster < view.patterns.size()) layers.pattern = &view.patterns[raster++];
      if (i == 0 && !gap.gap.empty()) layers.gap = &gap;
      if (now.kind != TouchKind::none) layers.now = &now;
      if (!layers.pattern && !layers.gap) continue;
      Figure figure = flank_figure(flanks, i, layers);
      if (job_.halves[0]) figure.title += flanks.below ? ", half at z < 0" : ", half at z > 0";
      add(figure);
    }
  }
  return figures;
}

Result<ContactPoint> Session::touch(double rotation1_deg) {
  ContactRequest request{2, 1, marking()};
  request.rotations = {Angle::degrees(rotation1_deg)};
  const auto found = analyse(request);
  if (!found) return found.error();
  return found->whole.positions.front();
}

Result<std::string> Session::contact_point(double rotation1_deg) {
  const auto p = touch(rotation1_deg);
  if (!p) return p.error();
  Json json = to_json(position_quantities().of(*p));
  if (p->kind == TouchKind::none) json["kind"] = "none";
  return json_text(json);
}

Result<FlankRaster> Session::gap_map(double rotation1_deg, int k, const RasterSize& size) {
  const auto made = touching();
  if (!made) return made.error();
  return gearwright::gap_map(*(*made)->pair, Angle::degrees(rotation1_deg), k, size);
}

Result<std::vector<FlankRaster>> Session::pattern(int positions, const RasterSize& size) {
  const auto made = found(kPatternScene);
  if (!made) return made.error();
  std::vector<FlankRaster> all;
  for (const FlankContact& flanks : (*made)->flanks) {
    const auto both = flanks.pattern(positions, size);
    for (std::size_t i = 0; i < job_.gears.size(); ++i) all.push_back(both[i]);
  }
  return all;
}

}  // namespace gearwright::web
