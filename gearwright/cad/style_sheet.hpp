// Reads the part of CSS that figure_style.css uses. This part consists of rules with classes and
// elements, variables, and the colours for paper. Internal to cad/.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gearwright {

/// The properties and variables of an element, as text.
using Style = std::map<std::string, std::string, std::less<>>;

class StyleSheet {
 public:
  explicit StyleSheet(std::string css);

  const Style& root() const { return root_; }  ///< variables
  /// Sets the properties of all rules that apply to an element with this tag and these classes.
  void apply(std::string_view tag, std::string_view classes, Style& style) const;

 private:
  struct Rule {
    std::string tag;                   // empty if the rule applies to every tag
    std::vector<std::string> classes;  // the element must have all of these classes
    int weight;
    std::string declarations;
  };
  void read(std::string_view css);
  void add(std::string_view selector, std::string_view declarations);

  Style root_;
  std::vector<Rule> rules_;  // in the order in which they are applied
};

const StyleSheet& figure_styles();

/// Sets the properties "name:value;…". Values with color-mix() are ignored.
void apply_declarations(std::string_view declarations, Style& style);

/// Returns the value of a property, or an empty text if the property is absent. If the value is a
/// reference var(…), returns the value of this variable.
std::string text_in(const Style& style, std::string_view name);
double number_in(const Style& style, std::string_view name, double absent);
/// Returns the colour 0xRRGGBB. If the property is absent, returns `absent`. For any text that does
/// not begin with #, such as "none", returns none.
std::optional<std::uint32_t> colour_in(const Style& style, std::string_view name,
                                       std::optional<std::uint32_t> absent);

/// Returns the texts between separators, without surrounding spaces. Empty texts are omitted.
std::vector<std::string_view> trimmed_parts(std::string_view text, char separator);

}  // namespace gearwright
