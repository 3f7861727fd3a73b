// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include <QImage>
#include <QObject>

#include "app/gui/simulator/replay_bar.h"
#include "app/gui/simulator/simulation_controller.h"

namespace torsio::gui {

class SceneView;
class ShownTool;

/// Opens and saves organs, instruments, recordings and pictures of free practice. Each command first asks for
/// a file, and shows errors in a message box.
class PracticeFiles : public QObject {
  Q_OBJECT

 public:
  /// All arguments must outlive it.
  PracticeFiles(SimulationController& controller, SceneView& view, ShownTool& tool, QWidget& window);

  void openOrgan();
  void openInstrument();
  void openReplay(const TrialRecording& recording, const std::filesystem::path& assets);
  void savePicture();
  void saveFilmStrip();
  void tellProblem(const QString& happened, const QString& remedy, const QString& details);

 private:
  /// Shows an Error that `act` throws.
  template <typename Act>
  void attempt(const Act& act);
  [[nodiscard]] std::vector<StripFrame> replayFrames();
  void save(const QString& title, const QString& name, const std::function<QImage()>& draw);

  SimulationController& controller_;
  SceneView& view_;
  ShownTool& tool_;
  QWidget& window_;
};

}  // namespace torsio::gui
