// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "app/gui/simulator/shown_tool.h"
#include "app/gui/simulator/simulation_controller.h"

namespace torsio::gui {

class PointerControls;
class SceneView;
struct Theme;

/// Organ and instrument with everything that moves them, without panels: what briefing and run show. Draws
/// only while it is visible.
class LiveScene : public QWidget {
  Q_OBJECT

 public:
  LiveScene(SceneLoader loader, std::filesystem::path assets, QWidget* parent = nullptr);
  ~LiveScene() override;

  [[nodiscard]] SimulationController& controller() noexcept { return *controller_; }
  [[nodiscard]] SceneView& view() noexcept { return *view_; }
  void setTheme(const Theme& theme);
  /// One round of the frame timer; tests call it themselves.
  void frame(double elapsed_s);

 Q_SIGNALS:
  /// After each frame, so that the gauges and the picture change together.
  void shown(const torsio::LiveState& state);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void tell();

  std::unique_ptr<SimulationController> controller_;
  SceneView* view_;
  PointerControls* pointer_;
  ShownTool tool_;
  std::optional<LiveState> untold_;  // waits for its frame
  QTimer timer_;
  QElapsedTimer since_;
};

}  // namespace torsio::gui
