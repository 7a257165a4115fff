// Reads the HTML that report/ writes. The reader is stricter than HTML itself where this makes it
// simpler, so every HTML reader interprets an accepted page in the same way.
//
//   Tags must balance, except void elements. Attributes must be double-quoted and unique in their
//   element. In text, the characters '<', '>' and '&' may appear only as references. Ids must be
//   unique, and the id of every #reference must exist.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace gearwright::testing {

struct HtmlFacts {
  std::vector<std::string> faults;      ///< empty if well-formed
  std::map<std::string, int> elements;  ///< number of each element
  std::set<std::string> ids;
  std::vector<std::string> links;  ///< values of href and src
};

class StrictHtml {
 public:
  static HtmlFacts read(std::string_view page) {
    StrictHtml reader(page);
    reader.run();
    return std::move(reader.facts_);
  }

 private:
  explicit StrictHtml(std::string_view page) : page_(page) {}

  static bool is_void(const std::string& name) {
    return name == "meta" || name == "br" || name == "hr" || name == "img" || name == "link" ||
           name == "input";
  }
  static bool is_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == ':';
  }
  void fault(const std::string& what) {
    facts_.faults.push_back(what + " near: " + std::string(page_.substr(at_, 40)));
  }
  bool end() const { return at_ >= page_.size(); }

  void run() {
    constexpr std::string_view kDoctype = "<!DOCTYPE html>\n";
    if (page_.substr(0, kDoctype.size()) != kDoctype) fault("no doctype");
    at_ = kDoctype.size();
    while (!end() && facts_.faults.size() < 20) {
      if (page_[at_] == '<') {
        tag();
      } else {
        text_character();
      }
    }
    for (const std::string& name : open_) fault("not closed: " + name);
    for (const std::string& id : wanted_) {
      if (facts_.ids.count(id) == 0) fault("no such id: " + id);
    }
  }

  void text_character() {
    const char c = page_[at_];
    if (c == '>') fault("bare >");
    if (c == '&') reference();
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 && c != '\n' && c != '\t') fault("control character");
    ++at_;
  }
  void reference() {
    const std::size_t stop = page_.find(';', at_);
    const std::string_view name = page_.substr(at_, stop == page_.npos ? 1 : stop + 1 - at_);
    for (const std::string_view known : {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"}) {
      if (name == known) return;
    }
    fault("unknown reference");
  }

  void tag() {
    ++at_;
    const bool closing = !end() && page_[at_] == '/';
    if (closing) ++at_;
    std::string name;
    while (!end() && is_name(page_[at_])) name += page_[at_++];
    if (name.empty()) return fault("bare <");
    if (closing) {
      if (end() || page_[at_] != '>') return fault("bad closing tag");
      ++at_;
      if (open_.empty() || open_.back() != name) return fault("closes what is not open: " + name);
      open_.pop_back();
      return;
    }
    ++facts_.elements[name];
    const bool self_closing = attributes();
    if (self_closing || is_void(name)) return;
    if (name == "script" || name == "style") {
      const std::size_t stop = page_.find("</" + name + ">", at_);
      if (stop == page_.npos) return fault("raw text without an end");
      at_ = stop;
    }
    open_.push_back(name);
  }

  // Reads attributes up to and including '>'. Returns true if the tag ends with "/>".
  bool attributes() {
    std::set<std::string> seen;
    while (!end()) {
      if (page_[at_] == ' ') {
        ++at_;
        continue;
      }
      if (page_[at_] == '>') {
        ++at_;
        return false;
      }
      if (page_.substr(at_, 2) == "/>") {
        at_ += 2;
        return true;
      }
      std::string name;
      while (!end() && is_name(page_[at_])) name += page_[at_++];
      if (name.empty()) {
        fault("bad attribute");
        ++at_;
        return false;
      }
      if (!seen.insert(name).second) fault("attribute twice: " + name);
      if (end() || page_[at_] != '=') continue;
      if (page_.substr(at_, 2) != "=\"") {
        fault("attribute without quotes");
        ++at_;
        continue;
      }
      at_ += 2;
      const std::size_t stop = page_.find('"', at_);
      if (stop == page_.npos) {
        fault("attribute without an end");
        at_ = page_.size();
        return false;
      }
      const std::string value(page_.substr(at_, stop - at_));
      if (value.find('<') != value.npos) fault("< in an attribute");
      note(name, value);
      at_ = stop + 1;
    }
    return false;
  }

  void note(const std::string& name, const std::string& value) {
    if (name == "id" && !facts_.ids.insert(value).second) fault("id twice: " + value);
    if (name == "href" || name == "src") {
      facts_.links.push_back(value);
      if (value.substr(0, 1) == "#") wanted_.insert(value.substr(1));
    }
    if (value.rfind("url(#", 0) == 0) wanted_.insert(value.substr(5, value.size() - 6));
    if (name == "aria-labelledby") {
      std::size_t from = 0;
      while (from < value.size()) {
        const std::size_t stop = std::min(value.find(' ', from), value.size());
        wanted_.insert(value.substr(from, stop - from));
        from = stop + 1;
      }
    }
  }

  std::string_view page_;
  std::size_t at_ = 0;
  std::vector<std::string> open_;
  std::set<std::string> wanted_;
  HtmlFacts facts_;
};

}  // namespace gearwright::testing
