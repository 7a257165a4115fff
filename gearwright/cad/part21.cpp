#include "gearwright/cad/part21.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/printable.hpp"

namespace gearwright {
namespace {

constexpr std::size_t kIdsPerLine = 12;

void append_integer(std::string& text, std::uint64_t value) {
  const fmt::format_int digits(value);
  text.append(digits.data(), digits.size());
}

enum class Alphabet { plain, two_bytes, four_bytes };

Alphabet alphabet_of(char32_t code) {
  if (code >= 0x20 && code < 0x7F) return Alphabet::plain;
  return code <= 0xFFFF ? Alphabet::two_bytes : Alphabet::four_bytes;
}

void append_id(std::string& text, Part21Id id) {
  GW_EXPECTS(id != 0);
  text += '#';
  append_integer(text, id);
}

}  // namespace

void append_real(std::string& text, double value) {
  GW_EXPECTS(std::isfinite(value));
  std::array<char, 32> buffer;
  char* const end = fmt::format_to(buffer.data(), FMT_COMPILE("{}"), value + 0.0);
  bool point = false;
  for (const char* c = buffer.data(); c != end; ++c) {
    if (*c == '.') point = true;
    if (*c == 'e') {
      text += point ? "E" : ".E";
      point = true;
    } else {
      text += *c;
    }
  }
  if (!point) text += '.';
}

std::string part21_string(std::string_view utf8) {
  std::string text = "'";
  Alphabet open = Alphabet::plain;
  for (const char32_t code : code_points(utf8)) {
    const Alphabet wanted = alphabet_of(code);
    if (wanted != open) {
      if (open != Alphabet::plain) text += "\\X0\\";
      if (wanted == Alphabet::two_bytes) text += "\\X2\\";
      if (wanted == Alphabet::four_bytes) text += "\\X4\\";
      open = wanted;
    }
    const auto number = static_cast<std::uint32_t>(code);
    switch (wanted) {
      case Alphabet::plain:
        if (code == '\'' || code == '\\') text += static_cast<char>(code);
        text += static_cast<char>(code);
        break;
      case Alphabet::two_bytes: text += fmt::format("{:04X}", number); break;
      case Alphabet::four_bytes: text += fmt::format("{:08X}", number); break;
    }
  }
  if (open != Alphabet::plain) text += "\\X0\\";
  return text + "'";
}

void append_ids(std::string& text, const std::vector<Part21Id>& ids) {
  char separator = '(';
  for (std::size_t i = 0; i < ids.size(); ++i) {
    text += separator;
    if (i > 0 && i % kIdsPerLine == 0) text += '\n';
    append_id(text, ids[i]);
    separator = ',';
  }
  text += ')';
}

void append_reals(std::string& text, const std::vector<double>& values) {
  char separator = '(';
  for (const double value : values) {
    text += separator;
    append_real(text, value);
    separator = ',';
  }
  text += ')';
}

void append_integers(std::string& text, const std::vector<int>& values) {
  text += fmt::format("({})", fmt::join(values, ","));
}

Part21::Part21(std::string_view header) {
  text_ = "ISO-10303-21;\nHEADER;\n";
  text_ += header;
  text_ += "ENDSEC;\nDATA;\n";
}

std::string Part21::finish() && {
  text_ += "ENDSEC;\nEND-ISO-10303-21;\n";
  return std::move(text_);
}

void Part21::begin() {
  append_id(text_, ++last_);
  text_ += '=';
}

Part21Id Part21::add(std::string_view entity) {
  begin();
  text_ += entity;
  text_ += ";\n";
  return last_;
}

Part21Id Part21::triple(std::string_view keyword, const Vec3& v) {
  begin();
  text_ += keyword;
  for (int i = 0; i < 3; ++i) {
    text_ += i == 0 ? '(' : ',';
    append_real(text_, v[i]);
  }
  text_ += "));\n";
  return last_;
}

Part21Id Part21::point(const Vec3& p) { return triple("CARTESIAN_POINT('',", p); }

Part21Id Part21::direction(const Vec3& d) { return triple("DIRECTION('',", d); }

Part21Id Part21::placement(Part21Id origin, Part21Id z, Part21Id x) {
  return add(fmt::format("AXIS2_PLACEMENT_3D('',#{},#{},#{})", origin, z, x));
}

}  // namespace gearwright
