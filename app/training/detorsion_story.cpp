// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/training/detorsion_story.h"

#include <algorithm>
#include <cmath>

#include "sim/base/contracts.h"
#include "sim/base/device_sample.h"
#include "sim/servo/detorsion.h"

namespace torsio {

namespace {

constexpr std::size_t kStoryPoints = 4000;

/// Follows what holds the organ and whether a check runs, tick by tick, as the servo decides it.
class StoryTeller {
 public:
  StoryTeller(DetorsionStory& story, double residual_rad) : story_(story), residual_rad_(residual_rad) {}

  void take(const Sample& sample, std::int64_t at_us, double at_s) {
    setClip(sample, at_s);
    const bool holds = sample.phase == ExercisePhase::kTwisting;
    mark(holds_, holds, at_s, DetorsionMoment::kGrip, DetorsionMoment::kLetGo);
    if (sample.command.kind == ServoCommand::Kind::kVent) {
      mark(venting_, sample.command.value != 0.0, at_s, DetorsionMoment::kVentOpen,
           DetorsionMoment::kVentShut);
    }
    setCheck(sample, at_us, at_s);
    angle_rad_ = sample.response.angle_rad;
  }

  [[nodiscard]] DetorsionDoing doing() const noexcept {
    if (ready_us_ >= 0) {
      return DetorsionDoing::kChecking;
    }
    if (holds_) {
      return DetorsionDoing::kTurning;
    }
    if (clipped_) {
      return DetorsionDoing::kClipped;
    }
    return std::abs(angle_rad_) <= residual_rad_ ? DetorsionDoing::kWaiting : DetorsionDoing::kSearching;
  }

 private:
  void mark(bool& state, bool now, double at_s, DetorsionMoment on, DetorsionMoment off) {
    if (state != now) {
      story_.events.push_back({at_s, now ? on : off});
      state = now;
    }
  }

  void setClip(const Sample& sample, double at_s) {
    const bool pressed = (sample.device.buttons & kButtonSecond) != 0;
    bool now = clipped_;
    if (sample.command.kind == ServoCommand::Kind::kHoldOrgan) {
      now = sample.command.value != 0.0;
    } else if (pressed && !pressed_ && atOrgan_) {
      now = !now;
    }
    mark(clipped_, now, at_s, DetorsionMoment::kClipOn, DetorsionMoment::kClipOff);
    pressed_ = pressed;
    atOrgan_ = sample.phase == ExercisePhase::kContact || sample.phase == ExercisePhase::kTwisting;
  }

  void setCheck(const Sample& sample, std::int64_t at_us, double at_s) {
    if (sample.command.kind == ServoCommand::Kind::kCheckFlow && ready_us_ < 0) {
      const auto check = static_cast<FlowCheck>(static_cast<int>(sample.command.value));
      ready_us_ = at_us + flowCheckCost(check).time_us;
      checkedAt_rad_ = sample.response.angle_rad;
      story_.events.push_back({at_s, DetorsionMoment::kCheck});
    }
    const bool broken = holds_ && std::abs(sample.response.angle_rad - checkedAt_rad_) > kCheckTurn_rad;
    if (ready_us_ >= 0 && (broken || at_us >= ready_us_)) {
      ready_us_ = -1;
    }
  }

  DetorsionStory& story_;
  double residual_rad_;
  double angle_rad_ = 0.0;
  double checkedAt_rad_ = 0.0;
  std::int64_t ready_us_ = -1;
  bool holds_ = false;
  bool clipped_ = false;
  bool venting_ = false;
  bool pressed_ = true;  // one that is held down at the start sets no clip
  bool atOrgan_ = false;
};

}  // namespace

DetorsionStory detorsionStory(std::span<const Sample> samples, std::span<const std::int64_t> times_us,
                              const DetorsionRules& rules, const Outcome<DetorsionMetrics>& metrics) {
  TORSIO_EXPECTS(times_us.size() == samples.size());
  DetorsionStory story;
  story.timeScale = rules.timeScale;
  story.residual_rad = rules.residual_rad;
  story.enoughFlow = rules.enoughFlow;
  if (metrics) {
    story.metrics = metrics.value().values;
  }
  StoryTeller teller(story, rules.residual_rad);
  const std::size_t stride = std::max<std::size_t>(1, (samples.size() + kStoryPoints - 1) / kStoryPoints);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    const double at_s = static_cast<double>(times_us[i] - times_us.front()) * 1e-6;
    teller.take(sample, times_us[i], at_s);
    if (i + 1 < samples.size()) {
      story.spent_s[static_cast<std::size_t>(teller.doing())] +=
          static_cast<double>(times_us[i + 1] - times_us[i]) * 1e-6;
    }
    if (i % stride == 0 || i + 1 == samples.size()) {
      story.time_s.push_back(at_s);
      story.angle_rad.push_back(sample.response.angle_rad);
      story.flow.push_back(sample.hollow.flow);
      story.dose.push_back(sample.hollow.dose);
      story.pressure_Pa.push_back(sample.hollow.pressure_Pa);
    }
  }
  return story;
}

}  // namespace torsio
