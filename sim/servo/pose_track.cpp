// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/pose_track.h"

#include <algorithm>
#include <iterator>

#include "sim/record/sample_codec.h"
#include "sim/servo/replay_trial.h"

namespace torsio {

namespace {

constexpr std::int64_t kApart_us = 40'000;
constexpr double kApart_m = 0.002;
constexpr std::int64_t kMomentsApart_us = 100'000;

double farthest_m(const RodPose& a, const RodPose& b) noexcept {
  double farthest = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(std::min(a.count, b.count)); ++i) {
    farthest = std::max(farthest, norm(a.nodes[i].position_m - b.nodes[i].position_m));
  }
  return farthest;
}

}  // namespace

PoseTrack::PoseTrack(const Scene& scene, const TrialHeader& header, std::span<const TrialChunk> chunks) {
  if ((!scene.rod && !scene.hollow) || chunks.empty()) {
    return;
  }
  TrialRerun rerun(scene, header, decodeChunk(chunks.front()).front().rules);
  RodPose kept;
  for (const TrialChunk& chunk : chunks) {
    for (const Sample& recorded : decodeChunk(chunk)) {
      rerun.next(recorded);
      if (scene.hollow) {
        keep(recorded.device.time_us, rerun.organ().hollow);
      }
      const RodPose& pose = rerun.organ().pose;
      const std::int64_t time_us = recorded.device.time_us;
      const bool wasAtRest = shapes_.empty() || shapes_.back().count == 0;
      const bool moved = pose.count > 0;
      if (wasAtRest == moved ||
          (moved && (time_us - shapes_.back().time_us >= kApart_us || farthest_m(kept, pose) > kApart_m))) {
        keep(time_us, pose);
        kept = pose;
      }
    }
  }
}

void PoseTrack::keep(std::int64_t time_us, const HollowPose& pose) {
  if (!moments_.empty() && time_us - moments_.back().time_us < kMomentsApart_us) {
    const HollowPose& last = moments_.back().pose;
    if (last.clipped == pose.clipped && last.venting == pose.venting && last.leaking == pose.leaking &&
        last.check == pose.check && last.markCount == pose.markCount) {
      return;
    }
  }
  moments_.push_back({time_us, pose});
}

HollowPose PoseTrack::hollowAt(std::int64_t time_us) const noexcept {
  const auto after = std::upper_bound(moments_.begin(), moments_.end(), time_us,
                                      [](std::int64_t t, const Moment& m) { return t < m.time_us; });
  if (moments_.empty()) {
    return {};
  }
  return after == moments_.begin() ? moments_.front().pose : std::prev(after)->pose;
}

void PoseTrack::keep(std::int64_t time_us, const RodPose& pose) {
  shapes_.push_back({.time_us = time_us, .count = pose.count, .first = nodes_.size()});
  for (std::size_t i = 0; i < static_cast<std::size_t>(pose.count); ++i) {
    const Vec3& p = pose.nodes[i].position_m;
    const Quat& q = pose.nodes[i].orientation;
    nodes_.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
                      static_cast<float>(q.w), static_cast<float>(q.x), static_cast<float>(q.y),
                      static_cast<float>(q.z)});
  }
}

RodPose PoseTrack::pose(const Shape& shape) const noexcept {
  RodPose pose;
  pose.count = shape.count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(shape.count); ++i) {
    const Node& node = nodes_[shape.first + i];
    pose.nodes[i] = {.position_m = {node[0], node[1], node[2]},
                     .orientation = normalized(Quat{node[3], node[4], node[5], node[6]})};
  }
  return pose;
}

RodPose PoseTrack::at(std::int64_t time_us) const noexcept {
  const auto after = std::upper_bound(shapes_.begin(), shapes_.end(), time_us,
                                      [](std::int64_t t, const Shape& s) { return t < s.time_us; });
  if (after == shapes_.begin()) {
    return {};
  }
  const Shape& before = *(after - 1);
  if (before.count == 0 || after == shapes_.end() || after->count == 0) {
    return pose(before);
  }
  const double share =
      static_cast<double>(time_us - before.time_us) / static_cast<double>(after->time_us - before.time_us);
  return poseBetween(pose(before), pose(*after), share);
}

}  // namespace torsio
