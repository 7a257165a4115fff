#include "gearwright/spec/rexs_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cctype>
#include <sstream>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/zip.hpp"
#include "gearwright/spec/spec_text.hpp"
#include "gearwright/spec/text_depth.hpp"

namespace gearwright {

namespace {

using Xml = boost::property_tree::ptree;

constexpr std::string_view kZipped = "PK";  // first bytes of a ZIP archive
constexpr int kDeepestElement =
    32;  // greatest depth of nested elements; REXS has at most ten levels

Error no_rexs(std::string rule) { return {"", "", std::move(rule)}; }

// Converts JSON to a tree like that of XML, so that both formats are read in the same way. The
// elements of a list have no tag.
Xml tree_of(const Json& json) {
  Xml tree;
  if (json.is_string())
    tree.data() = json.get<std::string>();
  else if (json.is_number() || json.is_boolean())
    tree.data() = json_text(json);
  else if (json.is_structured())
    for (const auto& [name, value] : json.items())
      tree.push_back({json.is_array() ? std::string() : name, tree_of(value)});
  return tree;
}

std::string attribute_of(const Xml& element, const char* name) {
  return element.get(std::string("<xmlattr>.") + name, element.get(name, std::string()));
}

// Returns the elements with the tag `tag` in XML, or the elements of the list `list` in JSON.
std::vector<const Xml*> elements_of(const Xml& owner, const char* list, const char* tag) {
  std::vector<const Xml*> found;
  for (const auto& [name, element] : owner.get_child(list, owner))
    if (name == tag || (name.empty() && !element.empty())) found.push_back(&element);
  return found;
}

// Returns the value of an attribute. In JSON, it is a member whose name is the type of the value.
// The values of an array are in separate elements.
std::string value_of(const Xml& attribute) {
  std::string value = attribute.data();
  for (const auto& [type, own] : attribute)
    if (value.empty() && type != "<xmlattr>" && type != "id" && type != "unit")
      value = own.size() == 1 ? own.front().second.data() : own.data();
  return value;
}

RexsComponent component_of(const Xml& element) {
  RexsComponent c{attribute_of(element, "id"), attribute_of(element, "type"),
                  attribute_of(element, "name")};
  for (const Xml* a : elements_of(element, "attributes", "attribute")) {
    const std::string value = value_of(*a);
    // Some programs write false in JSON instead of a text or of a vector.
    if (value.empty() || value == "false") continue;
    c.attributes[attribute_of(*a, "id")] = value;
    c.units[attribute_of(*a, "id")] = attribute_of(*a, "unit");
  }
  return c;
}

RexsRelation relation_of(const Xml& element) {
  RexsRelation r{attribute_of(element, "type")};
  for (const Xml* ref : elements_of(element, "refs", "ref"))
    r.refs.emplace_back(attribute_of(*ref, "role"), attribute_of(*ref, "id"));
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

// Returns the extension of a file in lower case, such as ".rexsz".
std::string lower_ending(const std::filesystem::path& path) {
  return lower_case(path.extension().string());
}

// Returns the only REXS file in an archive. Other files, such as load spectra, are not read.
Result<std::string> file_in_archive(std::string_view archive) {
  auto names = zipped_names(archive);
  if (!names) return names.error();
  std::vector<std::string> own;
  for (const std::string& name : *names)
    if (is_rexs(name) && !name.starts_with("__MACOSX/")) own.push_back(name);
  if (own.size() == 1) return unzipped(archive, own.front(), kMaxSpec);
  if (own.empty())
    return no_rexs("the archive contains no file whose name ends in .rexs or .rexsj");
  for (std::string& name : own) name = printable(name, 60);
  return no_rexs(fmt::format(
      "the archive contains {} REXS files ({}); unpack the archive and give one of the files",
      own.size(), enumerated(own)));
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

std::string rexs_json(const RexsModel& model) {
  const auto id_of = [](const std::string& id) { return std::stoi(id); };
  Json tree;
  tree["version"] = model.version;
  tree["applicationId"] = model.application;
  tree["relations"] = Json::array();
  tree["components"] = Json::array();
  for (const RexsRelation& r : model.relations) {
    Json refs = Json::array();
    for (const auto& [role, id] : r.refs) {
      const RexsComponent* const c = model.find(id);
      refs.push_back({{"id", id_of(id)}, {"role", role}, {"hint", c ? c->type : ""}});
    }
    tree["relations"].push_back(
        {{"id", tree["relations"].size() + 1}, {"type", r.type}, {"refs", std::move(refs)}});
  }
  for (const RexsComponent& c : model.components) {
    Json attributes = Json::array();
    for (const auto& [id, value] : c.attributes) {
      Json a{{"id", id}, {"unit", c.units.at(id)}};
      if (value == "true")
        a["boolean"] = true;
      else if (id == "number_of_teeth")
        a["integer"] = std::stoi(value);
      else
        a["floating_point"] = *c.number(id);
      attributes.push_back(std::move(a));
    }
    tree["components"].push_back({{"id", id_of(c.id)},
                                  {"type", c.type},
                                  {"name", c.name},
                                  {"attributes", std::move(attributes)}});
  }
  return json_text(Json{{"model", std::move(tree)}}, 2) + "\n";
}

}  // namespace

std::optional<std::string> RexsComponent::text(std::string_view attribute) const {
  const auto it = attributes.find(attribute);
  return it == attributes.end() ? std::nullopt : std::optional(it->second);
}

void RexsComponent::set(const std::string& attribute, double value, const std::string& unit) {
  attributes[attribute] = fmt::format("{}", value == 0.0 ? 0.0 : value);  // 0 instead of −0
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
    if (!is_in(r.type, with) || !r.names(id)) continue;
    for (const auto& [role, other] : r.refs) {
      const RexsComponent* const c = find(other);
      if (c && c->id != id && is_in(c->type, types)) return c;
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

Result<RexsModel> read_rexs(std::string_view file) {
  std::string_view text = file;
  std::string content;
  if (file.starts_with(kZipped)) {
    auto only = file_in_archive(file);
    if (!only) return only.error();
    text = content = std::move(only).take();
  }
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool json = first != std::string_view::npos && text[first] == '{';
  if (json ? json_depth(text) > kDeepestElement : has_deep_elements(text, kDeepestElement))
    return no_rexs(
        fmt::format("the elements are nested more than {} levels deep", kDeepestElement));
  Xml tree;
  try {
    if (json) {
      tree = tree_of(parse_json(text));
    } else {
      std::istringstream in{std::string(text)};
      namespace parser = boost::property_tree::xml_parser;
      parser::read_xml(in, tree, parser::trim_whitespace | parser::no_comments);
    }
  } catch (const boost::property_tree::xml_parser_error& e) {
    return no_rexs(fmt::format("the file is not XML, because line {} has an error: {}", e.line(),
                               e.message()));
  } catch (const Json::parse_error& e) {
    return no_rexs(fmt::format("the file is not JSON, because it has an error at byte {}", e.byte));
  } catch (const Json::out_of_range&) {
    return no_rexs("the file has a number that is too large");
  }
  const auto model = tree.get_child_optional("model");
  if (!model) return no_rexs("the file is not REXS, because its root element is not `model`");
  RexsModel read{attribute_of(*model, "version"), attribute_of(*model, "applicationId")};
  if (!read.version.starts_with("1.") && !read.version.starts_with("2.0"))
    return no_rexs(fmt::format(
        "the file has the REXS version \"{}\"; versions 1.0 to 1.7 and 2.0 are supported",
        read.version));
  const Xml none;
  for (const Xml* c : elements_of(model->get_child("components", none), "", "component"))
    read.components.push_back(component_of(*c));
  for (const Xml* r : elements_of(model->get_child("relations", none), "", "relation"))
    read.relations.push_back(relation_of(*r));
  return read;
}

bool is_rexs(const std::filesystem::path& path) {
  const std::string ending = lower_ending(path);
  return ending == ".rexs" || ending == ".rexsj" || ending == ".rexsz";
}

std::string rexs_bytes(const RexsModel& model, const std::filesystem::path& path) {
  const std::string ending = lower_ending(path);
  if (ending == ".rexsj") return rexs_json(model);
  if (ending != ".rexsz") return rexs_text(model);
  ZipWriter archive;
  archive.add(path.stem().string() + ".rexs", rexs_text(model));
  return std::move(archive).finish();
}

}  // namespace gearwright
