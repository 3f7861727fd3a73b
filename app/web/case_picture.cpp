// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/case_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/services/recording/trial_playback.h"
#include "app/web/binary_container.h"
#include "app/web/case_json.h"
#include "app/web/organ_shelf.h"
#include "app/web/shapes/shape_basis.h"
#include "assessment/attempt/recorded_loads.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/live_types.h"
#include "sim/scene/blood_map.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/hollow_view.h"
#include "sim/scene/organ_state.h"
#include "sim/scene/scene.h"
#include "sim/servo/pose_track.h"
#include "sim/tissue/hollow/wrung_organ.h"

namespace torsio::web {

namespace {

constexpr std::int64_t kTraceRate_hz = 60;
constexpr std::int64_t kSecondOfRecording_us = 1'000'000;
constexpr std::int64_t kMicrosAMilli = 1000;
constexpr std::int64_t kShapeStep_ms = 33;
// Tolerance against the middle shape; twice as much where a movement starts abruptly.
constexpr float kInterpolationTolerance_mm = 0.025F;
constexpr float kShared_mm = 2.0F;           // coarse shapes only: finer ones differ between recordings
constexpr std::size_t kMaxComponents = 64;   // limit of the pages' shader
constexpr std::size_t kLearningShapes = 48;  // number of shapes from which most components are learnt
constexpr std::size_t kShapesAtOnce = 16;    // number of shapes in memory at once
constexpr std::size_t kToolColumns = 7;
constexpr float kMillimetresAMetre = 1000.0F;

/// Appends in the page's frame, y up, z towards the viewer; the simulation's is LPS.
void appendPoint(std::vector<float>& to, const Vec3& point_m) {
  to.push_back(kMillimetresAMetre * static_cast<float>(point_m.x));
  to.push_back(kMillimetresAMetre * static_cast<float>(point_m.z));
  to.push_back(-kMillimetresAMetre * static_cast<float>(point_m.y));
}

void appendTurn(std::vector<float>& to, const Quat& orientation) {
  constexpr double kHalfRoot = 0.70710678118654752;  // a quarter turn about x, like that of the frame
  const Quat turned = Quat{kHalfRoot, -kHalfRoot, 0.0, 0.0} * orientation;
  for (const double part : {turned.w, turned.x, turned.y, turned.z}) {
    to.push_back(static_cast<float>(part));
  }
}

/// Columns of the recording, one value per frame: the value at its time; for forces also minimum and maximum
/// up to the next frame, so that no peak is lost.
class FrameColumns {
 public:
  void add(std::span<const Sample> samples, double& target_rad) {
    for (const Sample& sample : samples) {
      if (sample.command.kind == ServoCommand::Kind::kSetTarget) {
        target_rad = sample.command.value;
      }
      if (!begin_us_) {
        begin_us_ = sample.device.time_us;
      }
      const std::int64_t frame = (sample.device.time_us - *begin_us_) * kTraceRate_hz / kSecondOfRecording_us;
      while (static_cast<std::int64_t>(angle_.size()) <= frame) {
        begin(sample, target_rad);
      }
      const auto force = static_cast<float>(tissueForce_N(sample));
      low_.back() = std::min(low_.back(), force);
      high_.back() = std::max(high_.back(), force);
      length_us_ = sample.device.time_us - *begin_us_;
    }
  }

  void writeTo(BinaryContainer& container) const {
    container.meta()["rate_hz"] = kTraceRate_hz;
    container.meta()["frames"] = angle_.size();
    container.meta()["length_us"] = length_us_;
    container.add("angle_deg", std::span(angle_));
    container.add("torque_Nm", std::span(torque_));
    container.add("force_N", std::span(force_));
    container.add("force_low_N", std::span(low_));
    container.add("force_high_N", std::span(high_));
    container.add("target_deg", std::span(target_));
    container.add("tool", std::span(tool_));
    container.add("closed", std::span(closed_));
    container.add("held", std::span(held_));
    if (!untwisting_) {
      return;
    }
    container.add("flow_percent", std::span(flow_));
    container.add("dose", std::span(dose_));
    if (hasLumen_) {  // a testis has none
      container.add("patency_percent", std::span(patency_));
      container.add("pressure_mmHg", std::span(pressure_));
    }
  }

 private:
  void begin(const Sample& sample, double target_rad) {
    const LiveState state = liveStateOf(sample);
    const auto force = static_cast<float>(tissueForce_N(sample));
    angle_.push_back(static_cast<float>(degrees(state.response.angle_rad)));
    torque_.push_back(static_cast<float>(state.response.torque_Nm));
    target_.push_back(static_cast<float>(degrees(target_rad)));
    force_.push_back(force);
    low_.push_back(force);
    high_.push_back(force);
    appendPoint(tool_, state.tool.position_m);
    appendTurn(tool_, state.tool.orientation);
    constexpr double kWhole = 255.0;
    closed_.push_back(static_cast<std::uint8_t>(std::lround(kWhole * std::clamp(state.grip, 0.0, 1.0))));
    held_.push_back((state.contact & kContactHeld) != 0 ? 1 : 0);
    untwisting_ = untwisting_ || areOfDetorsion(sample.rules);
    addBlood(sample.hollow);
  }
  void addBlood(const HollowReading& organ) {
    constexpr float kPercent = 100.0F;
    flow_.push_back(kPercent * static_cast<float>(organ.flow));
    dose_.push_back(static_cast<float>(organ.dose));
    patency_.push_back(kPercent * static_cast<float>(organ.patency));
    pressure_.push_back(static_cast<float>(organ.pressure_Pa / kPascalsPerMmHg));
    hasLumen_ = hasLumen_ || organ.patency < 1.0 || organ.pressure_Pa != 0.0;
  }

  std::optional<std::int64_t> begin_us_;
  std::int64_t length_us_ = 0;
  std::vector<float> angle_, torque_, force_, low_, high_, target_, tool_;
  std::vector<float> flow_, dose_, patency_, pressure_;
  std::vector<std::uint8_t> closed_, held_;
  bool untwisting_ = false;
  bool hasLumen_ = false;
};

/// Shapes of the organ at selected moments of a recording, so dense that interpolation between two neighbours
/// deviates by at most kInterpolationTolerance_mm halfway.
class ShapeTrack {
 public:
  ShapeTrack(std::shared_ptr<const Scene> scene, TrialPlayback& playback)
      : scene_(std::move(scene)), playback_(playback), places_m_(scene_->mesh.vertices_m.size()) {
    if (scene_->hollow) {
      hollow_ = std::make_unique<HollowView>(scene_);
    }
    const std::int64_t last_ms = playback.duration_us() / kMicrosAMilli;
    Moment before = momentAt(0);
    add(before);
    for (std::int64_t time_ms = 0; time_ms < last_ms;) {
      time_ms = std::min(time_ms + kShapeStep_ms, last_ms);
      Moment after = momentAt(time_ms);
      addBetween(before, after);
      add(after);
      before = std::move(after);
    }
  }

  [[nodiscard]] std::size_t states() const noexcept { return states_.size(); }
  [[nodiscard]] std::span<const OrganState> all() const noexcept { return states_; }
  [[nodiscard]] std::span<const std::uint32_t> times_ms() const noexcept { return times_ms_; }
  [[nodiscard]] const std::vector<std::size_t>& stateOfFrame() const noexcept { return stateOfFrame_; }
  [[nodiscard]] std::vector<float> shape(std::size_t state) { return shapeOf(states_[state]); }
  [[nodiscard]] std::vector<float> rest() const { return flat(scene_->mesh.vertices_m); }
  /// Returns shapes along the twist pattern, to which most of a recording is close; identical for all
  /// recordings.
  [[nodiscard]] std::vector<std::vector<float>> pattern() {
    const TwistPattern& pattern = scene_->pattern;
    constexpr double kBeyond = 1.1;
    const double to_rad = pattern.detorsion != nullptr
                              ? pattern.detorsion->start.sign * pattern.detorsion->start.most_rad
                              : kBeyond * pattern.targetAngle_rad;
    std::vector<std::vector<float>> shapes;
    for (std::size_t i = 0; i < kLearningShapes; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(kLearningShapes - 1);
      shapes.push_back(shapeOf(scene_->stateAt(share * to_rad)));
    }
    return shapes;
  }

 private:
  struct Moment {
    std::int64_t time_ms = 0;
    OrganState state;
    std::vector<float> shape;
  };
  Moment momentAt(std::int64_t time_ms) {
    playback_.seek_us(time_ms * kMicrosAMilli);
    const OrganState state = organStateOf(playback_.state());
    return {time_ms, state, shapeOf(state)};
  }
  void add(const Moment& moment) {
    if (states_.empty() || !(states_.back() == moment.state)) {
      states_.push_back(moment.state);
    }
    stateOfFrame_.push_back(states_.size() - 1);
    times_ms_.push_back(static_cast<std::uint32_t>(moment.time_ms));
  }
  void addBetween(const Moment& before, const Moment& after) {
    if (after.time_ms - before.time_ms < 2 || before.state == after.state) {
      return;
    }
    const Moment middle = momentAt((before.time_ms + after.time_ms) / 2);
    const auto share = static_cast<float>(middle.time_ms - before.time_ms) /
                       static_cast<float>(after.time_ms - before.time_ms);
    float square = 0.0F;
    for (std::size_t i = 0; i < middle.shape.size(); i += 3) {
      float sum = 0.0F;
      for (std::size_t k = i; k < i + 3; ++k) {
        const float off = before.shape[k] + share * (after.shape[k] - before.shape[k]) - middle.shape[k];
        sum += off * off;
      }
      square = std::max(square, sum);
    }
    if (square > kInterpolationTolerance_mm * kInterpolationTolerance_mm) {
      addBetween(before, middle);
      add(middle);
      addBetween(middle, after);
    }
  }
  std::vector<float> shapeOf(const OrganState& state) {
    if (hollow_) {
      hollow_->deform(state, places_m_);
    } else {
      scene_->deform(state, places_m_);
    }
    return flat(places_m_);
  }
  static std::vector<float> flat(const std::vector<Vec3>& places_m) {
    std::vector<float> flat;
    flat.reserve(3 * places_m.size());
    for (const Vec3& place : places_m) {
      appendPoint(flat, place);
    }
    return flat;
  }

  std::shared_ptr<const Scene> scene_;
  TrialPlayback& playback_;
  std::unique_ptr<HollowView> hollow_;
  std::vector<OrganState> states_;
  std::vector<std::size_t> stateOfFrame_;
  std::vector<std::uint32_t> times_ms_;
  std::vector<Vec3> places_m_;
};

/// A basis for all shapes, and the weights of each.
struct FoundShapes {
  ShapeBasis basis;
  std::size_t shared = 0;      // components common to all recordings of the pattern
  std::vector<float> weights;  // one per component for each state
  float farthest_mm = 0.0F;
};

FoundShapes findShapes(ShapeTrack& track) {
  ShapeFitter fitter(track.rest(), kWithin_mm, kMaxComponents);
  std::vector<std::vector<float>> shapes = track.pattern();
  fitter.learn(shapes, kShared_mm);
  const std::size_t shared = fitter.basis().components();
  shapes.clear();
  const std::size_t stride = std::max<std::size_t>(1, track.states() / kLearningShapes);
  for (std::size_t state = 0; state < track.states(); state += stride) {
    shapes.push_back(track.shape(state));
  }
  fitter.learn(shapes, kWithin_mm);
  std::vector<ShapeFitter::Fit> fits;
  for (std::size_t state = 0; state < track.states();) {
    shapes.clear();
    for (; state < track.states() && shapes.size() < kShapesAtOnce; ++state) {
      shapes.push_back(track.shape(state));
    }
    std::vector<ShapeFitter::Fit> some = fitter.fit(shapes);
    std::move(some.begin(), some.end(), std::back_inserter(fits));
  }
  FoundShapes found{fitter.basis(), shared, {}, 0.0F};
  for (ShapeFitter::Fit& fit : fits) {
    fit.weights.resize(found.basis.components(), 0.0F);
    found.weights.insert(found.weights.end(), fit.weights.begin(), fit.weights.end());
    found.farthest_mm = std::max(found.farthest_mm, fit.farthest);
  }
  return found;
}

void putOrgan(const BlindedRecording& recording, TrialPlayback& playback, const std::filesystem::path& assets,
              OrganShelf& shelf, CasePicture& picture) {
  const auto shared = std::make_shared<const Scene>(loadScene(sceneOf(recording, assets)));
  const Scene& scene = *shared;
  checkScene(recording, scene);
  playback.setPoses(PoseTrack(scene, playback.header(), playback.chunks()));
  ShapeTrack track(shared, playback);
  const FoundShapes found = findShapes(track);
  picture.farthest_mm = found.farthest_mm;
  OrganShelf::Body body = shelf.putBody(organBody(scene, found.basis.upTo(found.shared), assets));
  const std::size_t components = found.basis.components();
  std::vector<float> weights;
  weights.reserve(track.stateOfFrame().size() * components);
  for (const std::size_t state : track.stateOfFrame()) {
    const auto first = found.weights.begin() + static_cast<std::ptrdiff_t>(state * components);
    weights.insert(weights.end(), first, first + static_cast<std::ptrdiff_t>(components));
  }
  const ShapeBasis own = found.basis.from(found.shared);
  BinaryContainer rest;
  rest.meta() = {{"components", own.components()},
                 {"frames", track.stateOfFrame().size()},
                 {"scale", own.scale},
                 {"body", body.name},
                 {"skin", shelf.putSkin(scene)}};
  rest.addDifferences("time_ms", track.times_ms(), 1);
  rest.addMultiples("weights", weights, kWeightStep_mm, std::max<std::size_t>(components, 1));
  addBloodPaint(rest, BloodMap(shared), track.all(), track.stateOfFrame());
  // Smooth displacements compress better as differences, those of folds as they are.
  BinaryContainer other = rest;
  rest.addDifferences("basis", std::span<const std::int16_t>(own.steps), 3);
  other.add("basis", std::span<const std::int16_t>(own.steps));
  picture.organ = std::min(gzipped(rest.bytes()), gzipped(other.bytes()),
                           [](const auto& one, const auto& two) { return one.size() < two.size(); });
  picture.body = std::move(body.bytes);
}

}  // namespace

CasePicture casePicture(BlindedRecording recording, const std::filesystem::path& assets, OrganShelf& shelf) {
  CasePicture picture;
  std::optional<TrialPlayback> playback;
  FrameColumns columns;
  try {
    double target_rad = recording.trial.header.targetAngle_rad;
    Trial trial{recording.trial.header, std::move(recording.trial.chunks), recording.trial.summary};
    playback.emplace(std::move(trial),
                     [&](std::span<const Sample> samples) { columns.add(samples, target_rad); });
  } catch (...) {
    rethrowBlinded(std::current_exception(), recording.label);
  }
  try {
    putOrgan(recording, *playback, assets, shelf, picture);
  } catch (const Error&) {
    picture.organ.clear();  // a user's own organ is not here: only traces are shown
  }
  picture.length_us = playback->duration_us();
  BinaryContainer container;
  columns.writeTo(container);
  container.meta()["task"] = taskJson(recording.task);
  container.meta()["picture"] = !picture.organ.empty();
  picture.recording = gzipped(container.bytes());
  return picture;
}

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

namespace {

std::size_t bytesOf(const CasePicture& picture) {
  return picture.recording.size() + picture.organ.size();
}

}  // namespace

std::shared_ptr<const CasePicture> PictureCache::kept(const std::string& recording) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(kept_.begin(), kept_.end(),
                                  [&recording](const Kept& one) { return one.recording == recording; });
  if (found == kept_.end()) {
    return nullptr;
  }
  kept_.splice(kept_.begin(), kept_, found);
  return kept_.front().picture;
}

std::shared_ptr<const CasePicture> PictureCache::of(const std::string& recording,
                                                    const std::function<CasePicture()>& make) {
  if (auto picture = kept(recording)) {
    return picture;
  }
  const std::lock_guard one(making_);
  if (auto picture = kept(recording)) {
    return picture;  // made by another thread meanwhile
  }
  auto made = std::make_shared<const CasePicture>(make());
  const std::lock_guard lock(mutex_);
  kept_.push_front({recording, made});
  bytes_ += bytesOf(*made);
  while (bytes_ > most_bytes_ && kept_.size() > 1) {
    bytes_ -= bytesOf(*kept_.back().picture);
    kept_.pop_back();
  }
  return made;
}

}  // namespace torsio::web
