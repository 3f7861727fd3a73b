// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace torsio::web {

/// Weights are integer multiples of this, mm.
inline constexpr float kWeightStep_mm = 0.01F;

/// Shapes of one mesh as a mean and a few displacements: shape = mean + sum of weight_k scale_k step_k, so
/// that a page can display them without a twist model. Steps are integers, as coarse as the bound allows;
/// scale_k step_k is at most 1, so that a weight is the reach of its component in mm.
struct ShapeBasis {
  std::vector<float> mean;          ///< 3 per vertex, mm, multiples of meanStep
  float meanStep = 0.0F;            ///< mm
  std::vector<float> scale;         ///< one per component
  std::vector<std::int16_t> steps;  ///< component by component, 3 per vertex
  [[nodiscard]] std::size_t components() const noexcept { return scale.size(); }
  /// Returns the first `count` components with the mean, or the rest without it.
  [[nodiscard]] ShapeBasis upTo(std::size_t count) const;
  [[nodiscard]] ShapeBasis from(std::size_t count) const;
};

/// Computes a basis and the weights of each shape. A component is added whenever a shape is not within the
/// bound. Earlier weights stay valid, since those of later components are 0. Deterministic. Not thread-safe.
class ShapeFitter {
 public:
  /// `within`: maximum deviation of a vertex, mm; `most`: maximum number of components.
  ShapeFitter(std::span<const float> mean, float within, std::size_t most);

  /// Adds components for these shapes until none deviates by more than `within` mm, starting with the worst;
  /// reduces the number needed overall. Uses existing components first. Not allowed after fit(), whose
  /// components are not orthogonal.
  void learn(std::span<const std::vector<float>> shapes, float within);

  struct Fit {
    std::vector<float> weights;  ///< mm, multiples of kWeightStep_mm; one for each component so far
    float farthest = 0.0F;       ///< largest deviation of a vertex with these weights, mm
  };
  /// Fits shapes in order; `farthest` is within the bound unless `most` components were too few.
  [[nodiscard]] std::vector<Fit> fit(std::span<const std::vector<float>> shapes);

  [[nodiscard]] const ShapeBasis& basis() const noexcept { return basis_; }

 private:
  void add(std::span<const float> displacement);
  [[nodiscard]] std::vector<float> solved(std::span<const double> products) const;
  [[nodiscard]] std::vector<float> differenceOf(std::span<const float> shape) const;
  [[nodiscard]] std::vector<Fit> fitOnce(std::span<const std::vector<float>> shapes,
                                         std::vector<std::vector<float>>& left) const;

  float within_;
  std::size_t most_;
  ShapeBasis basis_;
  std::vector<std::vector<float>> components_;   // as rounded in the basis
  std::vector<std::vector<double>> triangular_;  // rows of the Cholesky factor of their Gram matrix
};

}  // namespace torsio::web
