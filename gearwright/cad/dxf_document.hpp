// Writes a DXF file. The file contains the entities, and all other sections that readers of AutoCAD
// 2000 drawings require.
//
// DXF is a list of pairs. Each pair is a group code on one line and a value on the next line. Every
// object has a handle (code 5, hexadecimal) and names its owner (code 330). The owner of the
// entities is *Model_Space. The sections are HEADER, CLASSES, TABLES, BLOCKS, ENTITIES and OBJECTS
// (Autodesk, DXF Reference, AutoCAD 2000).
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "gearwright/cad/sheet.hpp"

namespace gearwright {

/// Collects entities. Coordinates are in mm in the xy plane.
class DxfEntities {
 public:
  /// Sets the pose of all entities that are added afterwards. Before the first call, the pose is
  /// the identity.
  void place(const Eigen::Isometry2d& pose) { pose_ = pose; }
  /// Adds an LWPOLYLINE. bulges[i] belongs to the segment from points[i] to the next point. If
  /// there are as many bulges as points, the polyline is closed, and the last bulge leads to the
  /// first point. If the polyline is open, there is one bulge fewer.
  void polyline(const std::string& layer, const std::vector<Vec2>& points,
                const std::vector<double>& bulges);
  void circle(const std::string& layer, double radius, const Vec2& center = Vec2::Zero());
  void line(const std::string& layer, const Vec2& a, const Vec2& b);
  /// Adds a SOLID, a filled triangle.
  void triangle(const std::string& layer, const Vec2& a, const Vec2& b, const Vec2& c);
  /// Adds a TEXT whose base line starts at `at`. `height` is the height of capitals. `degrees` is
  /// the angle of the base line, counter-clockwise from the x axis.
  void text(const std::string& layer, const Vec2& at, const std::string& utf8, double height,
            double degrees);
  /// Adds an arc about the origin from `begin` to `end` as a rational quadratic SPLINE. `sweep` is
  /// the angle of the arc, rad. The spline is exact and ends at the given points. An ARC entity, in
  /// contrast, stores its ends only as angles in degrees.
  void circular_spline(const std::string& layer, const Vec2& begin, const Vec2& end, double sweep);
  /// Writes a clamped non-rational SPLINE.
  void spline(const std::string& layer, int degree, const std::vector<double>& knots,
              const std::vector<Vec2>& poles);

  const std::string& text() const { return text_; }
  int next_handle() const { return handle_; }
  bool has_words() const { return has_words_; }

 private:
  Vec2 at(const Vec2& p) const { return pose_ * p; }
  void begin(const char* type, const std::string& layer, const char* subclass);

  std::string text_;
  Eigen::Isometry2d pose_ = Eigen::Isometry2d::Identity();
  int handle_ = 0x100;  // smaller handles belong to the sections around the entities
  bool has_words_ = false;
};

struct DxfLayer {
  std::string name;
  int color;            ///< AutoCAD colour index
  int line_width = -3;  ///< hundredths of a mm; −3 selects the default of the reader
  bool chain = false;   ///< true for the line type CENTER, which has long dashes and dots
};

/// Returns the whole file. `extent` is a box around all entities. Text has the style SHEET with the
/// font Arial, whose letters are as wide as those of Helvetica.
std::string dxf_document(const DxfEntities& entities, const std::vector<DxfLayer>& layers,
                         const SheetBox& extent);
/// Returns the whole file. All entities lie within a square about the origin. `reach` is half the
/// side of this square, mm.
inline std::string dxf_document(const DxfEntities& entities, const std::vector<DxfLayer>& layers,
                                double reach) {
  return dxf_document(entities, layers, {{-reach, -reach}, {reach, reach}});
}

}  // namespace gearwright
