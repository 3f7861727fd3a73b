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
#include "app/gui/simulator/async_view.h"
#include "app/gui/widgets/theme.h"
#include "app/services/recording/trial_playback.h"
#include "app/services/review/blinded_case.h"

class QLabel;
class QToolButton;

namespace torsio::gui {

/// A blinded recording with everything that its showing needs; made in a worker thread.
struct LoadedRecording {
  LoadedRecording(TrialPlayback itsPlayback, TraceData itsTraces, std::string itsDigest)
      : playback(std::move(itsPlayback)), traces(std::move(itsTraces)), digest(std::move(itsDigest)) {}

  TrialPlayback playback;
  TraceData traces;
  std::string digest;
  BlindedTask task;
  std::shared_ptr<const Scene> scene;  ///< null: the organ is not here, traces only
  ViewScene view;
  std::unique_ptr<AsyncModelPlayback> async;  ///< null: the view needs none
};
/// Decodes, checks and builds; a missing organ leaves the scene empty. Throws Error for a recording that
/// cannot be played. Worker thread.
[[nodiscard]] std::shared_ptr<LoadedRecording> loadForShowing(BlindedRecording recording,
                                                              const std::filesystem::path& assets);

/// The organ in 3D, the linked traces under it, and the transport: what a rater watches. Keys come from the
/// page (handleKey), so that they work wherever the focus is.
class ReplayPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ReplayPanel(const std::filesystem::path& assets, QWidget* parent = nullptr);

  void setTheme(const Theme& theme);
  void retranslate();
  /// A sentence in place of the picture.
  void showSentence(const QString& sentence);
  /// Null: nothing to show.
  void show(std::shared_ptr<LoadedRecording> recording);
  /// Says what proves the recording, below the panel unless a page puts it where it has more room.
  [[nodiscard]] QLabel* proof() noexcept { return digest_; }
  /// Allowed speeds, rising. One: locked.
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
  /// Space, J, K, L, comma, period, Home, End. False: not a key of the transport.
  bool handleKey(int key);
  /// Moves a playing recording on; the timer calls it, and tests.
  void frame(double elapsed_s);
  /// Tests move the time themselves.
  void setRealTime(bool realTime) noexcept { realTime_ = realTime; }

 Q_SIGNALS:
  /// A stretch went by by itself.
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

  QLabel* task_;  // what the exercise asks for
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
  bool playAsked_ = false;                    ///< before the recording was there
  std::optional<QElapsedTimer> awaitsFrame_;  // since when; then what stands beside the picture follows
  std::optional<std::vector<std::pair<std::int64_t, std::int64_t>>> watched_us_;  // waits for the frame too
};

}  // namespace torsio::gui
