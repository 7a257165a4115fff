#include "gearwright/cad/glb.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/little_endian.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/cad/toothed_body.hpp"

namespace gearwright {

namespace {

// glTF's numbers for component types and buffer targets.
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;

std::string json_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      out += c;
    }
  }
  return out + "\"";
}

// Shortest decimal of the float itself: a reader gets the same float.
std::string json_vector(const Eigen::Vector3f& v) {
  return fmt::format("[{},{},{}]", v.x(), v.y(), v.z());
}

// Column by column, as glTF stores it; nothing for the identity, its default.
std::string json_matrix(const Eigen::Isometry3d& pose) {
  Eigen::Matrix4d m = pose.matrix();
  m.topRightCorner<3, 1>() *= kMetresPerMm;
  if (m == Eigen::Matrix4d::Identity()) return "";
  std::string numbers;
  for (int i = 0; i < 16; ++i) {
    const double value = m(i % 4, i / 4);
    numbers += fmt::format("{}{}", i == 0 ? "" : ",", value == 0.0 ? 0.0 : value);
  }
  return ",\"matrix\":[" + numbers + "]";
}

// The lists of the JSON chunk, grown part by part beside the binary chunk.
struct Lists {
  std::string nodes, roots, meshes, materials, accessors, views;
  int view_count = 0;

  static void add(std::string& list, const std::string& item) {
    if (!list.empty()) list += ',';
    list += item;
  }

  int add_view(std::size_t begin, std::size_t end, int target) {
    add(views, fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{},"target":{}}})", begin,
                           end - begin, target));
    return view_count++;
  }
};

void add_part(const MeshPart& part, std::size_t index, Lists& lists, std::string& binary) {
  const TriangleMesh& mesh = part.mesh;
  const std::size_t corners = 3 * mesh.shaded_triangles.size();
  const std::size_t shaded = mesh.shaded_vertices.size();

  std::size_t begin = binary.size();
  for (const Triangle& t : mesh.shaded_triangles) {
    for (const std::uint32_t corner : t) append_u32(binary, corner);
  }
  // One accessor per view, so that their numbers agree.
  const int indices = lists.add_view(begin, binary.size(), kElementArrayBuffer);
  Lists::add(lists.accessors,
             fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"SCALAR"}})",
                         indices, kUnsignedInt, corners));

  begin = binary.size();
  Eigen::Array3f low = Eigen::Array3f::Constant(std::numeric_limits<float>::infinity());
  Eigen::Array3f high = -low;
  for (const std::uint32_t vertex : mesh.shaded_vertices) {
    const Eigen::Vector3f p = (kMetresPerMm * mesh.vertices[vertex]).cast<float>();
    low = low.min(p.array());
    high = high.max(p.array());
    for (int i = 0; i < 3; ++i) append_f32(binary, p[i]);
  }
  const int positions = lists.add_view(begin, binary.size(), kArrayBuffer);
  Lists::add(
      lists.accessors,
      fmt::format(
          R"({{"bufferView":{},"componentType":{},"count":{},"type":"VEC3","min":{},"max":{}}})",
          positions, kFloat, shaded, json_vector(low), json_vector(high)));

  begin = binary.size();
  for (const Vec3& n : mesh.normals) {
    for (int i = 0; i < 3; ++i) append_f32(binary, static_cast<float>(n[i]));
  }
  const int normals = lists.add_view(begin, binary.size(), kArrayBuffer);
  Lists::add(lists.accessors,
             fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"VEC3"}})",
                         normals, kFloat, shaded));

  const std::string name = json_string(part.name);
  const std::array<double, 3>& colour = part_colour(index);
  Lists::add(lists.roots, fmt::format("{}", index));
  Lists::add(lists.nodes,
             fmt::format(R"({{"name":{},"mesh":{}{}}})", name, index, json_matrix(part.pose)));
  Lists::add(
      lists.meshes,
      fmt::format(
          R"({{"name":{},"primitives":[{{"attributes":{{"POSITION":{},"NORMAL":{}}},"indices":{},"material":{}}}]}})",
          name, positions, normals, indices, index));
  Lists::add(
      lists.materials,
      fmt::format(
          R"({{"name":{},"pbrMetallicRoughness":{{"baseColorFactor":[{},{},{},1],"metallicFactor":0.6,"roughnessFactor":0.45}}}})",
          name, colour[0], colour[1], colour[2]));
}

void append_chunk(std::string& out, const char (&type)[5], const std::string& content) {
  append_u32(out, static_cast<std::uint32_t>(content.size()));
  out.append(type, 4);
  out += content;
}

}  // namespace

std::string glb_bytes(const std::vector<MeshPart>& parts) {
  GW_EXPECTS(!parts.empty());
  Lists lists;
  std::string binary;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    GW_EXPECTS(!parts[i].mesh.triangles.empty());
    add_part(parts[i], i, lists, binary);
  }
  // All entries are 4 bytes wide: the binary chunk needs no padding, the text is padded by blanks.
  std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0","generator":"Gearwright"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],"meshes":[{}],"materials":[{}],"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
      lists.roots, lists.nodes, lists.meshes, lists.materials, lists.accessors, lists.views,
      binary.size());
  while (json.size() % 4 != 0) json += ' ';

  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kChunkHeader = 8;
  const std::size_t total = kHeader + 2 * kChunkHeader + json.size() + binary.size();
  GW_EXPECTS(total <= 0xffffffffU);
  std::string out;
  out.reserve(total);
  out += "glTF";
  append_u32(out, 2);
  append_u32(out, static_cast<std::uint32_t>(total));
  append_chunk(out, "JSON", json);
  append_chunk(out, {'B', 'I', 'N', '\0', '\0'}, binary);
  return out;
}

}  // namespace gearwright
