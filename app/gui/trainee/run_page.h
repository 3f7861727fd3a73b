// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QTimer>

#include "app/connectors/tracker/tracked_recording.h"
#include "app/gui/base/page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/simulator/device_opening.h"
#include "app/gui/trainee/device_check_page.h"
#include "app/services/training/run_session.h"
#include "sim/core/live_types.h"

class QStackedWidget;

namespace torsio::gui {

class LiveScene;
class RunNotice;
class RunPanel;
class StationDesk;
class TwistGuide;

/// The run: connects the session's clock, device and recordings with the display, which consists of
/// LiveScene, RunPanel and RunNotice. The clock stands still while the device is opened off the GUI thread.
class RunPage : public Page {
  Q_OBJECT

 public:
  /// `desk` must outlive the page.
  RunPage(ShellContext& shell, StationDesk& desk, QWidget* parent = nullptr);
  ~RunPage() override;

  /// Starts a run of StationDesk::moduleId; argument "later": waits for the next call.
  void enter(const QVariant& argument) override;
  [[nodiscard]] bool leave() override;
  [[nodiscard]] bool busy() const override;
  void retranslate() override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void applyTheme(const Theme& theme) override;

  [[nodiscard]] ShellContext& context() const noexcept { return shell(); }
  [[nodiscard]] StationDesk& desk() const noexcept { return desk_; }
  /// Returns the session; null outside a run.
  [[nodiscard]] RunSession* runSession() noexcept { return runSession_ ? &*runSession_ : nullptr; }
  /// Returns whether the run is waiting for its device, with the clock stopped.
  [[nodiscard]] bool fetchesDevice() const noexcept { return opening_.going(); }
  /// One tick of the clock; tests call it directly.
  void tick();

 private:
  /// Asks why training continues while sheets of the real arm are missing; false: it does not.
  [[nodiscard]] bool askWhyUnscored(RunRequest& request);
  void begin();
  void start();
  void fetchDevice();
  void haveDevice();
  void goOn();
  void rest();
  void record();
  void follow(const std::vector<RunEvent>& events);
  void endRecording(TrialOutcome outcome);
  /// On the real arm: records the tracker once it sees the instrument.
  void track();
  void endTracked(TrialOutcome outcome);
  void finish();
  void forgetRun();
  void askToEnd();
  void withoutDevice(const Problem& why);
  void showState();
  void showLive(const LiveState& state);
  /// Guides a first twist movement by movement, in practice of a twist.
  void guide();

  StationDesk& desk_;
  std::optional<RunSession> runSession_;
  QString lastTrial_;
  QString lastTracked_;                                  ///< on the real arm
  bool focusDue_ = false;                                // focus is to return to the instrument
  bool waiting_ = false;                                 // for scene and device, before the clock starts
  std::optional<std::unique_ptr<HapticDevice>> device_;  // opened for the next recording; null: the pointer
  bool haptic_ = false;                                  // the run's device renders force
  std::unique_ptr<TrackedRecording> tracked_;            // of the real arm; null: not recording
  bool inFile_ = false;        // a recording of this run is waiting for the database
  bool soundAtLimit_ = false;  // the centre's setting
  QTimer timer_;
  DeviceOpening opening_;
  QStackedWidget* stage_;
  LiveScene* scene_;
  RunNotice* notice_;
  RunPanel* panel_;
  TwistGuide* guide_;
};

}  // namespace torsio::gui
