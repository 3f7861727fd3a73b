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
#include "sim/baseline/lattice_surface.h"
#include "sim/core/async_model.h"
#include "sim/core/live_types.h"
#include "sim/scene/scene.h"

namespace torsio {

/// Passes the latest shape computed by an asynchronous model from the worker to the renderer. Any thread
/// except the servo's.
class LatestShape {
 public:
  /// Prepares the mapping from the lattice's key points to the organ's skin.
  explicit LatestShape(const Scene& scene) : skin_(scene.mesh, scene.lattice()) {}

  /// Stores a shape; the jaw has turned by `angle_rad`.
  void put(double angle_rad, LatticePlaces places);
  /// Clears the shape at the start of a run.
  void clear();
  /// Returns the number of the latest shape, unique per shape; 0 before the first one of a run.
  [[nodiscard]] std::int64_t number() const;
  /// Computes the mesh vertices of the latest shape; leaves `out_m` unchanged if there is none.
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

/// Creates the model of an organ that a jaw holds at this arc length, m. Called in the worker thread.
using GraspMaker = std::function<std::unique_ptr<GraspedOrgan>(double arc_m)>;

/// Runs a model that is slower than a tick in parallel with the servo: reads the latest command, advances the
/// model by a frame, and delivers torque and slope. If the model throws or returns NaN, reports it as broken
/// and rebuilds it. Neither side blocks the other.
class AsyncModelWorker {
 public:
  /// Prepares a worker for a scene with such a model. `link` outlives the worker. `shape`: receives the
  /// organ's shape after each frame; may be null. `make`: if empty, the scene's model.
  AsyncModelWorker(std::shared_ptr<const Scene> scene, AsyncLink& link, std::shared_ptr<LatestShape> shape,
                   GraspMaker make = {});
  /// Stops after the current frame.
  ~AsyncModelWorker();
  AsyncModelWorker(const AsyncModelWorker&) = delete;
  AsyncModelWorker& operator=(const AsyncModelWorker&) = delete;

  /// Computes frames in a separate thread from now on. Call once, and not after work().
  void start();
  /// Computes one frame for the latest command in the calling thread. Returns false if nothing is held and
  /// there is nothing to do. Not after start().
  bool work();

  /// Returns the model's recent frame rate on this machine, 1/s; 0 before the first frame. Any thread.
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
  double arc_m_ = 0.0;  // jaw position of organ_
  std::int64_t delivered_ = 0;
  int framesAtRest_ = 0;
  double meanFrame_s_ = 0.0;
  std::atomic<double> rate_per_s_{0.0};
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

/// Recomputes the organ's shape when playing a recording that was made with an asynchronous model. Forces,
/// angles and times come from the recording; only the shape is computed again, at this machine's rate, by the
/// same model moved to the recorded angles.
class AsyncModelPlayback {
 public:
  /// Starts the model for a playback of `scene`; its shapes go to `shape`.
  AsyncModelPlayback(std::shared_ptr<const Scene> scene, std::shared_ptr<LatestShape> shape);
  /// Moves the model to the displayed state. One thread.
  void follow(const LiveState& shown) noexcept;

 private:
  AsyncLink link_;
  AsyncModelWorker worker_;
};

}  // namespace torsio
