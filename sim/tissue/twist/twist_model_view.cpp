// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/twist_model_view.h"

#include <algorithm>
#include <cmath>

#include "sim/core/contracts.h"
#include "sim/core/index.h"
#include "sim/tissue/twist/twist_model_map.h"
#include "sim/tissue/twist/twist_model_tables.h"
#include "sim/tissue/view/twist_kernels.h"

namespace torsio {

namespace {

constexpr int kCurvedStreams = 11;
constexpr int kCurvedOnlyStreams = 10;
constexpr int kPaperStreams = 11;

void put(float* lane, const Vec3& v) {
  lane[0] = static_cast<float>(v.x);
  lane[kKernelBlock] = static_cast<float>(v.y);
  lane[2 * kKernelBlock] = static_cast<float>(v.z);
}

}  // namespace

TwistView::TwistView(const TwistModel& model, Isa isa)
    : model_(&model), isa_(isa), vertices_(static_cast<int>(model.tables().vertices.size())) {
  blocks_ = (vertices_ + kKernelBlock - 1) / kKernelBlock;
  out_ = KernelBuffer<float>(at(blocks_ * 3 * kKernelBlock), 2 * kKernelBlock);
  rest_ = KernelBuffer<float>(at(blocks_ * 3 * kKernelBlock), 4 * kKernelBlock);
  for (int v = 0; v < vertices_; ++v) {
    put(&lane(rest_, 3, v, 0), model.tables().vertices[at(v)].rest_m);
  }
  for (const TwistVertex& vertex : model.tables().vertices) {
    warped_ = warped_ || vertex.warp_m2 != 0.0;
  }
  choosePath();
  if (path_ == Path::kPaper) {
    fillPaperStreams();
  }
  if (path_ == Path::kCurved || path_ == Path::kAngles) {
    fillStreams();
  }
  if (path_ == Path::kAngles) {
    angles_ = KernelBuffer<float>(at(blocks_ * 2 * kKernelBlock));
  }
  if (path_ == Path::kSlow) {
    slow_m_.resize(at(vertices_));
  }
}

float& TwistView::lane(KernelBuffer<float>& buffer, int streams, int vertex, int stream) const noexcept {
  return buffer[at((vertex / kKernelBlock) * streams * kKernelBlock + stream * kKernelBlock +
                   vertex % kKernelBlock)];
}

void TwistView::choosePath() {
  const TwistModel::Tables& tables = model_->tables();
  if (tables.linear) {
    const bool free = tables.twist.ends() == EndCondition::kClampedFree;
    path_ = free && !tables.components ? Path::kPaper : Path::kSlow;
  } else if (tables.poynting) {
    path_ = Path::kSlow;
  } else {
    path_ = tables.twist.plain() ? Path::kCurved : Path::kAngles;
  }
}

void TwistView::fillStreams() {
  const TwistModel::Tables& tables = model_->tables();
  const bool curvedOnly = path_ == Path::kCurved && !warped_;
  const int streams = curvedOnly ? kCurvedOnlyStreams : kCurvedStreams;
  in_ = KernelBuffer<float>(at(blocks_ * streams * kKernelBlock));
  for (int v = 0; v < vertices_; ++v) {
    const TwistVertex& vertex = tables.vertices[at(v)];
    const TwistLine& line = vertex.line;
    const Vec3 u = vertex.rest_m - line.point_m;
    const Vec3 radius = u - dot(u, line.direction) * line.direction;
    put(&lane(in_, streams, v, 0), vertex.rest_m - radius);
    put(&lane(in_, streams, v, 3), radius);
    put(&lane(in_, streams, v, 6), line.direction);
    ValueSlope compliance{0.0, 1.0};
    if (path_ == Path::kCurved) {
      compliance = tables.twist.rising(vertex.arc_m);
    }
    lane(in_, streams, v, 9) = static_cast<float>(compliance.value);
    if (curvedOnly) {
      continue;
    }
    lane(in_, streams, v, 10) = static_cast<float>(vertex.warp_m2 * compliance.slope);
  }
}

void TwistView::fillPaperStreams() {
  const TwistModel::Tables& tables = model_->tables();
  in_ = KernelBuffer<float>(at(blocks_ * kPaperStreams * kKernelBlock));
  for (int v = 0; v < vertices_; ++v) {
    const TwistVertex& vertex = tables.vertices[at(v)];
    const TwistLine& line = vertex.line;
    const Vec3 u = vertex.rest_m - line.point_m;
    const Vec3 across = cross(line.direction, u);
    const double h = tables.spacing_m;
    const double lift = tables.lift.value(vertex.arc_m) * h / std::sqrt(dot(across, across) + h * h);
    put(&lane(in_, kPaperStreams, v, 0), vertex.rest_m);
    put(&lane(in_, kPaperStreams, v, 3), across);
    lane(in_, kPaperStreams, v, 6) = static_cast<float>(tables.twist.rising(vertex.arc_m).value);
    lane(in_, kPaperStreams, v, 7) = static_cast<float>(vertex.arc_m);
    put(&lane(in_, kPaperStreams, v, 8), lift * line.direction);
  }
}

void TwistView::curvedFrame(const TwistState& state) noexcept {
  const TwistModel::Tables& tables = model_->tables();
  const TorsionTable& table = tables.twist;
  const double grasp = table.graspAt(state.graspArc_m);
  const ValueSlope rising = table.rising(grasp);
  const double falling = table.falling(grasp).value;
  const double torque = state.graspAngle_rad / (rising.value * falling);
  // B falls from 1 by (1 - B(g)) / A(g) per unit of A: nothing for a free end.
  const double fall = (1.0 - falling) / rising.value;
  const double width = kBlendPerRadius * tables.radius.value(state.graspArc_m) * rising.slope;
  TwistFrame frame;
  frame.torque = static_cast<float>(torque);
  frame.nearSlope = static_cast<float>(falling);
  frame.farBase = static_cast<float>(rising.value);
  frame.farSlope = static_cast<float>(-rising.value * fall);
  frame.graspCompliance = static_cast<float>(rising.value);
  frame.inverseBlend = static_cast<float>(width > 0.0 ? 1.0 / width : 0.0);
  frame.nearRate = static_cast<float>(torque * falling);
  frame.farRate = static_cast<float>(-torque * rising.value * fall);
  const TwistKernels& kernels = twistKernels(isa_);
  (warped_ ? kernels.curvedWarp : kernels.curved)(in_.data(), blocks_, frame, out_.data());
}

void TwistView::anglesFrame(const TwistState& state) noexcept {
  const TwistModel::Tables& tables = model_->tables();
  const TwistMap map(tables, model_->lattice(), state);
  for (int v = 0; v < vertices_; ++v) {
    const double arc = tables.vertices[at(v)].arc_m;
    lane(angles_, 2, v, 0) = static_cast<float>(map.angle(arc));
    lane(angles_, 2, v, 1) = static_cast<float>(warped_ ? map.warpingRate(arc) : 0.0);
  }
  twistKernels(isa_).givenAngles(in_.data(), angles_.data(), blocks_, out_.data());
}

void TwistView::paperFrame(const TwistState& state) noexcept {
  const TorsionTable& table = model_->tables().twist;
  const double grasp = table.graspAt(state.graspArc_m);
  PaperFrame frame;
  frame.torque = static_cast<float>(state.graspAngle_rad / table.compliance(grasp));
  frame.graspArc = static_cast<float>(grasp);
  frame.graspAngle = static_cast<float>(table.compliance(grasp));
  twistKernels(isa_).paperLinear(in_.data(), blocks_, frame, out_.data());
}

void TwistView::slowFrame(const TwistState& state) noexcept {
  model_->deform(state, slow_m_);
  for (int v = 0; v < vertices_; ++v) {
    put(&lane(out_, 3, v, 0), slow_m_[at(v)]);
  }
}

std::span<const float> TwistView::updateBlocks(const TwistState& state) noexcept {
  if (state.graspAngle_rad == 0.0) {
    return {rest_.data(), rest_.size()};
  }
  switch (path_) {
    case Path::kCurved:
      curvedFrame(state);
      break;
    case Path::kAngles:
      anglesFrame(state);
      break;
    case Path::kPaper:
      paperFrame(state);
      break;
    case Path::kSlow:
      slowFrame(state);
      break;
  }
  return {out_.data(), out_.size()};
}

void TwistView::update(const TwistState& state, std::span<float> xyz, int stride) noexcept {
  const std::size_t needed = vertices_ > 0 ? at((vertices_ - 1) * stride + 3) : 0;
  if (stride < 3 || xyz.size() < needed) {
    return;
  }
  twistKernels(isa_).interleave(updateBlocks(state).data(), vertices_, xyz.data(), stride);
}

}  // namespace torsio
