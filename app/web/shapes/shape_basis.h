// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace torsio::web {

/// Weights are whole multiples of this, mm.
inline constexpr float kWeightStep_mm = 0.01F;

/// Shapes of one mesh as a mean and a few displacements: shape = mean + sum of weight_k scale_k step_k, so
/// that a page shows any of them without knowing how the organ is twisted. Steps are whole numbers, as coarse
/// as the bound allows; scale_k step_k is 1 at most, so that a weight says how far its component reaches, mm.
struct ShapeBasis {
  std::vector<float> mean;          ///< 3 a vertex, mm, multiples of meanStep
  float meanStep = 0.0F;            ///< mm
  std::vector<float> scale;         ///< one a component
  std::vector<std::int16_t> steps;  ///< component after component, 3 a vertex
  [[nodiscard]] std::size_t components() const noexcept { return scale.size(); }
  /// The first `count` components, with the mean; the others, without it.
  [[nodiscard]] ShapeBasis upTo(std::size_t count) const;
  [[nodiscard]] ShapeBasis from(std::size_t count) const;
};

/// Finds a basis and what the weights of each shape are. A component is added whenever a shape is not shown
/// within the bound yet; what earlier shapes were told stays good, since the weight of a later component is 0
/// for them. Deterministic. Any one thread.
class ShapeFitter {
 public:
  /// `within`: the farthest, mm, that a vertex may lie from its place; `most`: components at most.
  ShapeFitter(std::span<const float> mean, float within, std::size_t most);

  /// Takes components out of these shapes until none lies farther off than `within`, mm, the worst shown one
  /// first: fewer are needed for all the others. What was learnt before is used first; not after fit(), whose
  /// components are not at right angles.
  void learn(std::span<const std::vector<float>> shapes, float within);

  struct Fit {
    std::vector<float> weights;  ///< mm, multiples of kWeightStep_mm; as many as components were known
    float farthest = 0.0F;       ///< of a vertex from its place, with just these weights, mm
  };
  /// In the order of the shapes; `farthest` is within the bound unless `most` components were too few.
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
  std::vector<std::vector<float>> components_;   // as the basis says them
  std::vector<std::vector<double>> triangular_;  // rows of the Cholesky factor of their products
};

}  // namespace torsio::web
