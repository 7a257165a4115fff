#include "gearwright/cad/mesh_files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

std::uint32_t u32_at(const std::string& bytes, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + offset, 4);
  return value;
}

struct Parsed {
  nlohmann::json json;
  std::string binary;
};

Parsed parse(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(u32_at(bytes, 4), 2u);
  EXPECT_EQ(u32_at(bytes, 8), bytes.size());
  const std::uint32_t text = u32_at(bytes, 12);
  EXPECT_EQ(text % 4, 0u);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  EXPECT_EQ(bytes.substr(20 + text + 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(u32_at(bytes, 20 + text) + 28 + text, bytes.size());
  return {nlohmann::json::parse(bytes.substr(20, text)), bytes.substr(28 + text)};
}

std::vector<MeshPart> pair_parts() {
  std::vector<MeshPart> parts;
  for (const double beta : {0.3, -0.3}) {
    const ToothedBody body = testing::sample_body({.teeth = 17, .beta = beta});
    parts.push_back({"gear \"\\\n\xC3\xA4", tessellate(body).value(), body.pose});
  }
  parts[1].pose = SolidPose(Eigen::Translation3d(35.6, -1.0, 2.0) *
                            Eigen::AngleAxisd(0.7, Vec3(0.0, 0.6, 0.8)));
  return parts;
}

TEST(Glb, NodesCarryNamesAndPoses) {
  const std::vector<MeshPart> parts = pair_parts();
  const Parsed file = parse(glb_bytes(parts));
  ASSERT_EQ(file.json["nodes"].size(), 2u);
  EXPECT_EQ(file.json["scenes"][0]["nodes"], nlohmann::json({0, 1}));
  EXPECT_EQ(file.json["nodes"][0]["name"], parts[0].name);
  EXPECT_FALSE(file.json["nodes"][0].contains("matrix"));
  const std::vector<double> matrix = file.json["nodes"][1]["matrix"];
  Eigen::Matrix4d expected = parts[1].pose.isometry().matrix();
  expected.topRightCorner<3, 1>() *= 1e-3;
  EXPECT_EQ(Eigen::Map<const Eigen::Matrix4d>(matrix.data()), expected);
  EXPECT_NE(file.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"],
            file.json["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"]);
}

TEST(Glb, AccessorsSayExactlyWhatTheBufferHolds) {
  const std::vector<MeshPart> parts = pair_parts();
  const Parsed file = parse(glb_bytes(parts));
  EXPECT_EQ(file.json["buffers"][0]["byteLength"], file.binary.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const TriangleMesh& mesh = parts[i].mesh;
    const auto& primitive = file.json["meshes"][i]["primitives"][0];
    const auto accessor = [&](const nlohmann::json& index) {
      return file.json["accessors"][index.get<std::size_t>()];
    };
    const auto start = [&](const nlohmann::json& a) {
      return file.json["bufferViews"][a["bufferView"].get<std::size_t>()]["byteOffset"]
          .get<std::size_t>();
    };
    const auto indices = accessor(primitive["indices"]);
    ASSERT_EQ(indices["count"], 3 * mesh.triangles.size());
    const auto positions = accessor(primitive["attributes"]["POSITION"]);
    const auto normals = accessor(primitive["attributes"]["NORMAL"]);
    ASSERT_EQ(positions["count"], mesh.shaded_vertices.size());
    ASSERT_EQ(normals["count"], mesh.shaded_vertices.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_EQ(u32_at(file.binary, start(indices) + 12 * t + 4 * j),
                  mesh.shaded_triangles[t][j]);
      }
    }
    Eigen::Array3f low = Eigen::Array3f::Constant(1e30F), high = -low;
    for (std::size_t v = 0; v < mesh.shaded_vertices.size(); ++v) {
      Eigen::Vector3f p, n;
      std::memcpy(p.data(), file.binary.data() + start(positions) + 12 * v, 12);
      std::memcpy(n.data(), file.binary.data() + start(normals) + 12 * v, 12);
      ASSERT_EQ(p, (1e-3 * mesh.vertices[mesh.shaded_vertices[v]]).cast<float>());
      ASSERT_EQ(n, mesh.normals[v].cast<float>());
      low = low.min(p.array());
      high = high.max(p.array());
    }
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(positions["min"][static_cast<std::size_t>(c)].get<float>(), low[c]);
      EXPECT_EQ(positions["max"][static_cast<std::size_t>(c)].get<float>(), high[c]);
    }
  }
}

TEST(Glb, SameInputSameBytes) { EXPECT_EQ(glb_bytes(pair_parts()), glb_bytes(pair_parts())); }

}  // namespace
}  // namespace gearwright
