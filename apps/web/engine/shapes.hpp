// Converts data of the engine to JSON trees for a page. A row of numbers is stored as binary data
// in the tree, from which the page makes a typed array.
//
// Trees can be made and tested without a browser. bindings.cpp converts them to JavaScript values.
// engine.d.ts describes the names and meanings of their members.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/mesh.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/contact/pattern.hpp"
#include "gearwright/figure/figure.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright::web {

using Numbers = std::vector<double>;  ///< kNoNumber stands for a missing value

/// The kind of typed array that a row becomes in JavaScript. It is stored as the subtype of the
/// binary data of the row.
enum class RowType : std::uint8_t { float64, float32, uint32, uint8 };
Json row(const Numbers& numbers);
Json row(const std::vector<float>& numbers);
Json row(const std::vector<std::uint32_t>& numbers);
Json row(std::string_view bytes);

Json shape(const FlankRaster& raster);
Json shape(const TriangleMesh& mesh, double tolerance);
/// Returns a pose as a column-major 4×4 matrix, as three.js requires.
Json shape(const SolidPose& pose);
/// Returns a figure `width` px wide (280 to 1400 px), with its caption as HTML and its data.
/// Figures of gears in section have no caption.
Json shape(const Figure& figure, double width);

}  // namespace gearwright::web
