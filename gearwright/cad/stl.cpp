#include "gearwright/cad/stl.hpp"

#include "gearwright/base/contract.hpp"
#include "gearwright/base/little_endian.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kTriangleBytes = 50;

void append(std::string& out, const Eigen::Vector3f& v) {
  for (int i = 0; i < 3; ++i) append_f32(out, v[i]);
}

// Of the triangle as rounded, which is the one the reader sees.
Eigen::Vector3f facet_normal(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                             const Eigen::Vector3f& c) {
  const Vec3 edge = (b - a).cast<double>();
  return edge.cross((c - a).cast<double>()).normalized().cast<float>();
}

}  // namespace

std::string stl_bytes(const std::vector<MeshPart>& parts) {
  std::size_t count = 0;
  for (const MeshPart& part : parts) count += part.mesh.triangles.size();
  GW_EXPECTS(count <= 0xffffffffU);

  std::string out;
  out.reserve(kHeaderBytes + 4 + kTriangleBytes * count);
  out = "Gearwright, binary STL, mm:";  // must not begin with "solid", the mark of a text STL
  for (const MeshPart& part : parts) out += " " + part.name;
  out.resize(kHeaderBytes, ' ');
  append_u32(out, static_cast<std::uint32_t>(count));
  for (const MeshPart& part : parts) {
    std::vector<Eigen::Vector3f> vertices;
    vertices.reserve(part.mesh.vertices.size());
    for (const Vec3& v : part.mesh.vertices) vertices.emplace_back((part.pose * v).cast<float>());
    for (const Triangle& t : part.mesh.triangles) {
      const Eigen::Vector3f& a = vertices[t[0]];
      const Eigen::Vector3f& b = vertices[t[1]];
      const Eigen::Vector3f& c = vertices[t[2]];
      append(out, facet_normal(a, b, c));
      append(out, a);
      append(out, b);
      append(out, c);
      append_u16(out, 0);
    }
  }
  return out;
}

}  // namespace gearwright
