#include "app/gui/room/surface_pieces.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace goniolux::gui {
namespace {

using core::Vec3;

constexpr plot::Rgb unknownColour{160, 160, 160};

/// Whether the mesh is the skin of a body with its fronts outside: every edge is run through once each way, and the
/// volume that the triangles enclose is positive. Corners at the same place count as one.
bool isBody(const geometry::Mesh& mesh) {
  std::map<std::array<double, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> corner;
  for (const Vec3& v : mesh.vertices)
    corner.push_back(places.try_emplace({v.x, v.y, v.z}, static_cast<std::uint32_t>(places.size())).first->second);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> runs;
  double volume = 0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = corner[t[k]], b = corner[t[(k + 1) % 3]];
      if (a != b) runs[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
    volume += glm::dot(mesh.vertices[t[0]], glm::cross(mesh.vertices[t[1]], mesh.vertices[t[2]]));
  }
  return volume > 0 && std::all_of(runs.begin(), runs.end(), [](const auto& run) { return run.second == 0; });
}

/// Diagonal of the box around the mesh where it stands.
double sizeOf(const geometry::Mesh& mesh, const core::Mat4& place) {
  Vec3 low(1e300), high(-1e300);
  for (const Vec3& vertex : mesh.vertices) {
    low = glm::min(low, vertex);
    high = glm::max(high, vertex);
  }
  if (low.x > high.x) return 0;
  return glm::length(core::Mat3(place) * (high - low));
}

class Builder {
 public:
  Builder() {
    colours_->SetNumberOfComponents(3);
    colours_->SetName("colour");
    objects_->SetName("object");
  }

  void add(const geometry::Mesh& mesh, const core::Mat4& place, bool turned, const std::vector<plot::Rgb>& colourOfPart,
           int object) {
    // A corner between parts of two colours stands for each of them: colours belong to points, which draws faster
    // than a colour looked up for every triangle.
    std::map<std::pair<std::uint32_t, plot::Rgb>, vtkIdType> points;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const std::size_t part = i < mesh.parts.size() ? mesh.parts[i] : 0;
      const plot::Rgb colour = part < colourOfPart.size() ? colourOfPart[part] : unknownColour;
      vtkIdType corners[3];
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [found, isNew] = points.try_emplace({mesh.triangles[i][k], colour}, points_->GetNumberOfPoints());
        if (isNew) {
          const Vec3 at(place * glm::dvec4(mesh.vertices[mesh.triangles[i][k]], 1));
          points_->InsertNextPoint(at.x, at.y, at.z);
          colours_->InsertNextTypedTuple(colour.data());
        }
        corners[k] = found->second;
      }
      if (turned) std::swap(corners[1], corners[2]);
      cells_->InsertNextCell(3, corners);
      objects_->InsertNextValue(object);
    }
  }

  [[nodiscard]] vtkSmartPointer<vtkPolyData> data() const {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetPolys(cells_);
    data->GetPointData()->SetScalars(colours_);
    data->GetCellData()->AddArray(objects_);
    return data;
  }
  [[nodiscard]] std::size_t triangles() const { return static_cast<std::size_t>(cells_->GetNumberOfCells()); }

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkIntArray> objects_;
};

/// A number that only the place decides, evenly spread (Steele, Lea & Flood's SplitMix64 finaliser).
std::uint64_t mixed(std::uint64_t n) {
  n += 0x9e3779b97f4a7c15ull;
  n = (n ^ (n >> 30)) * 0xbf58476d1ce4e5b9ull;
  n = (n ^ (n >> 27)) * 0x94d049bb133111ebull;
  return n ^ (n >> 31);
}

}  // namespace

void SurfaceList::add(const geometry::Mesh& mesh, const core::Mat4& place, bool turned,
                      const std::vector<plot::Rgb>& colourOfPart, int object) {
  // Places of one object follow each other.
  if (places_.empty() || places_.back().object != object) shapes_.push_back({mesh, colourOfPart, isBody(mesh)});
  places_.push_back({shapes_.size() - 1, place, turned, object, sizeOf(mesh, place)});
}

vtkSmartPointer<vtkPolyData> SurfaceList::whole() const {
  Builder builder;
  for (const Place& p : places_)
    builder.add(shapes_[p.shape].mesh, p.place, p.turned, shapes_[p.shape].colourOfPart, p.object);
  return builder.data();
}

std::vector<SurfacePiece> SurfaceList::pieces() const {
  std::vector<std::size_t> order(places_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Sizes count in steps of an eighth of an octave, or rounding errors would put an array's elements in their order.
  const auto rank = [&](std::size_t i) { return std::lround(8 * std::log2(std::max(places_[i].size, 1e-9))); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return rank(a) != rank(b) ? rank(a) > rank(b) : mixed(a) != mixed(b) ? mixed(a) < mixed(b) : a < b;
  });
  std::vector<SurfacePiece> pieces;
  for (std::size_t next = 0; next < order.size();) {
    Builder bodies, sheets;
    for (; next < order.size(); ++next) {
      const Place& p = places_[order[next]];
      const Shape& shape = shapes_[p.shape];
      const std::size_t before = bodies.triangles() + sheets.triangles();
      if (before > 0 && before + shape.mesh.triangles.size() > trianglesOfPiece) break;
      (shape.isClosed ? bodies : sheets).add(shape.mesh, p.place, p.turned, shape.colourOfPart, p.object);
    }
    if (bodies.triangles() > 0) pieces.push_back({bodies.data(), true});
    if (sheets.triangles() > 0) pieces.push_back({sheets.data(), false});
  }
  return pieces;
}

std::vector<vtkSmartPointer<vtkPolyData>> linePieces(const std::vector<pipeline::Segment>& segments) {
  std::vector<vtkSmartPointer<vtkPolyData>> pieces;
  for (std::size_t next = 0; next < segments.size();) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    const std::size_t most = pieces.empty() ? linesOfFirstPiece : linesOfPiece;
    for (std::size_t n = 0; n < most && next < segments.size(); ++n, ++next) {
      const pipeline::Segment& s = segments[next];
      const vtkIdType ends[2] = {points->InsertNextPoint(s.from.x, s.from.y, s.from.z),
                                 points->InsertNextPoint(s.to.x, s.to.y, s.to.z)};
      cells->InsertNextCell(2, ends);
    }
    pieces.push_back(vtkSmartPointer<vtkPolyData>::New());
    pieces.back()->SetPoints(points);
    pieces.back()->SetLines(cells);
  }
  return pieces;
}

}  // namespace goniolux::gui
