// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/shear_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/contracts.h"
#include "sim/scene/hollow_organ.h"

namespace torsio::gui {

namespace {

constexpr int kWaySteps = 36;

/// Nunez, Anderton, Renslow: Optimizing colormaps (PLOS ONE 2018), seven equidistant stops of cividis.
constexpr std::array<std::array<float, 3>, 7> kCividis{{{0.000F, 0.135F, 0.305F},
                                                        {0.148F, 0.245F, 0.423F},
                                                        {0.321F, 0.348F, 0.427F},
                                                        {0.482F, 0.482F, 0.471F},
                                                        {0.647F, 0.613F, 0.460F},
                                                        {0.826F, 0.756F, 0.389F},
                                                        {0.995F, 0.909F, 0.218F}}};

}  // namespace

ShearMap::ShearMap(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {
  const SectionLattice& lattice = scene_->lattice();
  const int ridges = lattice.ridges();
  const int rows = lattice.sections() - 1;
  const auto coordinates = lattice.vertexCoordinates();
  const auto parts = lattice.vertexParts();
  weights_.resize(coordinates.size());
  for (std::size_t v = 0; v < weights_.size(); ++v) {
    if (parts[v] != LatticePart::kSide) {
      continue;
    }
    // In units of patches, from the centre of the first one.
    const double along = coordinates[v].arc_m / lattice.length_m() * rows - 0.5;
    const double about = coordinates[v].angle_rad / kTurn * ridges - 0.5;
    const auto row = static_cast<int>(std::floor(along));
    const auto column = static_cast<int>(std::floor(about));
    const auto s = static_cast<float>(along - row);
    const auto t = static_cast<float>(about - column);
    const auto patch = [&](int j, int k) {
      return std::clamp(j, 0, rows - 1) * ridges + ((k % ridges) + ridges) % ridges;
    };
    weights_[v].patches = {patch(row, column), patch(row, column + 1), patch(row + 1, column),
                           patch(row + 1, column + 1)};
    weights_[v].weights = {(1.0F - s) * (1.0F - t), (1.0F - s) * t, s * (1.0F - t), s * t};
  }
  patch_Pa_.resize(static_cast<std::size_t>(lattice.patches()));
  top_Pa_ = scene_->peakShear_Pa(scene_->stateAt(scene_->pattern.targetAngle_rad));
  if (scene_->hollow) {  // comes twisted; its shear is largest on the way, before it closes
    const double most_rad = scene_->hollow->detorsion().start.most_rad;
    for (int k = 1; k <= kWaySteps; ++k) {
      top_Pa_ = std::max(top_Pa_, scene_->peakShear_Pa(scene_->stateAt(most_rad * k / kWaySteps)));
    }
  }
}

void ShearMap::evaluate(const OrganState& state, std::span<float> share) {
  TORSIO_EXPECTS(share.size() == weights_.size());
  scene_->patchShear(state, patch_Pa_);
  const float scale = top_Pa_ > 0.0 ? static_cast<float>(1.0 / top_Pa_) : 0.0F;
  for (std::size_t v = 0; v < share.size(); ++v) {
    float stress_Pa = 0.0F;
    for (std::size_t k = 0; k < 4; ++k) {
      stress_Pa += weights_[v].weights[k] *
                   static_cast<float>(patch_Pa_[static_cast<std::size_t>(weights_[v].patches[k])]);
    }
    share[v] = std::clamp(stress_Pa * scale, 0.0F, 1.0F);
  }
}

std::array<float, 3> shearColour(float share) noexcept {
  const float place = std::clamp(share, 0.0F, 1.0F) * static_cast<float>(kCividis.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), kCividis.size() - 2);
  const float t = place - static_cast<float>(below);
  std::array<float, 3> colour{};
  for (std::size_t k = 0; k < 3; ++k) {
    colour[k] = kCividis[below][k] * (1.0F - t) + kCividis[below + 1][k] * t;
  }
  return colour;
}

}  // namespace torsio::gui
