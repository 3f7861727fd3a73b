// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QTimer>

#include "app/connectors/tracker/tracked_recording.h"
#include "app/gui/base/page.h"
#include "app/gui/base/problem.h"
#include "app/gui/trainee/device_opening.h"
#include "app/services/training/run_session.h"
#include "assessment/attempt/twist_count.h"
#include "sim/core/live_types.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace torsio::gui {

class StationDesk;

class AngleDial;
class Card;
class DetorsionPanel;
class LevelBar;
class LiveScene;
class TrackerPanel;
class TwistGuide;
class ValidityButton;

/// The run itself: big countdown, phase, rest with its allowance, gauges, quiet cues in practice only, hard
/// stop at the end, and the timer of the real arm. The clock and what is kept are RunSession's; while the
/// device gets ready, off the GUI thread, the clock stands.
class RunPage : public Page {
  Q_OBJECT

 public:
  /// `desk` outlives the page.
  RunPage(ShellContext& shell, StationDesk& desk, QWidget* parent = nullptr);
  ~RunPage() override;

  /// Begins a run of StationDesk::moduleId; with the argument "later" it waits for the next call.
  void enter(const QVariant& argument) override;
  [[nodiscard]] bool leave() override;
  [[nodiscard]] bool busy() const override;
  void retranslate() override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void applyTheme(const Theme& theme) override;

  [[nodiscard]] ShellContext& context() const noexcept { return shell(); }
  [[nodiscard]] StationDesk& desk() const noexcept { return desk_; }
  /// Null outside a run.
  [[nodiscard]] RunSession* runSession() noexcept { return runSession_ ? &*runSession_ : nullptr; }
  /// Whether the run waits for its device, its clock standing still.
  [[nodiscard]] bool fetchesDevice() const noexcept { return opening_.going(); }
  /// One round of the clock; tests call it themselves.
  void tick();

 private:
  StationDesk& desk_;

  QWidget* createPanel();
  QVBoxLayout* createHeading(QWidget* panel);
  void createTime(QWidget* panel);
  void createAngle(QWidget* panel);
  QLayout* createButtons(QWidget* side);
  /// Asks why training goes on while sheets of the real arm are missing; false: it does not.
  [[nodiscard]] bool askWhyUnscored(RunRequest& request);
  QWidget* createNotice();
  void begin();
  void start();
  void fetchDevice();
  void haveDevice();
  void cancelWaiting();
  void record();
  void follow(const std::vector<RunEvent>& events);
  void endRecording(TrialOutcome outcome);
  /// On the real arm: records what the tracker sees, once it sees the instrument.
  void track();
  void endTracked(TrialOutcome outcome);
  void finish();
  void askToStop();
  void withoutDevice(const Problem& why);
  void showState();
  bool showNotice();
  void showTold();
  void showLive(const LiveState& state);
  void showCount();
  /// Counts the twist that was let go just now.
  void judge();
  /// How the latest twist was let go, and what to do better.
  [[nodiscard]] QString verdict() const;
  [[nodiscard]] QString cue(const LiveState& state) const;
  /// Shows a first twist movement by movement, in practice of a twist.
  void guide();
  /// How much of the time to be held on target is over.
  double heldShare(const LiveState& state);

  const Theme* theme_;
  std::optional<RunSession> runSession_;
  QString lastTrial_;
  std::int64_t onTargetFrom_us_ = -1;  // of the present stay on target; -1: not there
  TwistCount twists_;                  // of the present recording
  std::int64_t onTarget_ = 0;          // of these
  bool held_ = false;                  // the present twist, as long as is wanted
  bool letGoHeld_ = false;             // the latest twist was
  bool focusDue_ = false;              // the keyboard belongs to the instrument
  bool turning_ = false;               // a hand turns what it holds
  bool waiting_ = false;               // for the scene and the device, before the clock starts
  std::optional<std::unique_ptr<HapticDevice>> device_;  // opened for the next recording; null: the pointer
  bool haptic_ = false;                                  // the run's device renders force
  std::unique_ptr<TrackedRecording> tracked_;            // of the real arm; null: none goes on
  bool inFile_ = false;                                  // a recording of this run waits for its database
  QTimer timer_;
  DeviceOpening opening_;

  QStackedWidget* stage_;
  LiveScene* scene_;
  QLabel* noticeTitle_ = nullptr;
  QLabel* noticeFigure_ = nullptr;
  QLabel* noticeText_ = nullptr;
  QPushButton* goOn_ = nullptr;
  TrackerPanel* tracker_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* mode_ = nullptr;
  Card* time_ = nullptr;
  QLabel* countdown_ = nullptr;
  QLabel* timeName_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* phase_ = nullptr;
  Card* angle_ = nullptr;
  AngleDial* dial_ = nullptr;
  DetorsionPanel* detorsion_ = nullptr;
  ValidityButton* validity_ = nullptr;
  Card* load_ = nullptr;
  LevelBar* torque_ = nullptr;
  LevelBar* force_ = nullptr;
  QLabel* goal_ = nullptr;
  QLabel* count_ = nullptr;
  QLabel* verdict_ = nullptr;
  QLabel* cue_ = nullptr;
  QLabel* warning_ = nullptr;
  TwistGuide* guide_ = nullptr;
  QPushButton* guideMe_ = nullptr;
  bool soundAtLimit_ = false;  // the centre's choice
  bool wasOver_ = false;       // the limit, a frame ago
  QPushButton* rest_ = nullptr;
  QPushButton* stop_ = nullptr;
};

}  // namespace torsio::gui
