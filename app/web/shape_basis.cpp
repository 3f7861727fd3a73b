// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/shape_basis.h"

#include <algorithm>
#include <cmath>

#include "sim/base/contracts.h"

namespace torsio::web {

namespace {

constexpr float kLargestStep = 32'000.0F;

float dotOf(std::span<const float> a, std::span<const float> b) {
  // Eight sums side by side: the order is fixed, so that every machine rounds alike.
  float sums[8] = {};
  std::size_t i = 0;
  for (; i + 8 <= a.size(); i += 8) {
    for (std::size_t k = 0; k < 8; ++k) {
      sums[k] += a[i + k] * b[i + k];
    }
  }
  for (; i < a.size(); ++i) {
    sums[0] += a[i] * b[i];
  }
  float sum = 0.0F;
  for (const float one : sums) {
    sum += one;
  }
  return sum;
}

float farthestOf(std::span<const float> residual) {
  float square = 0.0F;
  for (std::size_t i = 0; i + 2 < residual.size(); i += 3) {
    square = std::max(square, residual[i] * residual[i] + residual[i + 1] * residual[i + 1] +
                                  residual[i + 2] * residual[i + 2]);
  }
  return std::sqrt(square);
}

}  // namespace

std::vector<float> ShapeBasis::weightsOf(std::span<const float> shape) const {
  // Components are orthogonal up to the rounding of their steps; a second pass takes up what that leaves.
  std::vector<float> left(shape.size());
  for (std::size_t i = 0; i < shape.size(); ++i) {
    left[i] = shape[i] - mean[i];
  }
  std::vector<float> weights(components(), 0.0F);
  std::vector<float> step(shape.size());
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t k = 0; k < components(); ++k) {
      for (std::size_t i = 0; i < shape.size(); ++i) {
        step[i] = scale[k] * static_cast<float>(steps[k * shape.size() + i]);
      }
      const float weight = dotOf(left, step) / dotOf(step, step);
      weights[k] += weight;
      for (std::size_t i = 0; i < shape.size(); ++i) {
        left[i] -= weight * step[i];
      }
    }
  }
  return weights;
}

float ShapeBasis::farthest(std::span<const float> shape, std::span<const float> weights) const {
  std::vector<float> left(shape.size());
  for (std::size_t i = 0; i < shape.size(); ++i) {
    float place = mean[i];
    for (std::size_t k = 0; k < components(); ++k) {
      place += weights[k] * scale[k] * static_cast<float>(steps[k * shape.size() + i]);
    }
    left[i] = shape[i] - place;
  }
  return farthestOf(left);
}

ShapeBasis shapeBasis(std::span<const std::vector<float>> shapes, float within, std::size_t most) {
  TORSIO_EXPECTS(!shapes.empty());
  ShapeBasis basis;
  basis.mean = shapes.front();
  const std::size_t size = basis.mean.size();
  std::vector<std::vector<float>> left;
  for (const std::vector<float>& shape : shapes) {
    TORSIO_EXPECTS(shape.size() == size);
    left.push_back(shape);
    for (std::size_t i = 0; i < size; ++i) {
      left.back()[i] -= basis.mean[i];
    }
  }
  while (basis.components() < most) {
    std::size_t worst = 0;
    float error = 0.0F;
    for (std::size_t s = 0; s < left.size(); ++s) {
      const float own = farthestOf(left[s]);
      if (own > error) {
        error = own;
        worst = s;
      }
    }
    if (error <= within) {
      break;
    }
    const std::vector<float>& next = left[worst];
    float largest = 0.0F;
    for (const float value : next) {
      largest = std::max(largest, std::abs(value));
    }
    const float scale = largest / kLargestStep;
    std::vector<float> step(size);
    for (std::size_t i = 0; i < size; ++i) {
      const auto rounded = static_cast<std::int16_t>(std::lround(next[i] / scale));
      basis.steps.push_back(rounded);
      step[i] = scale * static_cast<float>(rounded);
    }
    basis.scale.push_back(scale);
    const float square = dotOf(step, step);
    for (std::vector<float>& one : left) {
      const float weight = dotOf(one, step) / square;
      for (std::size_t i = 0; i < size; ++i) {
        one[i] -= weight * step[i];
      }
    }
  }
  return basis;
}

}  // namespace torsio::web
