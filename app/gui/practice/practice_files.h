// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include <QImage>
#include <QObject>

#include "app/gui/simulator/film_strip.h"
#include "app/gui/simulator/simulation_controller.h"

namespace torsio::gui {

class SceneView;
class ShownTool;

/// What free practice opens and saves: organs, instruments, recordings, pictures. Each choice asks first, and
/// says in a box of its own what went wrong.
class PracticeFiles : public QObject {
  Q_OBJECT

 public:
  /// All outlive it.
  PracticeFiles(SimulationController& controller, SceneView& view, ShownTool& tool, QWidget& window);

  void openOrgan();
  void openInstrument();
  void openReplay(const TrialRecording& recording, const std::filesystem::path& assets);
  void savePicture();
  void saveFilmStrip();
  void tellProblem(const QString& happened, const QString& remedy, const QString& details);

 private:
  /// Tells an Error that `act` throws.
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
