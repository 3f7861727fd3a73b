// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include <QSize>

#include "app/gui/practice/simulator_window.h"

namespace torsio::gui {

struct ScreenshotRequest {
  std::filesystem::path file;
  SceneRequest scene;
  std::optional<double> angle_rad;  ///< empty: the pattern's target
  QSize size{1280, 800};
  double zoom = 0.0;       ///< wheel steps towards the organ
  bool strip = false;      ///< instead of the window: the organ at several angles up to `angle_rad`
  bool sides = false;      ///< instead of the window: the organ from six sides, at rest and at that angle
  bool sceneOnly = false;  ///< without panels and bars
  bool lattice = false;
  bool wireframe = false;
  bool shear = false;    ///< coloured by shear stress
  bool markers = false;  ///< marker points
  bool ghost = false;    ///< the pose to reach
  RenderQuality quality = RenderQuality::kFine;
  double orbit_deg = 0.0;  ///< turn of the camera about the organ from the front
};

/// Shows the window, lets a scripted hand twist the organ to the angle, and writes a PNG. Throws
/// Error{kDevice} on a display that cannot draw the scene, Error{kFileUnwritable}, and like the scene loader.
void takeScreenshot(const WindowSetup& setup, const ScreenshotRequest& request);

/// Frame rate and servo timing, measured simultaneously.
struct FrameRate {
  double frames_per_s = 0.0;
  std::int64_t ticks = 0;  ///< ticks of the servo in that time, at 1 kHz
  std::int64_t lateTicks = 0;
  double slowestTick_us = 0.0;  ///< slowest of those sampled by the view
};

/// Measures the window while the organ is twisted to and fro for `seconds`, with a servo at its full rate.
[[nodiscard]] FrameRate measureFrameRate(const WindowSetup& setup, const ScreenshotRequest& request,
                                         double seconds);

}  // namespace torsio::gui
