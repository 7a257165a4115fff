#include "gearwright/cad/mesh_files.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <array>
#include <iterator>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/little_endian.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/base/zip.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kTriangleBytes = 50;

void append(std::string& out, const Eigen::Vector3f& v) {
  for (int i = 0; i < 3; ++i) append_f32(out, v[i]);
}

// Returns the normal of a triangle whose corners are rounded to float32, as in the file.
Eigen::Vector3f facet_normal(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                             const Eigen::Vector3f& c) {
  const Vec3 edge = (b - a).cast<double>();
  return edge.cross((c - a).cast<double>()).normalized().cast<float>();
}

constexpr const char* kContentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";

constexpr const char* kRelationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

constexpr const char* kModelHead =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Application">Gearwright</metadata>
<resources>
)";

void append_object(std::string& xml, const MeshPart& part, std::size_t id) {
  xml += fmt::format("<object id=\"{}\" type=\"model\" name=\"{}\"><mesh><vertices>\n", id,
                     escaped(part.name));
  const auto out = std::back_inserter(xml);
  for (const Vec3& v : part.mesh.vertices) {
    fmt::format_to(out, FMT_COMPILE("<vertex x=\"{:.9g}\" y=\"{:.9g}\" z=\"{:.9g}\"/>\n"), v.x(),
                   v.y(), v.z());
  }
  xml += "</vertices><triangles>\n";
  for (const Triangle& t : part.mesh.triangles) {
    fmt::format_to(out, FMT_COMPILE("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n"), t[0], t[1],
                   t[2]);
  }
  xml += "</triangles></mesh></object>\n";
}

// 3MF multiplies row vectors by the matrix. The file therefore contains the images of the three
// axes first, and then the image of the origin.
std::string transform(const SolidPose& pose) {
  std::string out;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      const double value = pose.isometry().matrix()(row, column);
      out += fmt::format("{}{}", out.empty() ? "" : " ", value == 0.0 ? 0.0 : value);
    }
  }
  return out;
}

// Numbers that glTF defines for component types and buffer targets.
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

// Writes the shortest decimals that a reader converts back to the same floats.
std::string json_vector(const Eigen::Vector3f& v) {
  return fmt::format("[{},{},{}]", v.x(), v.y(), v.z());
}

// Writes the matrix by columns, as glTF requires. The text is empty for the identity, which is the
// default of glTF.
std::string json_matrix(const SolidPose& pose) {
  Eigen::Matrix4d m = pose.isometry().matrix();
  m.topRightCorner<3, 1>() *= kMetresPerMm;
  if (m == Eigen::Matrix4d::Identity()) return "";
  std::string numbers;
  for (int i = 0; i < 16; ++i) {
    const double value = m(i % 4, i / 4);
    numbers += fmt::format("{}{}", i == 0 ? "" : ",", value == 0.0 ? 0.0 : value);
  }
  return ",\"matrix\":[" + numbers + "]";
}

// The lists of the JSON chunk. They are extended part by part together with the binary chunk.
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

// Returns the mesh of a part. If the part shares the mesh of an earlier part, returns that mesh.
const TriangleMesh& mesh_of(const std::vector<MeshPart>& parts, std::size_t i) {
  return parts[parts[i].same_as.value_or(i)].mesh;
}

void add_node(const MeshPart& part, std::size_t node, std::size_t mesh, Lists& lists) {
  Lists::add(lists.roots, fmt::format("{}", node));
  Lists::add(lists.nodes, fmt::format(R"({{"name":{},"mesh":{}{}}})", json_string(part.name), mesh,
                                      json_matrix(part.pose)));
}

// Adds the mesh and the material of a part. Both get the number `index`.
void add_mesh(const MeshPart& part, std::size_t index, std::size_t colour_index, Lists& lists,
              std::string& binary) {
  const TriangleMesh& mesh = part.mesh;
  const std::size_t corners = 3 * mesh.shaded_triangles.size();
  const std::size_t shaded = mesh.shaded_vertices.size();

  std::size_t begin = binary.size();
  for (const Triangle& t : mesh.shaded_triangles) {
    for (const std::uint32_t corner : t) append_u32(binary, corner);
  }
  // Each view has one accessor, so view and accessor have the same number.
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
    append(binary, p);
  }
  const int positions = lists.add_view(begin, binary.size(), kArrayBuffer);
  Lists::add(
      lists.accessors,
      fmt::format(
          R"({{"bufferView":{},"componentType":{},"count":{},"type":"VEC3","min":{},"max":{}}})",
          positions, kFloat, shaded, json_vector(low), json_vector(high)));

  begin = binary.size();
  for (const Vec3& n : mesh.normals) append(binary, n.cast<float>());
  const int normals = lists.add_view(begin, binary.size(), kArrayBuffer);
  Lists::add(lists.accessors,
             fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"VEC3"}})",
                         normals, kFloat, shaded));

  const std::string name = json_string(part.name);
  const std::array<double, 3>& colour = part_colour(colour_index);
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

std::string stl_bytes(const std::vector<MeshPart>& parts) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) count += mesh_of(parts, i).triangles.size();
  GW_EXPECTS(count <= 0xffffffffU);

  std::string out;
  out.reserve(kHeaderBytes + 4 + kTriangleBytes * count);
  // The text must not begin with "solid", because this word marks a text STL.
  out = "Gearwright, binary STL, mm:";
  for (const MeshPart& part : parts) out += " " + part.name;
  out.resize(kHeaderBytes, ' ');
  append_u32(out, static_cast<std::uint32_t>(count));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const TriangleMesh& mesh = mesh_of(parts, i);
    std::vector<Eigen::Vector3f> vertices;
    vertices.reserve(mesh.vertices.size());
    for (const Vec3& v : mesh.vertices)
      vertices.emplace_back((parts[i].pose * Point<SolidFrame>{v}).r.cast<float>());
    for (const Triangle& t : mesh.triangles) {
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

std::string threemf_bytes(const std::vector<MeshPart>& parts) {
  GW_EXPECTS(!parts.empty());
  std::string xml = kModelHead;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!parts[i].same_as) append_object(xml, parts[i], i + 1);
  xml += "</resources>\n<build>\n";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    xml += fmt::format("<item objectid=\"{}\" transform=\"{}\"/>\n",
                       parts[i].same_as.value_or(i) + 1, transform(parts[i].pose));
  }
  xml += "</build>\n</model>\n";

  ZipWriter zip;
  zip.add("[Content_Types].xml", kContentTypes);
  zip.add("_rels/.rels", kRelationships);
  zip.add("3D/3dmodel.model", xml);
  return std::move(zip).finish();
}

std::string glb_bytes(const std::vector<MeshPart>& parts) {
  GW_EXPECTS(!parts.empty());
  Lists lists;
  std::string binary;
  std::vector<std::size_t> number(parts.size());  // number of the mesh that each part uses
  std::size_t meshes = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const MeshPart& part = parts[i];
    if (part.same_as) {
      number[i] = number[*part.same_as];
    } else {
      GW_EXPECTS(!part.mesh.triangles.empty());
      number[i] = meshes++;
      add_mesh(part, number[i], part.colour.value_or(i), lists, binary);
    }
    add_node(part, i, number[i], lists);
  }
  // All entries are multiples of 4 bytes long, so the binary chunk needs no padding. The JSON text
  // is padded with spaces.
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
