// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace torsio::web {

/// Shapes of one mesh as a mean and a few displacements: shape = mean + sum of weight_k scale_k step_k, so
/// that a page shows any of them without knowing how the organ is twisted. Steps are whole numbers.
struct ShapeBasis {
  std::vector<float> mean;          ///< 3 a vertex
  std::vector<float> scale;         ///< one a component
  std::vector<std::int16_t> steps;  ///< component after component, 3 a vertex
  [[nodiscard]] std::size_t components() const noexcept { return scale.size(); }
  /// The weights that come nearest to a shape (3 numbers a vertex, as the mean).
  [[nodiscard]] std::vector<float> weightsOf(std::span<const float> shape) const;
  /// The farthest that a vertex lies from where it should, with these weights.
  [[nodiscard]] float farthest(std::span<const float> shape, std::span<const float> weights) const;
};

/// Finds a basis for `shapes` (each 3 numbers a vertex, the first one becomes the mean), greedily: the shape
/// that is shown worst gives the next component, until every vertex of every shape lies within `within` of
/// its place or `most` components are reached. Deterministic.
[[nodiscard]] ShapeBasis shapeBasis(std::span<const std::vector<float>> shapes, float within,
                                    std::size_t most);

}  // namespace torsio::web
