// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <thread>

#include "sim/baseline/grasped_organ.h"
#include "sim/baseline/lattice_skin.h"
#include "sim/core/async_model.h"
#include "sim/scene/scene.h"

namespace torsio {

/// Hands the newest shape that an asynchronous model has given the organ from the worker to whoever draws
/// it. Any threads; the servo is none of them.
class LatestShape {
 public:
  /// Prepares the skin of the organ over the key points of its lattice.
  explicit LatestShape(const Scene& scene) : skin_(scene.mesh, scene.lattice()) {}

  /// Replaces the shape; the jaw has turned by `angle_rad`.
  void put(double angle_rad, LatticePlaces places);
  /// Forgets the shape: another run begins.
  void clear();
  /// Returns the number of the newest shape, always another one; 0 before the first of a run.
  [[nodiscard]] std::int64_t number() const;
  /// Computes the vertices of the newest shape, one a vertex of the mesh; leaves `out_m` before the first.
  void vertices(std::span<Vec3> out_m) const;

 private:
  struct Shape {
    double angle_rad = 0.0;
    LatticePlaces places;
  };
  const LatticeSkin skin_;
  mutable std::mutex mutex_;
  std::shared_ptr<const Shape> shape_;
  std::int64_t count_ = 0;
};

/// Makes the model of an organ that a jaw holds at this arc length, m. Called in the thread of the work.
using GraspMaker = std::function<std::unique_ptr<GraspedOrgan>(double arc_m)>;

/// Runs a model that takes longer than a tick, outside the servo: reads the newest question, moves the model on
/// by a frame, delivers torque and slope. What throws or is no number is delivered as broken, and the model
/// is made anew. The servo is never waited for, and never waits.
class AsyncModelWorker {
 public:
  /// Prepares the work for a scene that such a model answers. `link` outlives the worker. `shape`: gets the
  /// organ's shape after each frame; null: nobody looks. `make`: empty: the model of the scene.
  AsyncModelWorker(std::shared_ptr<const Scene> scene, AsyncLink& link, std::shared_ptr<LatestShape> shape,
                   GraspMaker make = {});
  /// Ends the work after the frame that is being computed.
  ~AsyncModelWorker();
  AsyncModelWorker(const AsyncModelWorker&) = delete;
  AsyncModelWorker& operator=(const AsyncModelWorker&) = delete;

  /// Works in a thread of its own from now on, frame after frame. Once, and not after work().
  void start();
  /// Computes one frame for the newest question, in the calling thread. False: nothing is held, and there was
  /// nothing to do. Not after start().
  bool work();

  /// Returns how many frames a second the model manages on this machine, by the last ones; 0 before the
  /// first. Any thread.
  [[nodiscard]] double framesPerSecond() const noexcept { return rate_per_s_.load(); }

 private:
  void prepare(double arc_m);
  [[nodiscard]] AsyncAnswer answerTo(const AsyncQuestion& question);
  void noteFrame(double duration_s) noexcept;

  std::shared_ptr<const Scene> scene_;
  AsyncLink& link_;
  std::shared_ptr<LatestShape> shape_;
  GraspMaker make_;
  std::unique_ptr<GraspedOrgan> organ_;
  double arc_m_ = 0.0;  // of the jaw of organ_
  std::int64_t delivered_ = 0;
  int framesAtRest_ = 0;
  double meanFrame_s_ = 0.0;
  std::atomic<double> rate_per_s_{0.0};
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace torsio
