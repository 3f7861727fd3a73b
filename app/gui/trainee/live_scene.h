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

/// Organ and instrument with everything that moves them, without panels: what briefing and run show. Draws
/// only while it is visible. Until there is a picture of the organ a sentence says that it comes.
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
  /// Whether the organ is to be seen; on a display that draws nothing as soon as it is loaded.
  [[nodiscard]] bool pictured() const;

 Q_SIGNALS:
  /// After each frame, so that the gauges and the picture change together.
  void shown(const torsio::LiveState& state);
  /// The jaw opened because the keyboard went elsewhere.
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
  std::int64_t framesBefore_ = 0;  // drawn before the organ came
  QTimer timer_;
  QElapsedTimer since_;
};

}  // namespace torsio::gui
