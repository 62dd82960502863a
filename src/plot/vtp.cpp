#include "plot/vtp.h"

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <string_view>

#include "core/markup.h"
#include "plot/base64.h"

namespace goniolux::plot {
namespace {

static_assert(std::endian::native == std::endian::little, "the file says LittleEndian");

/// An inline binary array: its length in bytes as one UInt64, then the bytes, together in base64.
template <typename T>
std::string dataArray(const char* type, const std::string& name, int components, const std::vector<T>& values) {
  const std::uint64_t length = values.size() * sizeof(T);
  std::string bytes(reinterpret_cast<const char*>(&length), sizeof length);
  bytes.append(reinterpret_cast<const char*>(values.data()), length);
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}</DataArray>\n",
                     type, core::escapedMarkup(name), components, base64(bytes));
}

std::string cells(const char* element, const std::vector<std::vector<std::int64_t>>& list) {
  std::vector<std::int64_t> connectivity, offsets;
  for (const std::vector<std::int64_t>& cell : list) {
    connectivity.insert(connectivity.end(), cell.begin(), cell.end());
    offsets.push_back(std::ssize(connectivity));
  }
  return fmt::format("<{0}>\n{1}{2}</{0}>\n", element, dataArray("Int64", "connectivity", 1, connectivity),
                     dataArray("Int64", "offsets", 1, offsets));
}

/// The declaration with how the file was made, up to the first tag of the data set.
std::string opening(const PolyData& data, const char* type) {
  std::string comment;  // "--" must not stand in an XML comment
  for (const char c : core::escapedMarkup(data.comment)) {
    if (c == '-' && comment.ends_with('-')) comment += ' ';
    comment += c;
  }
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<!-- {0} -->\n"
      "<VTKFile type=\"{1}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<{1}>\n",
      comment, type);
}

std::string pointsAndData(const PolyData& data) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * data.points.size());
  for (const core::Vec3& p : data.points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  std::string xml = "<Points>\n" + dataArray("Float64", "Points", 3, coordinates) + "</Points>\n";
  if (data.pointData.empty()) return xml;
  xml += fmt::format("<PointData Scalars=\"{}\">\n", core::escapedMarkup(data.pointData.front().name));
  for (const PolyData::Array& array : data.pointData) {
    assert(array.values.size() == data.points.size());
    xml += dataArray("Float64", array.name, 1, array.values);
  }
  return xml + "</PointData>\n";
}

}  // namespace

std::string vtpOf(const PolyData& data) {
  std::string xml = opening(data, "PolyData");
  xml += fmt::format(
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n",
      data.points.size(), data.vertices.size(), data.lines.size(), data.polygons.size());
  xml += pointsAndData(data);
  xml += cells("Verts", data.vertices) + cells("Lines", data.lines) + cells("Polys", data.polygons);
  return xml + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

std::string vtuOf(const PolyData& data) {
  // Cell types of the VTK file formats: 2 poly-vertex, 4 polyline, 7 polygon.
  std::vector<std::vector<std::int64_t>> all;
  std::vector<std::uint8_t> types;
  const auto add = [&](const std::vector<std::vector<std::int64_t>>& list, std::uint8_t type) {
    all.insert(all.end(), list.begin(), list.end());
    types.insert(types.end(), list.size(), type);
  };
  add(data.vertices, 2);
  add(data.lines, 4);
  add(data.polygons, 7);
  std::string list = cells("Cells", all);
  const std::string end = "</Cells>\n";
  list.insert(list.size() - end.size(), dataArray("UInt8", "types", 1, types));
  return opening(data, "UnstructuredGrid") +
         fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", data.points.size(), all.size()) +
         pointsAndData(data) + list + "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace goniolux::plot
