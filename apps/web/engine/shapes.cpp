#include "apps/web/engine/shapes.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/figure/figure_data.hpp"
#include "gearwright/figure/figure_svg.hpp"

namespace gearwright::web {

namespace {

template <class T>
Json binary(const T* data, std::size_t count, RowType type) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(data);
  return Json::binary(std::vector<std::uint8_t>(bytes, bytes + count * sizeof(T)),
                      static_cast<std::uint8_t>(type));
}

}  // namespace

Json row(const Numbers& numbers) {
  return binary(numbers.data(), numbers.size(), RowType::float64);
}
Json row(const std::vector<float>& numbers) {
  return binary(numbers.data(), numbers.size(), RowType::float32);
}
Json row(const std::vector<std::uint32_t>& numbers) {
  return binary(numbers.data(), numbers.size(), RowType::uint32);
}
Json row(std::string_view bytes) { return binary(bytes.data(), bytes.size(), RowType::uint8); }

Json shape(const FlankRaster& raster) {
  return {
      {"diameter", row(raster.diameter)}, {"height", row(raster.height)}, {"gap", row(raster.gap)}};
}

Json shape(const TriangleMesh& mesh, double tolerance) {
  std::vector<float> positions, normals;
  std::vector<std::uint32_t> indices;
  positions.reserve(3 * mesh.shaded_vertices.size());
  normals.reserve(3 * mesh.normals.size());
  indices.reserve(3 * mesh.shaded_triangles.size());
  const auto put = [](std::vector<float>& to, const Vec3& v) {
    for (const double x : {v.x(), v.y(), v.z()}) to.push_back(static_cast<float>(x));
  };
  for (const std::uint32_t v : mesh.shaded_vertices) put(positions, mesh.vertices[v]);
  for (const Vec3& n : mesh.normals) put(normals, n);
  for (const Triangle& t : mesh.shaded_triangles) indices.insert(indices.end(), t.begin(), t.end());
  return {{"positions", row(positions)},
          {"normals", row(normals)},
          {"indices", row(indices)},
          {"toleranceMm", tolerance}};
}

Json shape(const SolidPose& pose) {
  return row(Numbers(pose.isometry().data(), pose.isometry().data() + 16));
}

Json shape(const Figure& figure, double width) {
  width = std::clamp(width, 280.0, 1400.0);
  return {{"id", figure.id},
          {"html", figure.plane ? figure_svg(figure, width) : figure_html(figure, width)},
          {"data", figure_data(figure)}};
}

}  // namespace gearwright::web
