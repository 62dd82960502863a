// The gathering kernel: paths of the path kernel that end in a light solution (solver/light_solution.h) as soon as it
// answers for the point that they meet. What this misses is estimated by paths that go on (missed()), so that the
// solution's bias is known and taken away, not assumed small.
#pragma once

#include <unordered_map>

#include "solver/path_kernel.h"

namespace goniolux::solver {

template <int W>
class GatherSolver final : public PathSolver<W> {
 public:
  explicit GatherSolver(const Problem& problem);

  [[nodiscard]] bool isUnbiased() const override { return false; }
  [[nodiscard]] double missedLuminance(const core::Vec3& origin, const core::Vec3& direction, std::uint64_t key,
                                       std::uint32_t sample) const override {
    return this->radianceBy(Ending::remainder, origin, direction, key, sample)[1];
  }
  [[nodiscard]] Response missed(const Receiver& receiver, std::uint64_t key, std::uint32_t sample) const override;

 private:
  using Base = PathSolver<W>;
  using Vec3 = core::Vec3;
  using typename Base::Spectral;
  using typename Base::Vertex;

  using typename Base::Arrival;

  /// The cells that light can come from, with the rays that link them.
  void discover(LightSolution::Transport& transport);
  void linkCells(std::size_t from, std::size_t to, std::size_t raysPerCell, std::vector<LightSolution::Link>& links,
                 std::vector<float>& filters);
  /// Irradiance straight from the lights at the cells' points, and which cells are rough.
  void lightCells(LightSolution::Transport& transport);
  void directAt(const Vertex& at, std::uint64_t key, std::vector<Spectral>& bySource, std::uint64_t& rays) const;
  void setResponses();

  std::vector<Spectral> reflectance_;  // per material; 0 where it does not follow Lambert's law
  /// Of cells with a texture: the mean over the places where rays have met them.
  struct TexturedCell {
    Spectral sum{};
    int count = 0;
  };
  std::unordered_map<std::uint32_t, TexturedCell> texturedCells_;
  double accuracy_;
  std::size_t linksPerCell_;
};

}  // namespace goniolux::solver
