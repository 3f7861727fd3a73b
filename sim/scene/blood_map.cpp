// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/blood_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/contracts.h"
#include "sim/scene/hollow_organ.h"
#include "sim/tissue/hollow/perfusion.h"
#include "sim/tissue/twist/twist_model_tables.h"

namespace torsio {

namespace {

using Factor = std::array<float, 3>;

constexpr double kDemarcation = 0.25;  // of a span: over this length sound tissue fades into twisted
constexpr double kBruiseRadius_m = 0.006;
constexpr double kTearRadius_m = 0.005;
constexpr double kClipWidth_m = 0.004;
constexpr Factor kBruise{0.50F, 0.28F, 0.45F};
constexpr Factor kTear{0.55F, 0.06F, 0.08F};
constexpr Factor kClip{0.42F, 0.75F, 0.95F};

float smooth(double share) {
  const double u = std::clamp(share, 0.0, 1.0);
  return static_cast<float>(u * u * (3.0 - 2.0 * u));
}

void blend(Factor& factor, const Factor& towards, float share) {
  for (std::size_t k = 0; k < factor.size(); ++k) {
    factor[k] += share * (towards[k] - factor[k]);
  }
}

}  // namespace

BloodMap::BloodMap(std::shared_ptr<const Scene> scene) {
  if (!scene->hollow) {
    return;
  }
  scene_ = std::move(scene);
  const auto coordinates = scene_->lattice().vertexCoordinates();
  const std::vector<TwistVertex>& vertices = scene_->model.tables().vertices;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const TwistVertex& vertex = vertices[v];
    const HollowOrgan::Place place = scene_->hollow->placeOf(vertex.arc_m);
    places_.push_back({vertex.arc_m, coordinates[v].angle_rad,
                       norm(cross(vertex.line.direction, vertex.rest_m - vertex.line.point_m)),
                       place.span < 0 ? 1.0F : smooth(place.share / kDemarcation)});
  }
}

std::vector<float> BloodMap::fed() const {
  std::vector<float> shares;
  shares.reserve(places_.size());
  for (const Place& place : places_) {
    shares.push_back(place.fed);
  }
  return shares;
}

std::array<float, 3> BloodMap::twistedFactor(const HollowPose& pose) {
  const PerfusionState blood{.flow = pose.reading.flow,
                             .congestion = pose.congestion,
                             .dose = pose.reading.dose,
                             .saturation = pose.saturation};
  const TissueColour colour = pose.present ? colourOf(blood) : kSerosaPink;
  return {static_cast<float>(colour.red / kSerosaPink.red),
          static_cast<float>(colour.green / kSerosaPink.green),
          static_cast<float>(colour.blue / kSerosaPink.blue)};
}

void BloodMap::evaluate(const OrganState& state, std::span<Factor> factors) const {
  TORSIO_EXPECTS(factors.size() == places_.size());
  const HollowPose& pose = state.hollow;
  const Factor twisted = twistedFactor(pose);
  for (std::size_t v = 0; v < factors.size(); ++v) {
    factors[v] = {1.0F, 1.0F, 1.0F};
    blend(factors[v], twisted, places_[v].fed);
  }
  for (int i = 0; i < pose.markCount; ++i) {
    const TissueMark& mark = pose.marks[static_cast<std::size_t>(i)];
    for (std::size_t v = 0; v < factors.size(); ++v) {
      blend(factors[v], mark.torn ? kTear : kBruise, markShare(places_[v], mark));
    }
  }
  if (pose.clipped) {
    for (std::size_t v = 0; v < factors.size(); ++v) {
      blend(factors[v], kClip, clipShare(places_[v], state.twist.graspArc_m));
    }
  }
}

void BloodMap::cover(const OrganState& state, std::span<std::array<float, 4>> covers) const {
  TORSIO_EXPECTS(covers.size() == places_.size());
  std::fill(covers.begin(), covers.end(), std::array{0.0F, 0.0F, 0.0F, 1.0F});
  const auto lay = [&](const Factor& paint, const auto& shareAt) {
    for (std::size_t v = 0; v < covers.size(); ++v) {
      const float share = shareAt(places_[v]);
      for (std::size_t k = 0; k < paint.size(); ++k) {
        covers[v][k] += share * (paint[k] - covers[v][k]);
      }
      covers[v][3] *= 1.0F - share;
    }
  };
  const HollowPose& pose = state.hollow;
  for (int i = 0; i < pose.markCount; ++i) {
    const TissueMark& mark = pose.marks[static_cast<std::size_t>(i)];
    lay(mark.torn ? kTear : kBruise, [&](const Place& place) { return markShare(place, mark); });
  }
  if (pose.clipped) {
    lay(kClip, [&](const Place& place) { return clipShare(place, state.twist.graspArc_m); });
  }
}

BloodMap::Paint BloodMap::markPaint(const TissueMark& mark) const {
  Paint paint{mark.torn ? kTear : kBruise, {}};
  for (const Place& place : places_) {
    paint.share.push_back(markShare(place, mark));
  }
  return paint;
}

BloodMap::Paint BloodMap::clipPaint(double arc_m) const {
  Paint paint{kClip, {}};
  for (const Place& place : places_) {
    paint.share.push_back(clipShare(place, arc_m));
  }
  return paint;
}

float BloodMap::markShare(const Place& place, const TissueMark& mark) {
  const double reach_m = mark.torn ? kTearRadius_m : kBruiseRadius_m;
  const double along_m = place.arc_m - mark.arc_m;
  if (std::abs(along_m) >= reach_m) {
    return 0.0F;
  }
  const double round_m = place.radius_m * std::remainder(place.round_rad - mark.round_rad, kTurn);
  return smooth(2.0 * (1.0 - std::hypot(along_m, round_m) / reach_m));
}

float BloodMap::clipShare(const Place& place, double arc_m) {
  return smooth(2.0 * (1.0 - std::abs(place.arc_m - arc_m) / kClipWidth_m));
}

}  // namespace torsio
