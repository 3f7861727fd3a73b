// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/shapes/shape_basis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "sim/core/contracts.h"

namespace torsio::web {

namespace {

constexpr float kLargestStep = 32'000.0F;
constexpr float kFinest_mm = 0.03F;       // finest step of a component; the error bound is five times that
constexpr float kFinestMean_mm = 0.004F;  // finest step of the mean
constexpr std::size_t kBatch = 4;         // shapes projected together
constexpr std::size_t kBlock = 1536;      // coordinates per block, so that a batch fits the L1 cache

float dotOf(std::span<const float> a, std::span<const float> b) {
  // Eight parallel sums in a fixed order, so that every machine rounds alike.
  std::array<float, 8> sums{};
  std::size_t i = 0;
  for (; i + sums.size() <= a.size(); i += sums.size()) {
    for (std::size_t k = 0; k < sums.size(); ++k) {
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

void subtract(std::span<float> from, std::span<const float> what, float weight) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    from[i] -= weight * what[i];
  }
}

float farthestOf(std::span<const float> residual) {
  float square = 0.0F;
  for (std::size_t i = 0; i + 2 < residual.size(); i += 3) {
    square = std::max(square, residual[i] * residual[i] + residual[i + 1] * residual[i + 1] +
                                  residual[i + 2] * residual[i + 2]);
  }
  return std::sqrt(square);
}

float largestOf(std::span<const float> values) {
  float largest = 0.0F;
  for (const float value : values) {
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

}  // namespace

ShapeBasis ShapeBasis::upTo(std::size_t count) const {
  TORSIO_EXPECTS(count <= components());
  return {mean,
          meanStep,
          {scale.begin(), scale.begin() + std::ptrdiff_t(count)},
          {steps.begin(), steps.begin() + std::ptrdiff_t(count * mean.size())}};
}

ShapeBasis ShapeBasis::from(std::size_t count) const {
  TORSIO_EXPECTS(count <= components());
  return {{},
          meanStep,
          {scale.begin() + std::ptrdiff_t(count), scale.end()},
          {steps.begin() + std::ptrdiff_t(count * mean.size()), steps.end()}};
}

ShapeFitter::ShapeFitter(std::span<const float> mean, float within, std::size_t most)
    : within_(within), most_(most) {
  TORSIO_EXPECTS(mean.size() % 3 == 0);
  basis_.meanStep = std::max(kFinestMean_mm, largestOf(mean) / kLargestStep);
  basis_.mean.reserve(mean.size());
  for (const float value : mean) {
    basis_.mean.push_back(basis_.meanStep * std::round(value / basis_.meanStep));
  }
}

std::vector<float> ShapeFitter::differenceOf(std::span<const float> shape) const {
  TORSIO_EXPECTS(shape.size() == basis_.mean.size());
  std::vector<float> left(shape.begin(), shape.end());
  subtract(left, basis_.mean, 1.0F);
  return left;
}

void ShapeFitter::add(std::span<const float> displacement) {
  const float largest = largestOf(displacement);
  const float levels = std::clamp(std::ceil(largest / kFinest_mm), 1.0F, kLargestStep);
  basis_.scale.push_back(1.0F / levels);
  std::vector<float> component;
  component.reserve(displacement.size());
  for (const float value : displacement) {
    const auto step = static_cast<std::int16_t>(std::lround(levels * value / largest));
    basis_.steps.push_back(step);
    component.push_back(basis_.scale.back() * static_cast<float>(step));
  }
  std::vector<double> row;
  for (std::size_t k = 0; k < components_.size(); ++k) {
    double value = dotOf(component, components_[k]);
    for (std::size_t j = 0; j < k; ++j) {
      value -= row[j] * triangular_[k][j];
    }
    row.push_back(value / triangular_[k][k]);
  }
  double rest = dotOf(component, component);
  const double whole = rest;
  for (const double value : row) {
    rest -= value * value;
  }
  constexpr double kSame = 1e-6;  // nearly a combination of the others, up to rounding
  row.push_back(std::sqrt(std::max(rest, kSame * whole)));
  triangular_.push_back(std::move(row));
  components_.push_back(std::move(component));
}

std::vector<float> ShapeFitter::solved(std::span<const double> products) const {
  const std::size_t count = components_.size();
  std::vector<double> x(products.begin(), products.end());
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      x[k] -= triangular_[k][j] * x[j];
    }
    x[k] /= triangular_[k][k];
  }
  for (std::size_t k = count; k-- > 0;) {
    for (std::size_t j = k + 1; j < count; ++j) {
      x[k] -= triangular_[j][k] * x[j];
    }
    x[k] /= triangular_[k][k];
  }
  std::vector<float> weights;
  for (const double value : x) {
    weights.push_back(kWeightStep_mm * static_cast<float>(std::round(value / kWeightStep_mm)));
  }
  return weights;
}

void ShapeFitter::learn(std::span<const std::vector<float>> shapes, float within) {
  std::vector<std::vector<float>> left;
  std::vector<float> off;
  const auto takeOut = [](std::vector<float>& from, const std::vector<float>& component) {
    subtract(from, component, dotOf(from, component) / dotOf(component, component));
  };
  for (const std::vector<float>& shape : shapes) {
    left.push_back(differenceOf(shape));
    for (const std::vector<float>& component : components_) {
      takeOut(left.back(), component);
    }
    off.push_back(farthestOf(left.back()));
  }
  while (components_.size() < most_) {
    const auto worst = std::max_element(off.begin(), off.end());
    if (worst == off.end() || *worst <= within) {
      return;
    }
    add(left[static_cast<std::size_t>(worst - off.begin())]);
    for (std::size_t s = 0; s < left.size(); ++s) {
      takeOut(left[s], components_.back());
      off[s] = farthestOf(left[s]);
    }
  }
}

std::vector<ShapeFitter::Fit> ShapeFitter::fitOnce(std::span<const std::vector<float>> shapes,
                                                   std::vector<std::vector<float>>& left) const {
  const std::size_t size = basis_.mean.size();
  const std::size_t count = components_.size();
  left.clear();
  for (const std::vector<float>& shape : shapes) {
    left.push_back(differenceOf(shape));
  }
  std::vector<std::vector<double>> products(shapes.size(), std::vector<double>(count, 0.0));
  const auto overBlocks = [&](const auto& visit) {
    for (std::size_t begin = 0; begin < size; begin += kBlock) {
      const std::size_t length = std::min(kBlock, size - begin);
      for (std::size_t k = 0; k < count; ++k) {
        const std::span<const float> component(components_[k].data() + begin, length);
        for (std::size_t s = 0; s < left.size(); ++s) {
          visit(std::span<float>(left[s].data() + begin, length), component, s, k);
        }
      }
    }
  };
  overBlocks([&](std::span<float> part, std::span<const float> component, std::size_t s, std::size_t k) {
    products[s][k] += static_cast<double>(dotOf(part, component));
  });
  std::vector<Fit> fits(shapes.size());
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    fits[s].weights = solved(products[s]);
  }
  overBlocks([&](std::span<float> part, std::span<const float> component, std::size_t s, std::size_t k) {
    subtract(part, component, fits[s].weights[k]);
  });
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    fits[s].farthest = farthestOf(left[s]);
  }
  return fits;
}

std::vector<ShapeFitter::Fit> ShapeFitter::fit(std::span<const std::vector<float>> shapes) {
  std::vector<Fit> all;
  std::vector<std::vector<float>> left;
  for (std::size_t begin = 0; begin < shapes.size(); begin += kBatch) {
    const auto batch = shapes.subspan(begin, std::min(kBatch, shapes.size() - begin));
    std::vector<Fit> fits = fitOnce(batch, left);
    for (std::size_t s = 0; s < batch.size(); ++s) {
      std::vector<std::vector<float>> own{std::move(left[s])};
      while (fits[s].farthest > within_) {
        const bool others =
            components_.size() > fits[s].weights.size();  // an earlier shape of the batch has added some
        if (!others && components_.size() >= most_) {
          break;
        }
        if (!others) {
          add(own.front());
        }
        fits[s] = fitOnce(batch.subspan(s, 1), own).front();
      }
    }
    std::move(fits.begin(), fits.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace torsio::web
