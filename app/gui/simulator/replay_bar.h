// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <QImage>
#include <QString>
#include <QWidget>

#include "app/services/recording/trial_playback.h"
#include "sim/scene/scene.h"

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace torsio {
class TrialPlayback;
}

namespace torsio::gui {

struct Theme;

/// Play, pause, scrub and speed of a recording; shown below the scene while one is played.
class ReplayBar : public QWidget {
  Q_OBJECT

 public:
  explicit ReplayBar(QWidget* parent = nullptr);

  void setTheme(const Theme& theme);
  void retranslate();
  /// Shows this playback; null clears the bar.
  void show(const TrialPlayback* playback);

 Q_SIGNALS:
  void playToggled();
  void soughtTo(qint64 position_us);
  void speedChosen(double speed);
  void closed();

 private:
  const Theme* theme_;
  QToolButton* play_;
  QSlider* position_;
  QLabel* time_;
  QComboBox* speed_;
  QToolButton* close_;
  bool playing_ = false;
};

class SceneView;

/// A picture of a film strip.
struct StripFrame {
  QString caption;
  QImage picture;
};

/// Width of a strip's frame, px.
inline constexpr int kStripFrame = 480;
/// Width of a frame in a sheet of sides, px.
inline constexpr int kSideFrame = 240;

/// Arranges frames of equal size (`width` px) in rows with captions, on white, for papers and slides. No row
/// is longer than the first. Null if there are none.
[[nodiscard]] QImage filmStrip(const std::vector<std::vector<StripFrame>>& rows, int width = kStripFrame);

/// Arranges successive frames in rows of four.
[[nodiscard]] std::vector<std::vector<StripFrame>> stripRows(const std::vector<StripFrame>& frames);

/// Returns the angles of a strip: 0, 30, 60 ... degrees in the direction of `last_rad`, ending with
/// `last_rad`.
[[nodiscard]] std::vector<double> stripAngles_rad(double last_rad);

/// The first time an angle is reached in a recording.
struct StripMoment {
  double angle_rad = 0.0;
  std::int64_t position_us = 0;
};
/// Returns when a recording first reaches each angle of a strip, up to its largest angle.
[[nodiscard]] std::vector<StripMoment> stripMoments(const TrialPlayback& playback);

/// Takes pictures of the organ alone at the angles of a strip up to `last_rad`, from the present direction.
/// Leaves the view with the last one and no instrument: the caller restores it.
[[nodiscard]] std::vector<StripFrame> captureStrip(SceneView& view, const Scene& scene, double last_rad);

/// Takes square pictures of the organ alone from six sides: a row at rest and one turned by `angle_rad`.
/// Leaves the view like captureStrip().
[[nodiscard]] std::vector<std::vector<StripFrame>> captureSides(SceneView& view, const Scene& scene,
                                                                double angle_rad);

/// "30\u00b0"
[[nodiscard]] QString angleCaption(double angle_rad);

}  // namespace torsio::gui
