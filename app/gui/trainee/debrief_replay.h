// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "app/gui/scene/scene_view.h"
#include "app/gui/simulator/loaded_scene.h"
#include "app/services/recording/trial_playback.h"
#include "app/services/training/debrief.h"

class QLabel;
class QSlider;
class QToolButton;

namespace torsio::gui {

struct Theme;

/// A run and the expert's, prepared for the 3D view.
struct DebriefRecordings {
  explicit DebriefRecordings(TrialPlayback run) : own(std::move(run)) {}

  TrialPlayback own;
  std::optional<TrialPlayback> expert{};
  std::vector<double> grips_s{};  ///< of the run: the expert's twist starts at each
  double expertGrip_s = 0.0;      ///< in the expert's recording
  double expertLasts_s = 0.0;     ///< from there to the end of its twist
  std::shared_ptr<const Scene> scene{};
  ViewScene view{};
  std::unique_ptr<AsyncModelPlayback> async{};

  /// Returns the time in the expert's recording for a moment of the run; empty outside the twists.
  [[nodiscard]] std::optional<double> expertTime_s(double at_s) const noexcept;
};

/// Builds the recordings of a debrief; null if the organ is no longer here. `scene`: that of the run, if
/// already loaded. Takes seconds: worker thread.
[[nodiscard]] std::shared_ptr<DebriefRecordings> loadForDebrief(const Debrief& debrief,
                                                                const std::filesystem::path& assets,
                                                                std::shared_ptr<const Scene> scene);

/// One's own run in 3D with the expert's organ as a ghost, and one slider for both. Space plays, arrows step.
class DebriefReplay : public QWidget {
  Q_OBJECT

 public:
  explicit DebriefReplay(const std::filesystem::path& assets, QWidget* parent = nullptr);

  /// Shows the recordings; null: nothing.
  void show(std::shared_ptr<DebriefRecordings> recordings);
  void setExpertVisible(bool visible);
  void setTheme(const Theme& theme);
  void retranslate();
  void seek(double at_s);
  /// Returns a picture of the organ at a moment of the run, without the expert's; null if nothing can be
  /// drawn. Restores the view.
  [[nodiscard]] QImage pictureAt(double at_s);
  [[nodiscard]] double position_s() const noexcept;
  /// Returns whether the expert's organ is visible now.
  [[nodiscard]] bool ghostShown() const noexcept { return ghost_; }
  /// Advances playback; called by the timer and by tests.
  void frame(double elapsed_s);
  void togglePlay();

 Q_SIGNALS:
  void moved(double at_s);

 private:
  void showState();
  void showTransport();
  void showTime();

  SceneView* view_;
  QToolButton* play_;
  QSlider* slider_;
  QLabel* time_;
  const Theme* theme_;
  std::shared_ptr<DebriefRecordings> recordings_;
  bool expertVisible_ = true;
  bool ghost_ = false;
  QTimer timer_;
  QElapsedTimer sinceFrame_;
};

}  // namespace torsio::gui
