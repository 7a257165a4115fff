#include "gearwright/cad/threemf.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/cad/file_text.hpp"
#include "gearwright/cad/zip.hpp"

namespace gearwright {

namespace {

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
                     xml_text(part.name));
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

// 3MF multiplies row vectors: the images of the axes one after the other, then the origin's.
std::string transform(const Eigen::Isometry3d& pose) {
  std::string out;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      const double value = pose.matrix()(row, column);
      out += fmt::format("{}{}", out.empty() ? "" : " ", value == 0.0 ? 0.0 : value);
    }
  }
  return out;
}

}  // namespace

std::string threemf_bytes(const std::vector<MeshPart>& parts) {
  GW_EXPECTS(!parts.empty());
  std::string xml = kModelHead;
  for (std::size_t i = 0; i < parts.size(); ++i) append_object(xml, parts[i], i + 1);
  xml += "</resources>\n<build>\n";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    xml +=
        fmt::format("<item objectid=\"{}\" transform=\"{}\"/>\n", i + 1, transform(parts[i].pose));
  }
  xml += "</build>\n</model>\n";

  ZipWriter zip;
  zip.add("[Content_Types].xml", kContentTypes);
  zip.add("_rels/.rels", kRelationships);
  zip.add("3D/3dmodel.model", xml);
  return std::move(zip).finish();
}

}  // namespace gearwright
