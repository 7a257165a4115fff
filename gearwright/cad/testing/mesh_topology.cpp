#include "gearwright/cad/testing/mesh_topology.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gearwright::testing {

Topology topology(const TriangleMesh& mesh) {
  Topology result;
  std::vector<std::uint64_t> edges;
  edges.reserve(3 * mesh.triangles.size());
  std::vector<std::uint32_t> leader(mesh.vertices.size());
  for (std::uint32_t i = 0; i < leader.size(); ++i) leader[i] = i;
  const auto find = [&](std::uint32_t i) {
    while (leader[i] != i) i = leader[i] = leader[leader[i]];
    return i;
  };
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      if (a == b) result.closed = false;
      edges.push_back((std::uint64_t{a} << 32U) | b);
      leader[find(a)] = find(b);
      used[a] = true;
    }
  }
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) result.closed = false;
  for (const std::uint64_t edge : edges) {
    const std::uint64_t opposite = (edge << 32U) | (edge >> 32U);
    if (!std::binary_search(edges.begin(), edges.end(), opposite)) result.closed = false;
  }
  int vertices = 0;
  for (std::uint32_t i = 0; i < used.size(); ++i) {
    if (!used[i]) {
      ++result.unused;
      continue;
    }
    ++vertices;
    if (find(i) == i) ++result.parts;
  }
  result.euler =
      vertices - static_cast<int>(edges.size() / 2) + static_cast<int>(mesh.triangles.size());
  return result;
}

Shading shading(const TriangleMesh& mesh) {
  Shading result;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const Triangle& s = mesh.shaded_triangles[i];
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3 facet = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).normalized();
    for (std::size_t j = 0; j < 3; ++j) {
      if (mesh.shaded_vertices[s[j]] != t[j]) result.same_corners = false;
      const Vec3& normal = mesh.normals[s[j]];
      result.length_error = std::max(result.length_error, std::abs(normal.norm() - 1.0));
      result.least_cosine = std::min(result.least_cosine, facet.dot(normal));
    }
  }
  return result;
}

}  // namespace gearwright::testing
