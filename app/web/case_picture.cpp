// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/case_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/recording/trial_playback.h"
#include "app/web/binary_container.h"
#include "app/web/blood_paint.h"
#include "app/web/case_json.h"
#include "app/web/shapes/shape_basis.h"
#include "app/web/skin_shelf.h"
#include "assessment/attempt/recorded_loads.h"
#include "sim/base/angle.h"
#include "sim/base/error.h"
#include "sim/base/file_io.h"
#include "sim/base/live_of_sample.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/scene/blood_map.h"
#include "sim/scene/organ_state.h"
#include "sim/scene/scene.h"
#include "sim/scene/tissue_look.h"
#include "sim/servo/pose_track.h"
#include "sim/tissue/hollow/wrung_organ.h"

namespace torsio::web {

namespace {

constexpr std::int64_t kTraceRate_hz = 60;
constexpr std::int64_t kShapeRate_hz = 30;
constexpr std::int64_t kSecondOfRecording_us = 1'000'000;
constexpr std::size_t kMostComponents = 48;
constexpr std::size_t kLearnt = 48;   // shapes from which most components are made
constexpr std::size_t kAtATime = 16;  // shapes that are in memory at once
constexpr std::size_t kToolColumns = 7;
constexpr float kMillimetresAMetre = 1000.0F;

/// The page's frame: y up, z towards the viewer; the simulation's: LPS.
void appendPoint(std::vector<float>& to, const Vec3& point_m) {
  to.push_back(kMillimetresAMetre * static_cast<float>(point_m.x));
  to.push_back(kMillimetresAMetre * static_cast<float>(point_m.z));
  to.push_back(-kMillimetresAMetre * static_cast<float>(point_m.y));
}

void appendTurn(std::vector<float>& to, const Quat& orientation) {
  constexpr double kHalfRoot = 0.70710678118654752;  // a quarter turn about x, as the frame's
  const Quat turned = Quat{kHalfRoot, -kHalfRoot, 0.0, 0.0} * orientation;
  for (const double part : {turned.w, turned.x, turned.y, turned.z}) {
    to.push_back(static_cast<float>(part));
  }
}

/// The columns of the recording, one value a frame: what was true at its time, and between it and the next
/// one the lowest and the highest force, so that no peak is lost.
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
    untwisting_ = untwisting_ || sample.rules == kRulesOfDetorsion;
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

/// The organ at the times of the frames, from the scene.
class ShapeTrack {
 public:
  ShapeTrack(const Scene& scene, TrialPlayback& playback)
      : scene_(scene), places_m_(scene.mesh.vertices_m.size()) {
    const std::int64_t frames = playback.duration_us() * kShapeRate_hz / kSecondOfRecording_us + 1;
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      playback.seek_us(frame * kSecondOfRecording_us / kShapeRate_hz);
      const OrganState state = organStateOf(playback.state());
      if (states_.empty() || !(states_.back() == state)) {
        states_.push_back(state);
      }
      stateOfFrame_.push_back(states_.size() - 1);
    }
  }

  [[nodiscard]] std::size_t states() const noexcept { return states_.size(); }
  [[nodiscard]] std::span<const OrganState> all() const noexcept { return states_; }
  [[nodiscard]] const std::vector<std::size_t>& stateOfFrame() const noexcept { return stateOfFrame_; }
  [[nodiscard]] std::vector<float> shape(std::size_t state) {
    scene_.deform(states_[state], places_m_);
    return flat(places_m_);
  }
  [[nodiscard]] std::vector<float> rest() const { return flat(scene_.mesh.vertices_m); }

 private:
  static std::vector<float> flat(const std::vector<Vec3>& places_m) {
    std::vector<float> flat;
    flat.reserve(3 * places_m.size());
    for (const Vec3& place : places_m) {
      appendPoint(flat, place);
    }
    return flat;
  }

  const Scene& scene_;
  std::vector<OrganState> states_;
  std::vector<std::size_t> stateOfFrame_;
  std::vector<Vec3> places_m_;
};

/// A basis for all that happened, and the weights of each state.
struct FoundShapes {
  ShapeBasis basis;
  std::vector<float> weights;  // as many as components for each state
  float farthest_mm = 0.0F;
};

FoundShapes findShapes(ShapeTrack& track) {
  ShapeFitter fitter(track.rest(), kWithin_mm, kMostComponents);
  std::vector<std::vector<float>> shapes;
  const std::size_t stride = std::max<std::size_t>(1, track.states() / kLearnt);
  for (std::size_t state = 0; state < track.states(); state += stride) {
    shapes.push_back(track.shape(state));
  }
  fitter.learn(shapes);
  std::vector<ShapeFitter::Fit> fits;
  for (std::size_t state = 0; state < track.states();) {
    shapes.clear();
    for (; state < track.states() && shapes.size() < kAtATime; ++state) {
      shapes.push_back(track.shape(state));
    }
    std::vector<ShapeFitter::Fit> some = fitter.fit(shapes);
    std::move(some.begin(), some.end(), std::back_inserter(fits));
  }
  FoundShapes found{fitter.basis(), {}, 0.0F};
  for (ShapeFitter::Fit& fit : fits) {
    fit.weights.resize(found.basis.components(), 0.0F);
    found.weights.insert(found.weights.end(), fit.weights.begin(), fit.weights.end());
    found.farthest_mm = std::max(found.farthest_mm, fit.farthest);
  }
  return found;
}

void addMesh(BinaryContainer& container, const std::string& name, const TriangleMesh& mesh) {
  std::vector<std::uint32_t> index;
  for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
    index.insert(index.end(), triangle.begin(), triangle.end());
  }
  container.addDifferences(name, std::span<const std::uint32_t>(index), 3);
}

/// Shaft and jaws in the instrument's own frame, one after the other.
void addInstrument(BinaryContainer& container, const std::filesystem::path& assets, const std::string& id) {
  const std::filesystem::path folder = assets / "instruments";
  const nlohmann::json file = nlohmann::json::parse(readFile(folder / (id + ".json")));
  TriangleMesh whole;
  nlohmann::json parts = nlohmann::json::array();
  for (const char* part : {"shaft", "upper_jaw", "lower_jaw"}) {
    const TriangleMesh mesh = importMesh(folder / file.at("meshes").at(part).get<std::string>(),
                                         {.scale_m = 0.001, .organ = false});
    const auto first = static_cast<std::uint32_t>(whole.vertices_m.size());
    parts.push_back({{"name", part}, {"first", first}, {"count", mesh.vertices_m.size()}});
    whole.vertices_m.insert(whole.vertices_m.end(), mesh.vertices_m.begin(), mesh.vertices_m.end());
    for (const TriangleMesh::Triangle& t : mesh.triangles) {
      whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  }
  std::vector<float> places;
  for (const Vec3& p : whole.vertices_m) {
    for (const double part : {p.x, p.y, p.z}) {
      places.push_back(kMillimetresAMetre * static_cast<float>(part));
    }
  }
  addMesh(container, "tool_index", whole);
  container.add("tool_mean", std::span<const float>(places));
  container.meta()["tool"] = {{"parts", parts},
                              {"pivot_mm", file.at("jaws").at("pivot_mm")},
                              {"opening_deg", file.at("jaws").at("opening_deg")}};
}

/// What the window's tissue has at each vertex before light falls on it: its own colour and its patches.
std::vector<std::uint8_t> tissueColours(const Scene& scene) {
  const TissueLook look = tissueLook(scene.id);
  std::vector<std::uint8_t> colours;
  colours.reserve(3 * scene.mesh.vertices_m.size());
  for (const Vec3& place_m : scene.mesh.vertices_m) {
    const std::array<float, 3> factor = mottle(look, place_m);
    for (std::size_t k = 0; k < factor.size(); ++k) {
      // The factor is on light; a page's shader takes the square of what it gets for that.
      constexpr float kWhite = 255.0F;
      const float byte = static_cast<float>(look.colour[k]) * std::sqrt(std::max(factor[k], 0.0F));
      colours.push_back(static_cast<std::uint8_t>(std::lround(std::min(byte, kWhite))));
    }
  }
  return colours;
}

std::string organOf(const BlindedRecording& recording, TrialPlayback& playback,
                    const std::filesystem::path& assets, SkinShelf& skins, float& farthest_mm) {
  const auto shared = std::make_shared<const Scene>(loadScene(sceneOf(recording, assets)));
  const Scene& scene = *shared;
  checkScene(recording, scene);
  playback.setPoses(PoseTrack(scene, playback.header(), playback.chunks()));
  ShapeTrack track(scene, playback);
  const FoundShapes found = findShapes(track);
  farthest_mm = found.farthest_mm;
  const std::size_t components = found.basis.components();
  std::vector<float> weights;
  weights.reserve(track.stateOfFrame().size() * components);
  for (const std::size_t state : track.stateOfFrame()) {
    const auto first = found.weights.begin() + static_cast<std::ptrdiff_t>(state * components);
    weights.insert(weights.end(), first, first + static_cast<std::ptrdiff_t>(components));
  }
  const std::vector<std::uint8_t> colour = tissueColours(scene);
  BinaryContainer container;
  container.meta() = {{"vertices", scene.mesh.vertices_m.size()},
                      {"components", components},
                      {"frames", track.stateOfFrame().size()},
                      {"rate_hz", kShapeRate_hz},
                      {"scale", found.basis.scale},
                      {"skin", skins.put(scene)}};
  addMesh(container, "index", scene.mesh);
  container.addMultiples("mean", found.basis.mean, found.basis.meanStep, 3);
  container.addDifferences("basis", std::span<const std::int16_t>(found.basis.steps), 3);
  container.addMultiples("weights", weights, kWeightStep_mm, std::max<std::size_t>(components, 1));
  container.add("colour", std::span<const std::uint8_t>(colour));
  addBloodPaint(container, BloodMap(shared), track.all(), track.stateOfFrame());
  addInstrument(container, assets, "grasper");
  return gzipped(container.bytes());
}

}  // namespace

CasePicture casePicture(BlindedRecording recording, const std::filesystem::path& assets, SkinShelf& skins) {
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
    picture.organ = organOf(recording, *playback, assets, skins, picture.farthest_mm);
  } catch (const Error&) {
    picture.organ.clear();  // a user's own organ: the traces tell what can be told
  }
  BinaryContainer container;
  columns.writeTo(container);
  container.meta()["task"] = taskJson(recording.task);
  container.meta()["picture"] = !picture.organ.empty();
  picture.recording = gzipped(container.bytes());
  return picture;
}

}  // namespace torsio::web
