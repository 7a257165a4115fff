#include "gearwright/report/rating_section.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/report/html_text.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

namespace {

std::string finding(const Rating& r) {
  const auto least = [](const FactorPair& f) {
    return fmt::format("{} (gear {})", fixed(std::min(f[0].value, f[1].value), 2),
                       f[0].value <= f[1].value ? 1 : 2);
  };
  return fmt::format(
      "Least safety against root breakage {}, against pitting {}. Allowable stress numbers "
      "from the table of materials are the standard’s reference values: check them against the "
      "material’s certificate.",
      least(r.S_F), least(r.S_H));
}

std::string table(const RatingView& view) {
  TableBuilder t("Strength, as rated", {"Gear 1", "Gear 2", "Place in the standard, branch"});
  const auto& quantities = rating_quantities();
  for (const TextGroup& group : text_groups(quantities.table(), {quantities.of(view)}, kPage)) {
    t.group(group.title.empty() ? "Standard" : group.title);
    for (const TextRow& row : group.rows) {
      const std::string words = capitalised(row.info->words);
      const std::string place = source_text(view.rating, row.info->key);
      if (row.texts.size() > 1) {
        t.row(words, row.info->symbol, unit_text(row.info->unit),
              {row.texts.front(), row.texts.back(), place});
      } else {
        t.common(words, row.info->symbol, unit_text(row.info->unit), row.texts.front(), place);
      }
    }
  }
  return t.str();
}

}  // namespace

std::string rating_section(const RatingView& view) {
  const bool plastic = view.rating.edition == RatingEdition::vdi_2736;
  const std::string method =
      fmt::format("{}{}", name(view.rating.edition), plastic ? "" : ", method B");
  return fmt::format(
      "<section class=\"rating\">\n<h2>Strength</h2>\n<p>Rated by {}. Scuffing and "
      "micropitting are not rated{}.</p>\n<p><strong>{}</strong></p>\n{}</section>\n",
      method, plastic ? ", nor are wear and deformation" : "", finding(view.rating), table(view));
}

}  // namespace gearwright
