// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "app/gui/physician/trace_view.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/simulator/loaded_scene.h"
#include "app/gui/widgets/theme.h"
#include "app/services/recording/trial_playback.h"
#include "app/services/review/blinded_case.h"

class QLabel;
class QToolButton;

namespace torsio::gui {

/// A blinded recording with everything to display it; created in a worker thread.
struct LoadedRecording {
  LoadedRecording(TrialPlayback itsPlayback, TraceData itsTraces, std::string itsDigest)
      : playback(std::move(itsPlayback)), traces(std::move(itsTraces)), digest(std::move(itsDigest)) {}

  TrialPlayback playback;
  TraceData traces;
  std::string digest;
  BlindedTask task;
  std::shared_ptr<const Scene> scene;  ///< null: the organ is not here, traces only
  ViewScene view;
  std::unique_ptr<AsyncModelPlayback> async;  ///< null: not needed by the view
};
/// Decodes, verifies and builds; a missing organ leaves the scene empty. Throws Error for an unplayable
/// recording. Worker thread.
[[nodiscard]] std::shared_ptr<LoadedRecording> loadForShowing(BlindedRecording recording,
                                                              const std::filesystem::path& assets);

/// A rater's player: the organ in 3D, the linked traces below it, and the transport. The page forwards keys
/// (handleKey), so that they work regardless of focus.
class ReplayPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ReplayPanel(const std::filesystem::path& assets, QWidget* parent = nullptr);

  void setTheme(const Theme& theme);
  void retranslate();
  /// Shows a sentence in place of the picture.
  void showSentence(const QString& sentence);
  /// Shows a recording; null: nothing.
  void show(std::shared_ptr<LoadedRecording> recording);
  /// Returns the label with the recording's digest, below the panel unless a page moves it.
  [[nodiscard]] QLabel* proof() noexcept { return digest_; }
  /// Sets the allowed speeds, ascending. A single one: locked.
  void setSpeeds(std::vector<double> speeds);
  void setBookmarks(std::vector<std::int64_t> times_us) { traces_->setBookmarks(std::move(times_us)); }
  void setWatched(std::vector<std::pair<std::int64_t, std::int64_t>> spans_us);

  [[nodiscard]] bool ready() const noexcept { return recording_ != nullptr; }
  [[nodiscard]] bool playing() const noexcept { return ready() && recording_->playback.playing(); }
  [[nodiscard]] std::int64_t position_us() const noexcept {
    return ready() ? recording_->playback.position_us() : 0;
  }
  [[nodiscard]] const LoadedRecording* recording() const noexcept { return recording_.get(); }
  void seek_us(std::int64_t position_us);
  void togglePlay();
  void pause();
  /// Handles Space, J, K, L, comma, period, Home, End. False: another key.
  bool handleKey(int key);
  /// Advances playback; called by the timer and by tests.
  void frame(double elapsed_s);
  /// Lets tests control the time.
  void setRealTime(bool realTime) noexcept { realTime_ = realTime; }

 Q_SIGNALS:
  /// A stretch was played without seeking.
  void played(qint64 from_us, qint64 to_us, double speed);
  void moved(qint64 position_us);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void createTransport();
  void fitTraces();
  void showTask();
  [[nodiscard]] static QString taskText(const BlindedTask& task);
  void showState();
  void showBeside();
  void showTransport();
  void changeSpeed(int direction);

  QLabel* task_;  // the exercise's task
  QLabel* sentence_;
  SceneView* view_;
  TraceView* traces_;
  QToolButton* back_;
  QToolButton* play_;
  QToolButton* forward_;
  QLabel* time_;
  QLabel* speed_;
  QLabel* digest_;
  const Theme* theme_;
  std::shared_ptr<LoadedRecording> recording_;
  std::vector<double> speeds_{1.0};
  QTimer timer_;
  QElapsedTimer sinceFrame_;
  bool realTime_ = true;
  bool playAsked_ = false;                    ///< before the recording was loaded
  std::optional<QElapsedTimer> awaitsFrame_;  // since when; afterwards the rest is updated
  std::optional<std::vector<std::pair<std::int64_t, std::int64_t>>> watched_us_;  // waits for the frame too
};

}  // namespace torsio::gui
