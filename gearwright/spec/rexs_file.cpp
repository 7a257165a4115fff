#include "gearwright/spec/rexs_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace gearwright {

namespace {

using Tree = boost::property_tree::ptree;

constexpr int kDeepest = 32;  // greatest depth of nested elements; REXS has six levels

// The parser is recursive, with one call for each level, so the depth is checked before it runs.
bool too_deep(std::string_view xml) {
  int depth = 0;
  for (std::size_t i = 0; (i = xml.find('<', i)) != std::string_view::npos; ++i) {
    const char next = i + 1 < xml.size() ? xml[i + 1] : '\0';
    if (next == '!' || next == '?') continue;
    if (next == '/') {
      --depth;
      continue;
    }
    const std::size_t end = xml.find('>', i);
    if (end == std::string_view::npos) return false;  // the parser reports this error
    if (xml[end - 1] != '/' && ++depth > kDeepest) return true;
  }
  return false;
}

Error no_rexs(std::string rule) { return {"", "", std::move(rule)}; }

std::string attribute_of(const Tree& element, const char* name) {
  return element.get(std::string("<xmlattr>.") + name, std::string());
}

RexsComponent component_of(const Tree& element) {
  RexsComponent c{attribute_of(element, "id"), attribute_of(element, "type"),
                  attribute_of(element, "name")};
  for (const auto& [tag, a] : element) {
    // The values of an array are in separate elements.
    const auto array = tag == "attribute" ? a.get_child_optional("array") : boost::none;
    const std::string value =
        array && array->count("c") == 1 ? array->get<std::string>("c") : a.data();
    if (tag != "attribute" || value.empty()) continue;
    c.attributes[attribute_of(a, "id")] = value;
    c.units[attribute_of(a, "id")] = attribute_of(a, "unit");
  }
  return c;
}

RexsRelation relation_of(const Tree& element) {
  RexsRelation r{attribute_of(element, "type")};
  for (const auto& [tag, ref] : element)
    if (tag == "ref") r.refs.emplace_back(attribute_of(ref, "role"), attribute_of(ref, "id"));
  return r;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

}  // namespace

std::optional<double> RexsComponent::number(std::string_view attribute) const {
  const auto it = attributes.find(attribute);
  if (it == attributes.end()) return std::nullopt;
  const std::string& text = it->second;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value == 0.0 ? 0.0 : value;  // gives 0 instead of −0
}

std::optional<std::string> RexsComponent::text(std::string_view attribute) const {
  const auto it = attributes.find(attribute);
  return it == attributes.end() ? std::nullopt : std::optional(it->second);
}

void RexsComponent::set(const std::string& attribute, double value, const std::string& unit) {
  attributes[attribute] = fmt::format("{}", value);
  units[attribute] = unit;
}

void RexsComponent::flag(const std::string& attribute) {
  attributes[attribute] = "true";
  units[attribute] = "none";
}

std::string_view RexsRelation::of(std::string_view role) const {
  for (const auto& [name, id] : refs)
    if (name == role) return id;
  return {};
}

bool RexsRelation::names(std::string_view id) const {
  return std::any_of(refs.begin(), refs.end(), [&](const auto& r) { return r.second == id; });
}

const RexsComponent* RexsModel::find(std::string_view id) const {
  for (const RexsComponent& c : components)
    if (c.id == id) return &c;
  return nullptr;
}

const RexsComponent* RexsModel::related(std::string_view id,
                                        std::initializer_list<std::string_view> with,
                                        std::initializer_list<std::string_view> types) const {
  for (const RexsRelation& r : relations) {
    if (std::find(with.begin(), with.end(), r.type) == with.end() || !r.names(id)) continue;
    for (const auto& [role, other] : r.refs) {
      const RexsComponent* const c = find(other);
      if (c && c->id != id && std::find(types.begin(), types.end(), c->type) != types.end())
        return c;
    }
  }
  return nullptr;
}

std::vector<const RexsComponent*> RexsModel::of_type(std::string_view type) const {
  std::vector<const RexsComponent*> list;
  for (const RexsComponent& c : components)
    if (c.type == type) list.push_back(&c);
  return list;
}

Result<RexsModel> read_rexs(std::string_view xml) {
  if (too_deep(xml))
    return no_rexs(fmt::format("the elements are nested more than {} levels deep", kDeepest));
  Tree tree;
  try {
    std::istringstream in{std::string(xml)};
    namespace parser = boost::property_tree::xml_parser;
    parser::read_xml(in, tree, parser::trim_whitespace | parser::no_comments);
  } catch (const boost::property_tree::xml_parser_error& e) {
    return no_rexs(fmt::format("the file is not XML: line {}: {}", e.line(), e.message()));
  }
  const auto model = tree.get_child_optional("model");
  if (!model) return no_rexs("the file is not REXS, because its root element is not `model`");
  RexsModel read{attribute_of(*model, "version"), attribute_of(*model, "applicationId")};
  if (!read.version.starts_with("1.") && !read.version.starts_with("2.0"))
    return no_rexs(fmt::format(
        "the file has the REXS version \"{}\"; versions 1.0 to 1.7 and 2.0 are supported",
        read.version));
  if (const auto components = model->get_child_optional("components"))
    for (const auto& [tag, element] : *components)
      if (tag == "component") read.components.push_back(component_of(element));
  if (const auto relations = model->get_child_optional("relations"))
    for (const auto& [tag, element] : *relations)
      if (tag == "relation") read.relations.push_back(relation_of(element));
  return read;
}

std::optional<std::string> other_rexs_format(const std::filesystem::path& path) {
  const std::filesystem::path form = path.extension();
  if (form != ".rexsj" && form != ".rexsz") return std::nullopt;
  return fmt::format("REXS as {} is not supported; use REXS as XML, with the ending .rexs",
                     form == ".rexsj" ? "JSON" : "a compressed file");
}

std::string rexs_text(const RexsModel& model) {
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model applicationId=\"{}\" version=\"{}\">\n"
      "  <relations>\n",
      escaped(model.application), model.version);
  int number = 0;
  for (const RexsRelation& r : model.relations) {
    out += fmt::format("    <relation id=\"{}\" type=\"{}\">\n", ++number, r.type);
    for (const auto& [role, id] : r.refs) {
      const RexsComponent* const c = model.find(id);
      out += fmt::format("      <ref hint=\"{}\" id=\"{}\" role=\"{}\"/>\n", c ? c->type : "", id,
                         role);
    }
    out += "    </relation>\n";
  }
  out += "  </relations>\n  <components>\n";
  for (const RexsComponent& c : model.components) {
    out += fmt::format("    <component id=\"{}\" name=\"{}\" type=\"{}\">\n", c.id, escaped(c.name),
                       c.type);
    for (const auto& [id, value] : c.attributes)
      out += fmt::format("      <attribute id=\"{}\" unit=\"{}\">{}</attribute>\n", id,
                         c.units.at(id), escaped(value));
    out += "    </component>\n";
  }
  return out + "  </components>\n</model>\n";
}

}  // namespace gearwright
