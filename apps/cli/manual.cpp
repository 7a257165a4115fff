#include <fmt/format.h>

#include "apps/cli/command_line.hpp"
#include "gearwright/base/version.hpp"
#include "gearwright/catalogue/spec_keys.hpp"

namespace gearwright::apps {

namespace {

// Escapes a text for troff. The escapes preserve hyphens when the text is copied, and prevent troff
// from treating a line of the text as a request.
std::string troff(std::string_view text) {
  std::string out;
  bool begin = true;
  for (const char c : text) {
    if (begin && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
    begin = c == '\n';
  }
  return out;
}

std::string option_text(const CLI::Option& option) {
  const bool value = option.get_items_expected_max() > 0;
  return fmt::format(
      ".TP\n.B {}{}\n{}\n", troff(fmt::format("{}", fmt::join(names_of(option), ", "))),
      value ? " \\fI" + troff("VALUE") + "\\fR" : "", troff(option.get_description()));
}

std::string verb_text(const CLI::App& verb) {
  std::string usage = "gearwright " + verb.get_name();
  std::string arguments;
  for (const CLI::Option* o :
       verb.get_options([](const CLI::Option* option) { return option->get_positional(); })) {
    usage += " " + o->get_name(true);
    arguments +=
        fmt::format(".TP\n.I {}\n{}\n", troff(o->get_name(true)), troff(o->get_description()));
  }
  std::string out = fmt::format(".SS \"{}\"\n{}.\n", troff(usage), troff(verb.get_description()));
  out += arguments;
  for (const CLI::Option* o :
       verb.get_options([](const CLI::Option* option) { return option->nonpositional(); })) {
    const auto& names = o->get_lnames();
    const bool everywhere = !names.empty() && (names[0] == "help" || names[0] == "version");
    if (!everywhere) out += option_text(*o);
  }
  return out;
}

std::string table_text(const KeyTable& table) {
  std::string out =
      fmt::format(".SS \"{}\"\n{}.\n", troff(table.name), troff(plain_words(table.meaning)));
  for (const Key& key : table.keys) {
    if (!key.in_documents) continue;
    const std::string fallback = key.required           ? "; required"
                                 : key.fallback.empty() ? ""
                                                        : "; default: " + plain_words(key.fallback);
    out += fmt::format(".TP\n.B {}\n{}{}{}.\n", troff(key.key),
                       key.symbol.empty() ? "" : troff(key.symbol) + ": ",
                       troff(plain_words(key.meaning)), troff(fallback));
  }
  return out;
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string out = fmt::format(
      ".\\\" made by `gearwright manual`\n"
      ".TH GEARWRIGHT 1 \"\" \"gearwright {}\" \"User Commands\"\n"
      ".SH NAME\n"
      "gearwright \\- exact geometry, mesh and CAD files of cylindrical gears\n"
      ".SH SYNOPSIS\n"
      ".B gearwright\n"
      ".I VERB SPEC\n"
      "[\\fB\\-\\-json\\fR] [\\fIoptions\\fR]\n"
      ".SH DESCRIPTION\n"
      "Reads a gear, a pair of gears or a search for gears from a spec (a TOML or JSON file) and "
      "computes\n"
      "diameters and limits, contact, inspection dimensions and suitable gears.\n"
      "The results are tables, JSON and files for CAD.\n"
      ".PP\n"
      "The smallest spec is\n"
      ".PP\n.nf\n[gear1]\nteeth = 17\nnormal_module_mm = 2.5\n.fi\n"
      ".PP\n"
      "A spec named \\fB\\-\\fR is standard input, TOML or JSON.\n"
      ".SH VERBS\n",
      kVersion);
  for (const CLI::App* verb : verbs_of(app)) out += verb_text(*verb);
  out +=
      ".SH \"KEYS OF A SPEC\"\nLengths are in mm and angles in degrees, as given in the key. gear2 "
      "has the keys of gear1. If\nits module, pressure angle, rack or helix angle is absent, gear1 "
      "determines the value.\n";
  for (const KeyTable* table : all_key_tables()) {
    if (table != &spec_keys() && table->name != "cutter" && table->name != "compensate_range")
      out += table_text(*table);
  }
  out +=
      ".SH \"EXIT STATUS\"\n.TP\n.B 0\nDone.\n.TP\n.B 1\nThe input is wrong or the gears are "
      "impossible; the message names the key.\n.TP\n.B 2\nThe command line is wrong.\n.TP\n.B "
      "3\nThe system failed, for example because a file does not exist, the disk is full or there "
      "is not enough memory.\n.TP\n.B 4\nThe option \\-\\-strict is given, and the verdict is not "
      "green.\n.TP\n.B 5\nA defect in "
      "Gearwright; please report the message and the spec.\n.SH FILES\n.TP\n.I "
      ".gearwright_files\nThe list of files in the folder of a run. The next run removes each file "
      "of the list that it does\nnot write again, unless the file was changed.\n";
  return out;
}

}  // namespace gearwright::apps
