// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/blood_paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace torsio::web {

namespace {

constexpr float kWholeShare = 255.0F;
constexpr float kFactorStep = 0.001F;
constexpr double kClipStep_m = 0.0005;  // a sliding clip is repainted every half millimetre
constexpr std::size_t kMaxClips = 32;

std::uint8_t shareByte(float share) {
  return static_cast<std::uint8_t>(std::lround(kWholeShare * share));
}

/// A layer over the blood's colour in a range of frames.
struct PaintLayer {
  BloodMap::Paint paint;
  std::size_t from = 0;
  std::size_t to = 0;  ///< first frame without it
};

/// Bruises and tears in chronological order, then the clip at each place: the order of BloodMap.
class PaintLayers {
 public:
  explicit PaintLayers(const BloodMap& map) : map_(map) {}

  void add(std::size_t frame, const OrganState& state) {
    for (int i = 0; i < state.hollow.markCount; ++i) {
      const TissueMark& mark = state.hollow.marks[static_cast<std::size_t>(i)];
      auto known =
          std::find_if(marks_.begin(), marks_.end(), [&mark](const auto& one) { return one.first == mark; });
      if (known == marks_.end()) {
        known = marks_.insert(marks_.end(), {mark, {map_.markPaint(mark), frame, frame}});
      }
      known->second.to = frame + 1;
    }
    if (!state.hollow.clipped) {
      return;
    }
    const auto place = static_cast<std::int64_t>(std::llround(state.twist.graspArc_m / kClipStep_m));
    if (!clips_.empty() && clips_.back().first == place && clips_.back().second.to == frame) {
      clips_.back().second.to = frame + 1;
    } else if (clips_.size() < kMaxClips) {
      clips_.push_back({place, {map_.clipPaint(state.twist.graspArc_m), frame, frame + 1}});
    }
  }

  void writeTo(BinaryContainer& container) const {
    std::vector<std::uint8_t> shares;
    nlohmann::json paints = nlohmann::json::array();
    const auto put = [&](const PaintLayer& layer) {
      paints.push_back({{"factor", layer.paint.factor}, {"from", layer.from}, {"to", layer.to}});
      for (const float share : layer.paint.share) {
        shares.push_back(shareByte(share));
      }
    };
    for (const auto& [mark, layer] : marks_) {
      put(layer);
    }
    for (const auto& [place, layer] : clips_) {
      put(layer);
    }
    container.meta()["paints"] = std::move(paints);
    container.add("paint", std::span<const std::uint8_t>(shares));
  }

 private:
  const BloodMap& map_;
  std::vector<std::pair<TissueMark, PaintLayer>> marks_;
  std::vector<std::pair<std::int64_t, PaintLayer>> clips_;
};

}  // namespace

void addBloodPaint(BinaryContainer& container, const BloodMap& map, std::span<const OrganState> states,
                   std::span<const std::size_t> stateOfFrame) {
  if (map.empty()) {
    return;
  }
  std::vector<std::uint8_t> fed;
  for (const float share : map.fed()) {
    fed.push_back(shareByte(share));
  }
  std::vector<float> blood;
  PaintLayers layers(map);
  for (std::size_t frame = 0; frame < stateOfFrame.size(); ++frame) {
    const OrganState& state = states[stateOfFrame[frame]];
    const std::array<float, 3> factor = BloodMap::twistedFactor(state.hollow);
    blood.insert(blood.end(), factor.begin(), factor.end());
    layers.add(frame, state);
  }
  container.add("fed", std::span<const std::uint8_t>(fed));
  container.addMultiples("blood", blood, kFactorStep, 3);
  layers.writeTo(container);
}

}  // namespace torsio::web
