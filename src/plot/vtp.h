// VTK XML PolyData (.vtp) and UnstructuredGrid (.vtu), for ParaView. Written here and not by VTK, because the program
// that calculates loads no VTK; the tests read the files back with VTK. Little-endian float64 and int64 in base64, not
// compressed: exact, and NaN is kept.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/vector.h"

namespace goniolux::plot {

struct PolyData {
  struct Array {
    std::string name;
    std::vector<double> values;  ///< one per point
  };
  std::string comment;  ///< how it was made
  std::vector<core::Vec3> points;
  std::vector<Array> pointData;                     ///< the first is what ParaView colours by
  std::vector<std::vector<std::int64_t>> vertices;  ///< each a list of point indices
  std::vector<std::vector<std::int64_t>> lines;
  std::vector<std::vector<std::int64_t>> polygons;
};

std::string vtpOf(const PolyData& data);
/// The same as an unstructured grid: vertices, lines and polygons are its cells, in this order.
std::string vtuOf(const PolyData& data);

}  // namespace goniolux::plot
