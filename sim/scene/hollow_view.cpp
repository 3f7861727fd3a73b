// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/hollow_view.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "sim/base/contracts.h"

namespace torsio {

namespace {

constexpr std::size_t kHollowStreams = 11;
constexpr std::size_t kLanes = static_cast<std::size_t>(kKernelBlock);

void putLane(float* lane, const Vec3& v) {
  lane[0] = static_cast<float>(v.x);
  lane[kLanes] = static_cast<float>(v.y);
  lane[2 * kLanes] = static_cast<float>(v.z);
}

/// Where in the tables of a frame the section at a place stands.
float rowOf(const HollowOrgan::Place& place) {
  constexpr double kRows = HollowFrame::kRows;
  return static_cast<float>(place.span < 0 ? 2.0 * kRows : place.span * kRows + place.share * (kRows - 1.0));
}

}  // namespace

HollowView::HollowView(std::shared_ptr<const Scene> scene, Isa isa) : scene_(std::move(scene)), isa_(isa) {
  TORSIO_EXPECTS(scene_->hollow != nullptr);
  const std::vector<TwistVertex>& vertices = scene_->model.tables().vertices;
  const auto places = scene_->lattice().vertexCoordinates();
  vertices_ = vertices.size();
  const std::size_t blocks = (vertices_ + kLanes - 1) / kLanes;
  blocks_ = static_cast<int>(blocks);
  in_ = KernelBuffer<float>(blocks * kHollowStreams * kLanes);
  out_ = KernelBuffer<float>(blocks * 3 * kLanes, 2 * kLanes);
  for (std::size_t v = 0; v < vertices_; ++v) {
    const TwistVertex& vertex = vertices[v];
    const TwistLine& line = vertex.line;
    const Vec3 u = vertex.rest_m - line.point_m;
    float* lane = &in_[v / kLanes * kHollowStreams * kLanes + v % kLanes];
    putLane(lane, vertex.rest_m);
    putLane(lane + 3 * kLanes, u - dot(line.direction, u) * line.direction);
    putLane(lane + 6 * kLanes, line.direction);
    lane[9 * kLanes] = rowOf(scene_->hollow->placeOf(vertex.arc_m));
    lane[10 * kLanes] = static_cast<float>(places[v].angle_rad);
  }
}

std::span<const float> HollowView::updateBlocks(const OrganState& state) noexcept {
  HollowSkin(*scene_->hollow, state).write(rows_);
  const HollowFrame frame{rows_.turn.data(),  rows_.radius.data(), rows_.amplitude.data(),
                          rows_.crest.data(), rows_.waves[0],      rows_.waves[1]};
  twistKernels(isa_).hollow(in_.data(), blocks_, frame, out_.data());
  return {out_.data(), out_.size()};
}

void HollowView::deform(const OrganState& state, std::span<Vec3> out_m) noexcept {
  const std::span<const float> drawn = updateBlocks(state);
  for (std::size_t v = 0; v < std::min(vertices_, out_m.size()); ++v) {
    const float* lane = &drawn[v / kLanes * 3 * kLanes + v % kLanes];
    out_m[v] = {lane[0], lane[kLanes], lane[2 * kLanes]};
  }
}

}  // namespace torsio
