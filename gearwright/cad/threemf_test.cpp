#include "gearwright/cad/mesh_files.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <map>

#include "gearwright/base/zip.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t offset, int size) {
  std::uint32_t value = 0;
  for (int i = size; i-- > 0;) {
    value = value << 8U | static_cast<unsigned char>(bytes[offset + static_cast<std::size_t>(i)]);
  }
  return value;
}

// Reads an archive through its directory, as programs do. Numbers that are stored more than once
// are compared.
std::map<std::string, std::string> unzip(const std::string& bytes) {
  std::map<std::string, std::string> files;
  const std::size_t end = bytes.size() - 22;
  EXPECT_EQ(number_at(bytes, end, 4), 0x06054b50u);
  const std::uint32_t count = number_at(bytes, end + 10, 2);
  std::size_t at = number_at(bytes, end + 16, 4);
  EXPECT_EQ(at + number_at(bytes, end + 12, 4), end);
  for (std::uint32_t i = 0; i < count; ++i) {
    EXPECT_EQ(number_at(bytes, at, 4), 0x02014b50u);
    const std::uint32_t crc = number_at(bytes, at + 16, 4);
    const std::uint32_t packed = number_at(bytes, at + 20, 4);
    const std::uint32_t size = number_at(bytes, at + 24, 4);
    const std::uint32_t name_size = number_at(bytes, at + 28, 2);
    const std::size_t local = number_at(bytes, at + 42, 4);
    const std::string name = bytes.substr(at + 46, name_size);
    EXPECT_EQ(number_at(bytes, at + 12, 2), 0u);     // midnight
    EXPECT_EQ(number_at(bytes, at + 14, 2), 0x21u);  // 1980-01-01
    EXPECT_EQ(number_at(bytes, local, 4), 0x04034b50u);
    EXPECT_EQ(bytes.substr(at + 6, 24), bytes.substr(local + 4, 24));
    EXPECT_EQ(bytes.substr(local + 30, name_size), name);

    std::string content(size, '\0');
    z_stream stream{};
    EXPECT_EQ(inflateInit2(&stream, -15), Z_OK);
    std::string input = bytes.substr(local + 30 + name_size, packed);
    stream.next_in = reinterpret_cast<Bytef*>(input.data());
    stream.avail_in = packed;
    stream.next_out = reinterpret_cast<Bytef*>(content.data());
    stream.avail_out = size;
    EXPECT_EQ(inflate(&stream, Z_FINISH), size == 0 ? Z_BUF_ERROR : Z_STREAM_END);
    inflateEnd(&stream);
    EXPECT_EQ(crc32(0, reinterpret_cast<const Bytef*>(content.data()), size), crc);
    files[name] = content;
    at += 46 + name_size;
  }
  EXPECT_EQ(at, end);
  return files;
}

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

TEST(Zip, ReturnsWhatWasPutIn) {
  std::string noise;
  for (std::uint32_t i = 0, x = 1; i < 100000; ++i) {
    x = x * 1664525U + 1013904223U;
    noise += static_cast<char>(x >> 24U);  // incompressible
  }
  const std::string text(1000000, 'g');
  ZipWriter zip;
  zip.add("noise", noise);
  zip.add("folder/text", text);
  const std::string bytes = std::move(zip).finish();
  EXPECT_LT(bytes.size(), 103000u);
  const auto files = unzip(bytes);
  EXPECT_EQ(files.size(), 2u);
  EXPECT_EQ(files.at("noise"), noise);
  EXPECT_EQ(files.at("folder/text"), text);
}

TEST(ThreeMf, ObjectsHaveTheMeshAndItemsTheirPoses) {
  std::vector<MeshPart> parts;
  for (const double beta : {0.3, -0.3}) {
    const ToothedBody body = testing::sample_body({.teeth = 17, .beta = beta});
    parts.push_back({"a<b> & \"c\"", tessellate(body).value(), body.pose});
  }
  // A quarter turn about z maps the x axis to y.
  Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
  turned.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  turned.translation() = Vec3(35.5, 0.0, -2.0);
  parts[1].pose = SolidPose(turned);
  const std::string bytes = threemf_bytes(parts);
  EXPECT_EQ(bytes, threemf_bytes(parts));

  const auto files = unzip(bytes);
  EXPECT_EQ(files.size(), 3u);
  EXPECT_EQ(files.count("[Content_Types].xml"), 1u);
  EXPECT_NE(files.at("_rels/.rels").find("Target=\"/3D/3dmodel.model\""), std::string::npos);
  const std::string& model = files.at("3D/3dmodel.model");
  EXPECT_NE(model.find("unit=\"millimeter\""), std::string::npos);
  EXPECT_EQ(occurrences(model, "<vertex "),
            parts[0].mesh.vertices.size() + parts[1].mesh.vertices.size());
  EXPECT_EQ(occurrences(model, "<triangle "),
            parts[0].mesh.triangles.size() + parts[1].mesh.triangles.size());
  EXPECT_EQ(occurrences(model, "name=\"a&lt;b&gt; &amp; &quot;c&quot;\""), 2u);
  EXPECT_NE(model.find("<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 0\"/>"),
            std::string::npos);
  EXPECT_NE(model.find("<item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 35.5 0 -2\"/>"),
            std::string::npos);
}

}  // namespace
}  // namespace gearwright
