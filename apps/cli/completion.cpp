#include <fmt/format.h>

#include <vector>

#include "apps/cli/command_line.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/job/files.hpp"
#include "gearwright/job/verbs.hpp"

namespace gearwright::apps {

namespace {

std::vector<const CLI::Option*> options_of(const CLI::App& verb) {
  return verb.get_options([](const CLI::Option* o) { return o->nonpositional(); });
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

// Returns the words that may follow this verb on the command line, apart from a spec.
std::vector<std::string> words_after(const CLI::App& app, const CLI::App& verb) {
  const std::string& name = verb.get_name();
  if (name == "schema") return {"spec", "result"};
  if (name == "completion") return {"bash", "zsh", "fish"};
  std::vector<std::string> words;
  if (name == "batch")
    for (const Verb& answering : verbs()) words.emplace_back(answering.name);
  if (name == "help")
    for (const CLI::App* sub : verbs_of(app)) words.push_back(sub->get_name());
  return words;
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

std::string bash(const CLI::App& app) {
  std::vector<std::string> verbs{"help"};
  std::string cases;
  std::string values;
  for (const CLI::App* verb : verbs_of(app)) {
    verbs.push_back(verb->get_name());
    std::vector<std::string> options;
    for (const CLI::Option* o : options_of(*verb)) {
      const auto words = words_of(*o);
      for (const std::string& name : names_of(*o)) {
        options.push_back(name);
        if (!takes_value(*o)) continue;
        const std::string offer = !words.empty()    ? fmt::format("words='{}'", joined(words))
                                  : name == "--out" ? "compopt -o dirnames; return"
                                                    : "compopt -o default; return";
        values += fmt::format("    {}:{}) {} ;;\n", verb->get_name(), name, offer);
      }
    }
    cases += fmt::format("    {}) options='{}'; first='{}' ;;\n", verb->get_name(), joined(options),
                         joined(words_after(app, *verb)));
  }
  return fmt::format(
      R"sh(# bash completion of gearwright, made by `gearwright completion bash`
_gearwright() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} verb=${{COMP_WORDS[1]}}
  local options='' first='' words=''
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W '{0} --help --version' -- "$current"))
    return
  fi
  case $verb:$before in
{1}  esac
  if [ -n "$words" ]; then
    COMPREPLY=($(compgen -W "$words" -- "$current"))
    return
  fi
  case $verb in
    help) first='{0}' ;;
{2}  esac
  if [[ $current == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$current"))
    return
  fi
  [ -n "$first" ] && COMPREPLY=($(compgen -W "$first" -- "$current"))
  [ ${{#COMPREPLY[@]}} -eq 0 ] && compopt -o default
}}
complete -F _gearwright gearwright
)sh",
      joined(verbs), values, cases);
}

// Escapes a text for use inside brackets or quotes of zsh.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
      continue;
    }
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string zsh(const CLI::App& app) {
  std::string verbs = "    'help:Describe a verb'\n";
  std::string cases;
  for (const CLI::App* verb : verbs_of(app)) {
    verbs += fmt::format("    '{}:{}'\n", verb->get_name(), zsh_text(verb->get_description()));
    std::string arguments;
    for (const CLI::Option* o : options_of(*verb)) {
      const auto words = words_of(*o);
      const std::string value = !takes_value(*o) ? ""
                                : !words.empty() ? fmt::format(":value:({})", joined(words))
                                                 : ":value:_files";
      for (const std::string& name : names_of(*o))
        arguments +=
            fmt::format(" \\\n        '{}[{}]{}'", name, zsh_text(o->get_description()), value);
    }
    const auto first = words_after(app, *verb);
    arguments += first.empty()
                     ? " \\\n        '*:file:_files'"
                     : fmt::format(" \\\n        '1:word:({})' '*:file:_files'", joined(first));
    cases += fmt::format("      {})\n        _arguments{} ;;\n", verb->get_name(), arguments);
  }
  return fmt::format(
      R"sh(#compdef gearwright
# zsh completion of gearwright, made by `gearwright completion zsh`
_gearwright() {{
  local -a verbs
  verbs=(
{0}  )
  _arguments -C '(-h --help)'{{-h,--help}}'[Help]' '(-V --version)'{{-V,--version}}'[Version]' \
    '1:verb:->verb' '*::argument:->argument'
  case $state in
    verb) _describe verb verbs ;;
    argument)
      case $words[1] in
      help) _describe verb verbs ;;
{1}      esac ;;
  esac
}}
if [ "$funcstack[1]" = _gearwright ]; then _gearwright "$@"; else compdef _gearwright gearwright; fi
)sh",
      verbs, cases);
}

std::string fish_text(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return out;
}

std::string fish(const CLI::App& app) {
  std::string out =
      "# fish completion of gearwright, made by `gearwright completion fish`\ncomplete -c "
      "gearwright -n __fish_use_subcommand -f -a help -d 'Describe a verb'\n";
  for (const CLI::App* verb : verbs_of(app)) {
    const std::string& name = verb->get_name();
    out += fmt::format("complete -c gearwright -n __fish_use_subcommand -f -a {} -d '{}'\n", name,
                       fish_text(verb->get_description()));
    const std::string of =
        fmt::format("complete -c gearwright -n '__fish_seen_subcommand_from {}'", name);
    if (const auto first = words_after(app, *verb); !first.empty())
      out += fmt::format("{} -a '{}'\n", of, joined(first));
    out += fmt::format("complete -c gearwright -n '__fish_seen_subcommand_from help' -f -a {}\n",
                       name);
    for (const CLI::Option* o : options_of(*verb)) {
      const auto words = words_of(*o);
      std::string line = of;
      for (const std::string& n : o->get_snames()) line += " -s " + n;
      for (const std::string& n : o->get_lnames()) line += " -l " + n;
      if (takes_value(*o))
        line += words.empty() ? " -r" : fmt::format(" -x -a '{}'", joined(words));
      out += fmt::format("{} -d '{}'\n", line, fish_text(o->get_description()));
    }
  }
  return out;
}

}  // namespace

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> words_of(const CLI::Option& option) {
  const std::string name = option.get_lnames().empty() ? "" : option.get_lnames().front();
  if (name == "gear") return {"1", "2"};
  if (name == "only") return {kRunParts.begin(), kRunParts.end()};
  return {};
}

std::string completion(const std::string& shell, const CLI::App& app) {
  GW_EXPECTS(shell == "bash" || shell == "zsh" || shell == "fish");
  return shell == "bash" ? bash(app) : shell == "zsh" ? zsh(app) : fish(app);
}

}  // namespace gearwright::apps
