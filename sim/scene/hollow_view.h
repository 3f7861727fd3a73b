// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "sim/scene/hollow_skin.h"
#include "sim/scene/scene.h"
#include "sim/tissue/view/cpu_features.h"
#include "sim/tissue/view/twist_kernels_buffer.h"

namespace torsio {

/// The mesh of a hollow scene for a view: HollowSkin in single precision, by the widest instruction set of
/// the processor, good to 1e-6 m. Never feeds a recording: the last bit depends on the processor. One thread
/// at a time.
class HollowView {
 public:
  /// `scene` has a hollow organ.
  explicit HollowView(std::shared_ptr<const Scene> scene, Isa isa = bestIsa());

  /// Computes the drawn place of each mesh vertex, m, as Scene::deform does. Allocates nothing.
  void deform(const OrganState& state, std::span<Vec3> out_m) noexcept;

  /// Computes the frame in the kernels' own layout, 3 x 16 a block (twist_kernels.h).
  [[nodiscard]] std::span<const float> updateBlocks(const OrganState& state) noexcept;

 private:
  std::shared_ptr<const Scene> scene_;
  Isa isa_;
  std::size_t vertices_ = 0;
  int blocks_ = 0;
  KernelBuffer<float> in_;
  KernelBuffer<float> out_;
  HollowRows rows_;
};

}  // namespace torsio
