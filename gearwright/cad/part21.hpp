// Writes Part 21 (ISO 10303-21), the text format of STEP files. The text consists of numbered
// instances of entities.
//
//   #12=CARTESIAN_POINT('',(18.504065825396,-6.327244292546,-12.5));
//
// An instance refers to other instances by their numbers. Every instance is written after all
// instances to which it refers. Internal to cad/.
//
//   Laws  (1) a real has the fewest digits that a reader converts back to the same double
//         (2) text can be read back unchanged, because all characters except printable ASCII are
//             escaped according to the standard
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/vector.hpp"

namespace gearwright {

/// Number of an instance. 0 means none.
using Part21Id = std::uint32_t;

/// Appends a real in the form of the standard. It always has a decimal point, and the exponent has
/// a capital E. −0 is written as 0.   Domain    finite (contract)
void append_real(std::string& text, double value);

/// Returns a string in apostrophes. The characters ' and \ are doubled. All characters outside
/// ASCII 32 to 126 are written as \X2\03B1\X0\ (code points of 16 bits) or \X4\0001F600\X0\ (other
/// code points).
///
/// Domain    any bytes; each byte that is not valid UTF-8 becomes U+FFFD
std::string part21_string(std::string_view utf8);

/// A Part 21 file, which consists of a header and of the instances of its data section, one per
/// line.
class Part21 {
 public:
  explicit Part21(std::string_view header);

  /// Writes `#n=` … `;` around an entity and its arguments, and returns n.
  Part21Id add(std::string_view entity);

  Part21Id point(const Vec3& p);
  Part21Id direction(const Vec3& d);
  /// Adds an AXIS2_PLACEMENT_3D.
  Part21Id placement(Part21Id origin, Part21Id z, Part21Id x);

  std::string finish() &&;

 private:
  Part21Id triple(std::string_view keyword, const Vec3& v);
  void begin();

  std::string text_;
  Part21Id last_ = 0;
};

/// Appends references, such as "(#4,#5)", with at most twelve in a line.
void append_ids(std::string& text, const std::vector<Part21Id>& ids);
void append_reals(std::string& text, const std::vector<double>& values);
void append_integers(std::string& text, const std::vector<int>& values);

}  // namespace gearwright
