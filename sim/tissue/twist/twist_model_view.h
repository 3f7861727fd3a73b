// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "sim/tissue/twist/twist_model.h"
#include "sim/tissue/view/cpu_features.h"
#include "sim/tissue/view/twist_kernels_buffer.h"

namespace torsio {

/// The mesh of a TwistModel for a view: single precision, the widest instruction set of the processor, good
/// to a few 1e-7 of the organ's size. Never feeds a recording: the last bit depends on the processor. One
/// thread at a time. The model outlives the view.
class TwistView {
 public:
  explicit TwistView(const TwistModel& model, Isa isa = bestIsa());

  [[nodiscard]] int vertices() const noexcept { return vertices_; }
  [[nodiscard]] Isa isa() const noexcept { return isa_; }
  /// Tells whether a whole frame is one pass of the kernels; it is not when the model needs more per vertex
  /// (an elastic foundation, axial stretch, component kriging): some ms a frame for 100,000 vertices instead
  /// of some 0.1 ms.
  [[nodiscard]] bool fast() const noexcept { return path_ != Path::kAngles && path_ != Path::kSlow; }

  /// Writes x, y, z of vertex v at xyz[v stride]; `stride` floats, at least 3. Allocates nothing.
  void update(const TwistState& state, std::span<float> xyz, int stride = 3) noexcept;

  /// Computes the frame in the kernels' own layout, 3 x 16 a block (twist_kernels.h), which update()
  /// interleaves.
  [[nodiscard]] std::span<const float> updateBlocks(const TwistState& state) noexcept;

 private:
  enum class Path {
    kCurved,  ///< the angle of a vertex follows from its compliance
    kAngles,  ///< the angle of each vertex is worked out in double precision
    kPaper,   ///< the paper's linear displacements
    kSlow,    ///< every vertex by TwistModel::deform
  };

  void choosePath();
  void fillStreams();
  void fillPaperStreams();
  void curvedFrame(const TwistState& state) noexcept;
  void anglesFrame(const TwistState& state) noexcept;
  void paperFrame(const TwistState& state) noexcept;
  void slowFrame(const TwistState& state) noexcept;
  [[nodiscard]] float& lane(KernelBuffer<float>& buffer, int streams, int vertex, int stream) const noexcept;

  const TwistModel* model_;
  Isa isa_;
  int vertices_ = 0;
  int blocks_ = 0;
  Path path_ = Path::kSlow;
  bool warped_ = false;
  KernelBuffer<float> in_;
  KernelBuffer<float> rest_;
  KernelBuffer<float> angles_;
  KernelBuffer<float> out_;
  std::vector<Vec3> slow_m_;
};

}  // namespace torsio
