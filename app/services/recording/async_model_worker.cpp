// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/async_model_worker.h"

#include <chrono>
#include <cmath>
#include <exception>
#include <utility>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

using WorkClock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kIdle{2};
constexpr int kFramesToRest = 60;        // after a grip, so that the model comes to rest
constexpr double kNewFrameWeight = 0.1;  // for the moving average

bool finite(const GraspedOrgan& organ) {
  return std::isfinite(organ.angle_rad()) && std::isfinite(organ.torque_Nm()) &&
         std::isfinite(organ.slope_Nm_per_rad());
}

}  // namespace

void LatestShape::put(double angle_rad, LatticePlaces places) {
  auto next = std::make_shared<const Shape>(Shape{angle_rad, std::move(places)});
  const std::lock_guard lock(mutex_);
  shape_ = std::move(next);
  ++count_;
}

void LatestShape::clear() {
  const std::lock_guard lock(mutex_);
  shape_.reset();
}

std::int64_t LatestShape::number() const {
  const std::lock_guard lock(mutex_);
  return shape_ ? count_ : 0;
}

void LatestShape::vertices(std::span<Vec3> out_m) const {
  std::shared_ptr<const Shape> newest;
  {
    const std::lock_guard lock(mutex_);
    newest = shape_;
  }
  if (newest) {
    skin_.deform(newest->places, newest->angle_rad, out_m);
  }
}

AsyncModelWorker::AsyncModelWorker(std::shared_ptr<const Scene> scene, AsyncLink& link,
                                   std::shared_ptr<LatestShape> shape, GraspMaker make)
    : scene_(std::move(scene)), link_(link), shape_(std::move(shape)), make_(std::move(make)) {
  TORSIO_EXPECTS(runsAsync(scene_->tissue));
  if (shape_) {
    shape_->clear();
  }
  if (!make_) {
    make_ = [scene = scene_.get()](double arc_m) {
      return graspedOrgan(scene->tissue, {&scene->mesh, &scene->lattice(), &scene->model, arc_m});
    };
  }
}

AsyncModelWorker::~AsyncModelWorker() {
  stopping_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
}

void AsyncModelWorker::start() {
  TORSIO_EXPECTS(!thread_.joinable() && delivered_ == 0);
  thread_ = std::thread([this] {
    while (!stopping_) {
      if (!work()) {
        std::this_thread::sleep_for(kIdle);
      }
    }
  });
}

/// Builds the model for one jaw position, reused for grips within half a section spacing.
void AsyncModelWorker::prepare(double arc_m) {
  const double step_m = scene_->lattice().length_m() / (scene_->lattice().sections() - 1);
  if (organ_ && std::abs(arc_m - arc_m_) <= 0.5 * step_m) {
    return;
  }
  organ_.reset();
  organ_ = make_(arc_m);
  arc_m_ = arc_m;
}

AsyncAnswer AsyncModelWorker::answerTo(const AsyncQuestion& question) {
  try {
    prepare(question.arc_m);
    const auto begun = WorkClock::now();
    organ_->turnTo(question.angle_rad);
    if (finite(*organ_)) {
      if (shape_) {
        shape_->put(organ_->angle_rad(), organ_->surface());
      }
      noteFrame(std::chrono::duration<double>(WorkClock::now() - begun).count());
      return {AsyncState::kSound, organ_->angle_rad(), organ_->torque_Nm(), organ_->slope_Nm_per_rad()};
    }
  } catch (const std::exception&) {
    // On any failure, tell the servo that there is no result.
  }
  organ_.reset();
  return {.state = AsyncState::kBroken};
}

bool AsyncModelWorker::work() {
  AsyncQuestion question = link_.questions.latest();
  const bool held = question.arc_m > 0.0;
  framesAtRest_ = held ? 0 : framesAtRest_ + 1;
  if (!held && (framesAtRest_ > kFramesToRest || !organ_)) {
    if (!organ_ && framesAtRest_ == 1) {
      try {
        prepare(scene_->grasp_m());  // before the first grip
      } catch (const std::exception&) {
        organ_.reset();  // the first grip will report it
      }
    }
    return false;
  }
  if (!held) {
    question.arc_m = arc_m_;
  }
  const AsyncAnswer answer = answerTo(question);
  link_.deliveries.publish({++delivered_, question.grip, answer});
  return true;
}

void AsyncModelWorker::noteFrame(double duration_s) noexcept {
  meanFrame_s_ =
      meanFrame_s_ > 0.0 ? meanFrame_s_ + kNewFrameWeight * (duration_s - meanFrame_s_) : duration_s;
  rate_per_s_ = meanFrame_s_ > 0.0 ? 1.0 / meanFrame_s_ : 0.0;
}

AsyncModelPlayback::AsyncModelPlayback(std::shared_ptr<const Scene> scene, std::shared_ptr<LatestShape> shape)
    : worker_(std::move(scene), link_, std::move(shape)) {
  worker_.start();
}

void AsyncModelPlayback::follow(const LiveState& shown) noexcept {
  link_.questions.publish({1, shown.response.graspArc_m, shown.response.angle_rad});
}

}  // namespace torsio
