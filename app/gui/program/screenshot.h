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
  std::optional<double> angle_rad;  ///< nothing: the target of the pattern
  QSize size{1280, 800};
  double zoom = 0.0;       ///< notches of the wheel nearer
  bool strip = false;      ///< the organ at several angles up to that one, instead of the window
  bool sides = false;      ///< the organ from six sides, at rest and at that angle, instead of the window
  bool sceneOnly = false;  ///< without panels and bars
  bool lattice = false;
  bool wireframe = false;
  bool shear = false;    ///< coloured by shear stress
  bool markers = false;  ///< marker points
  bool ghost = false;    ///< the pose to reach
  RenderQuality quality = RenderQuality::kFine;
  double orbit_deg = 0.0;  ///< the camera turns about the organ so far from the front
};

/// Shows the window, lets a scripted hand twist the organ to the angle, and writes what is seen as PNG.
/// Throws Error{kDevice} on a display that cannot draw the scene, {kFileUnwritable}, and what the scene
/// loader throws.
void takeScreenshot(const WindowSetup& setup, const ScreenshotRequest& request);

/// Frame rate and servo timing, measured together.
struct FrameRate {
  double frames_per_s = 0.0;
  std::int64_t ticks = 0;  ///< that the servo made meanwhile, at 1 kHz
  std::int64_t lateTicks = 0;
  double slowestTick_us = 0.0;  ///< of those that the view saw
};

/// The window while the organ is twisted to and fro for `seconds`, and a servo at its full rate beside it.
[[nodiscard]] FrameRate measureFrameRate(const WindowSetup& setup, const ScreenshotRequest& request,
                                         double seconds);

}  // namespace torsio::gui
