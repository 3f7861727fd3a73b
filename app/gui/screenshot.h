// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include <QSize>

#include "app/gui/main_window.h"

namespace torsio::gui {

struct ScreenshotRequest {
  std::filesystem::path file;
  SceneRequest scene;
  std::optional<double> angle_rad;  ///< nothing: the target of the pattern
  QSize size{1280, 800};
  bool sceneOnly = false;  ///< without panels and bars
  bool lattice = false;
  bool wireframe = false;
  RenderQuality quality = RenderQuality::kFine;
  double orbit_deg = 0.0;  ///< the camera turns about the organ so far from the front
};

/// Shows the window, lets a scripted hand twist the organ to the angle, and writes what is seen as PNG.
/// Throws Error{kDevice} on a display that cannot draw the scene, {kFileUnwritable}, and what the scene
/// loader throws.
void takeScreenshot(const WindowSetup& setup, const ScreenshotRequest& request);

/// Frames per second of the window while the organ is twisted to and fro for `seconds`.
[[nodiscard]] double measureFrameRate(const WindowSetup& setup, const ScreenshotRequest& request,
                                      double seconds);

}  // namespace torsio::gui
