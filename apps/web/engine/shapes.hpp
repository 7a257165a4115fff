// What the engine hands to a page beside JSON: numbers in rows, ready for buffers.
//
// Plain values of the standard library, so that they are made and tested without a browser;
// bindings.cpp turns them into JavaScript's. What each means: engine.d.ts, under the same names.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "gearwright/contact/pattern.hpp"

namespace gearwright::web {

using Numbers = std::vector<double>;
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();  ///< nothing there

struct Section {
  struct Piece {
    std::string name;
    int tooth;
    bool land;
    int from, to;  // points
  };
  struct Circle {
    std::string key, symbol, words;
    double radius;  // mm
  };
  int teeth;
  bool internal;
  Numbers outline;  // x, y, …, mm
  std::vector<Piece> pieces;
  Numbers bore;
  std::vector<Circle> circles;
  double tolerance;  // mm
};

struct Mesh {
  std::vector<float> positions, normals;
  std::vector<std::uint32_t> indices;
  double tolerance;  // mm
};

struct MeshLines {
  struct Mark {
    std::string name;
    std::array<double, 3> at;
  };
  std::string kind;
  double center_distance, shaft_angle_deg;
  Numbers line_of_action, trailing_line, path_of_contact;  // x, y, z, …
  std::vector<Mark> points;
};

struct ContactCurve {
  struct Column {
    int width;
    std::variant<Numbers, std::vector<std::string>> values;
  };
  int n;
  std::map<std::string, Column> columns;
  double peak_to_peak_arcsec, mean_slope;
  Numbers harmonics_arcsec;
  bool contact_lost;
  std::string words;  // what it comes to
};

struct ErrorMapGrid {
  Numbers x, y, peak_to_peak_arcsec;  // [iy·nx + ix]; NaN: nothing touches, or not done yet
};

struct ShiftChart {
  struct Border {
    std::string name;
    Numbers points;
  };
  std::array<double, 2> point;
  bool inside;
  double margin;
  std::string stopped_by;
  double area;
  std::vector<std::vector<Border>> pieces;
  std::map<std::string, std::string> borders;
  std::array<double, 4> window;
  std::vector<double> chosen;  // two, or none
  std::string what_kills;
};

struct Steps {  // of a Work
  std::int64_t done, of;
  bool finished;
};

}  // namespace gearwright::web
