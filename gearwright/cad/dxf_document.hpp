// The frame of a DXF file: the sections around the entities that readers of AutoCAD 2000 drawings
// require.
//
// DXF is a list of pairs, a group code on one line and its value on the next. Every object carries
// a handle (code 5, hexadecimal) and names its owner (330); entities belong to *Model_Space.
// Sections: HEADER, CLASSES, TABLES, BLOCKS, ENTITIES, OBJECTS
// (Autodesk, DXF Reference, AutoCAD 2000).
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "gearwright/cad/sheet.hpp"

namespace gearwright {

/// Collects entities. Coordinates are in mm in the xy plane. Only the file has angles in degrees.
class DxfEntities {
 public:
  /// Sets the position of the following entities: a rotation about z and a shift in the plane. Without
  /// a position, coordinates are unchanged.
  void place(const Eigen::Isometry3d& pose);
  /// LWPOLYLINE. bulges[i] leads from points[i] to the next point. If there are as many bulges as
  /// points, the polyline is closed and the last bulge leads to the first point. Otherwise there is
  /// one bulge fewer.
  void polyline(const std::string& layer, const std::vector<Vec2>& points,
                const std::vector<double>& bulges);
  void circle(const std::string& layer, double radius, const Vec2& center = Vec2::Zero());
  void line(const std::string& layer, const Vec2& a, const Vec2& b);
  /// SOLID, a filled triangle.
  void triangle(const std::string& layer, const Vec2& a, const Vec2& b, const Vec2& c);
  /// TEXT with the left end of its base line at `at`; `height` of capitals, `degrees`
  /// counter-clockwise.
  void text(const std::string& layer, const Vec2& at, const std::string& utf8, double height,
            double degrees);
  /// An arc about the origin from `begin` to `end`, `sweep` rad, as a rational quadratic SPLINE. It
  /// is exact and its ends are the given points, whereas an ARC entity stores its ends only as
  /// angles in degrees.
  void circular_spline(const std::string& layer, const Vec2& begin, const Vec2& end, double sweep);
  /// Writes a clamped non-rational SPLINE.
  void spline(const std::string& layer, int degree, const std::vector<double>& knots,
              const std::vector<Vec2>& poles);

  const std::string& text() const { return text_; }
  int next_handle() const { return handle_; }
  bool has_words() const { return has_words_; }

 private:
  Vec2 at(const Vec2& p) const { return moved_ ? Vec2(pose_ * p) : p; }
  void begin(const char* type, const std::string& layer, const char* subclass);

  std::string text_;
  bool moved_ = false;  // if false, points are written unchanged, to the bit
  Eigen::Isometry2d pose_ = Eigen::Isometry2d::Identity();
  int handle_ = 0x100;  // smaller handles belong to the frame
  bool has_words_ = false;
};

struct DxfLayer {
  std::string name;
  int color;            ///< AutoCAD colour index
  int line_width = -3;  ///< hundredths of a mm; -3: the reader's default
  bool chain = false;   ///< line type CENTER, long dashes and dots
};

/// Returns the whole file. `extent` contains everything. Words use the style SHEET with Arial,
/// whose letters have the widths of Helvetica.
std::string dxf_document(const DxfEntities& entities, const std::vector<DxfLayer>& layers,
                         const SheetBox& extent);
/// `reach`: half the side of the square about the origin that contains everything, mm.
inline std::string dxf_document(const DxfEntities& entities, const std::vector<DxfLayer>& layers,
                                double reach) {
  return dxf_document(entities, layers, {{-reach, -reach}, {reach, reach}});
}

}  // namespace gearwright
