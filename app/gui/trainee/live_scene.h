// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "app/gui/simulator/shown_tool.h"
#include "app/gui/simulator/simulation_controller.h"

class QLabel;

namespace torsio::gui {

class PointerControls;
class SceneView;
struct Theme;

/// Organ and instrument with their simulation and controls, without panels; used by briefing and run. Draws
/// only while visible. Shows a sentence until there is a picture of the organ.
class LiveScene : public QWidget {
  Q_OBJECT

 public:
  LiveScene(SceneLoader loader, std::filesystem::path assets, QWidget* parent = nullptr);
  ~LiveScene() override;

  [[nodiscard]] SimulationController& controller() noexcept { return *controller_; }
  [[nodiscard]] SceneView& view() noexcept { return *view_; }
  void setTheme(const Theme& theme);
  /// One tick of the frame timer; tests call it directly.
  void frame(double elapsed_s);
  /// Returns whether the organ is visible; on a display that draws nothing, as soon as it is loaded.
  [[nodiscard]] bool pictured() const;

 Q_SIGNALS:
  /// Emitted after each frame, so that gauges and picture change together.
  void shown(const torsio::LiveState& state);
  /// The jaw opened because of a loss of focus.
  void gripLost();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void tell();
  void sayWaiting();

  std::unique_ptr<SimulationController> controller_;
  SceneView* view_;
  PointerControls* pointer_;
  ShownTool tool_;
  std::optional<LiveState> untold_;  // waits for its frame
  QLabel* waiting_;
  std::int64_t framesBefore_ = 0;  // number drawn before the organ was loaded
  QTimer timer_;
  QElapsedTimer since_;
};

}  // namespace torsio::gui
