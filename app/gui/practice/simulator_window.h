// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>

#include "app/connectors/tracker/instrument_outlet.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/simulator/simulation_controller.h"
#include "app/gui/widgets/theme.h"

class QLabel;
class QScrollArea;

namespace torsio::gui {

class DetorsionPanel;
class EngineerPanel;
class ExercisePanel;
class HintLine;
class PointerControls;
class PracticeCommands;
class PracticeFiles;
class ReadoutPanel;
class ReplayBar;
class ShownTool;
class ValidityButton;

/// What the window needs from outside.
struct WindowSetup {
  std::filesystem::path assets;
  SceneLoader loader = loadSceneForView;
  TrialRecording recording;
  ThemeKind theme = ThemeKind::kLight;
  bool embedded = false;    ///< a part of another window: no menu bar, no program-wide commands
  HapticOpener openHaptic;  ///< empty: mouse and keyboard
  std::shared_ptr<InstrumentOutlet> outlet;  ///< where others watch the instrument; null: nowhere
  bool remember = true;  ///< read and write geometry and choices (off for pictures and tests)
};

/// The window of free practice: the scene, and exercise and readouts beside it. It only connects them:
/// simulation is the controller's, drawing the scene view's, steering the pointer controls', menus and keys
/// the commands', files and pictures PracticeFiles'.
class SimulatorWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit SimulatorWindow(const WindowSetup& setup);
  ~SimulatorWindow() override;

  [[nodiscard]] SimulationController& controller() noexcept { return *controller_; }
  [[nodiscard]] const std::filesystem::path& assets() const noexcept { return setup_.assets; }
  void setThemeKind(ThemeKind kind);
  /// Sets the colours without the application's palette and style sheet, which another window has set
  /// already.
  void applyColours(ThemeKind kind);
  /// All texts anew, in the present language.
  void retranslate();
  /// While nobody looks: no frames, and the exercise stands still.
  void pause();
  void resume();
  [[nodiscard]] ThemeKind themeKind() const noexcept { return themeKind_; }
  /// How mouse and keys move the instrument and the camera: what and how.
  [[nodiscard]] static std::vector<std::pair<QString, QString>> pointerKeys();
  /// Shows an instrument of a centre's own (NAME.json) until the window closes; what is felt stays that of
  /// the exercise. Throws as loadInstrument().
  void showInstrument(const std::filesystem::path& file);
  /// Opens the panel of the model's parts and scrolls to it.
  void unfoldEngineerPanel();
  /// One round of the frame timer; tests call it themselves.
  void frame(double elapsed_s);

 Q_SIGNALS:
  /// The organ that is shown is to be compared by other models too.
  void comparisonWanted(const torsio::SceneRequest& organ);
  /// Somebody wants to bring an organ of their own. Only of a window that is a part of another.
  void organWanted();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void createLayout();
  void createStatusBar();
  void connectCommands();
  void connectController();
  void connectPanels();
  /// Loads the present scene with a change.
  void reload(const std::function<void(SceneRequest&)>& change);
  void look(ViewPreset preset);
  void toggleRecording();
  void chooseKeys();
  void showHelp();
  void showAbout();
  void showScene();
  void showGhost();
  void showTitle();
  void showMode();
  void showDevice();
  void measureRate();
  void restoreChoices();
  void saveChoices() const;

  WindowSetup setup_;
  ThemeKind themeKind_;
  std::unique_ptr<SimulationController> controller_;
  SceneView* view_ = nullptr;
  PointerControls* pointer_ = nullptr;
  std::unique_ptr<ShownTool> tool_;
  PracticeCommands* commands_ = nullptr;
  PracticeFiles* files_ = nullptr;
  ExercisePanel* exercise_ = nullptr;
  ReadoutPanel* readout_ = nullptr;
  DetorsionPanel* detorsion_ = nullptr;
  ValidityButton* validity_ = nullptr;
  EngineerPanel* engineer_ = nullptr;
  QScrollArea* side_ = nullptr;
  ReplayBar* replayBar_ = nullptr;
  HintLine* hint_ = nullptr;
  QLabel* recordingTime_ = nullptr;
  QLabel* source_ = nullptr;
  QLabel* device_ = nullptr;
  QTimer frameTimer_;
  QElapsedTimer sinceFrame_;
  QElapsedTimer sinceRate_;
  std::int64_t framesAtRate_ = 0;
  double framesPerSecond_ = 0.0;
  double readoutDue_s_ = 0.0;
};

}  // namespace torsio::gui
