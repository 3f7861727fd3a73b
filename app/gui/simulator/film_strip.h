// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <QImage>
#include <QString>

#include "app/services/recording/trial_playback.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

class SceneView;

/// One picture of a film strip.
struct StripFrame {
  QString caption;
  QImage picture;
};

/// Width of a frame of a strip, pixels.
inline constexpr int kStripFrame = 480;
/// Width of a frame of a sheet of sides, pixels.
inline constexpr int kSideFrame = 240;

/// The frames in rows of equal pictures, so wide, with their captions below, on white: for papers and slides.
/// No row is longer than the first. Null when there are none.
[[nodiscard]] QImage filmStrip(const std::vector<std::vector<StripFrame>>& rows, int width = kStripFrame);

/// Frames that follow each other, in rows of four.
[[nodiscard]] std::vector<std::vector<StripFrame>> stripRows(const std::vector<StripFrame>& frames);

/// The angles of a strip: 0, 30, 60 ... degrees in the direction of `last_rad`, and at the end that angle
/// itself.
[[nodiscard]] std::vector<double> stripAngles_rad(double last_rad);

/// When a recording shows an angle for the first time.
struct StripMoment {
  double angle_rad = 0.0;
  std::int64_t position_us = 0;
};
/// The moments at which a recording first reaches each angle of a strip, up to the farthest that it went.
[[nodiscard]] std::vector<StripMoment> stripMoments(const TrialPlayback& playback);

/// Pictures of the organ alone at the angles of a strip up to `last_rad`, from the view's present direction.
/// Afterwards the view shows the last of them without an instrument: the caller shows again what it wants.
[[nodiscard]] std::vector<StripFrame> captureStrip(SceneView& view, const Scene& scene, double last_rad);

/// Square pictures of the organ alone from six sides: a row at rest and one turned by `angle_rad`. Afterwards
/// as captureStrip().
[[nodiscard]] std::vector<std::vector<StripFrame>> captureSides(SceneView& view, const Scene& scene,
                                                                double angle_rad);

/// "30\u00b0"
[[nodiscard]] QString angleCaption(double angle_rad);

}  // namespace torsio::gui
