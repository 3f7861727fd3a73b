// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

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

/// Configuration of the window.
struct WindowSetup {
  std::filesystem::path assets;
  SceneLoader loader = loadSceneForView;
  TrialRecording recording;
  ThemeKind theme = ThemeKind::kLight;
  bool embedded = false;                     ///< part of another window: no menu bar, no global shortcuts
  HapticOpener openHaptic;                   ///< empty: mouse and keyboard only
  std::shared_ptr<InstrumentOutlet> outlet;  ///< output of the instrument to other programs; null: none
  bool remember = true;  ///< read and write geometry and choices (off for screenshots and tests)
};

/// The window of free practice: the scene, with exercise and readouts beside it. It only connects them: the
/// controller simulates, the scene view draws, the pointer controls steer, PracticeCommands has menus and
/// keys, PracticeFiles files and pictures.
class SimulatorWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit SimulatorWindow(const WindowSetup& setup);
  ~SimulatorWindow() override;

  [[nodiscard]] SimulationController& controller() noexcept { return *controller_; }
  [[nodiscard]] const std::filesystem::path& assets() const noexcept { return setup_.assets; }
  void setThemeKind(ThemeKind kind);
  /// Sets the colours, but not the application's palette and style sheet, which belong to the enclosing
  /// window.
  void applyColours(ThemeKind kind);
  /// Sets all texts in the present language.
  void retranslate();
  /// Stops frames and the exercise while hidden.
  void pause();
  void resume();
  [[nodiscard]] ThemeKind themeKind() const noexcept { return themeKind_; }
  /// Unfolds the panel of the model's parts and scrolls to it.
  void unfoldEngineerPanel();
  /// One tick of the frame timer; tests call it directly.
  void frame(double elapsed_s);

 Q_SIGNALS:
  /// The displayed organ is to be compared with other models.
  void comparisonWanted(const torsio::SceneRequest& organ);
  /// The user wants to import an organ. Only if embedded.
  void organWanted();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void createLayout();
  void createStatusBar();
  void connectCommands();
  void connectController();
  void connectPanels();
  /// Reloads the present scene with a change of its request.
  void reload(const std::function<void(SceneRequest&)>& change);
  void look(ViewPreset preset);
  void toggleRecording();
  void chooseKeys();
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
