// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/live_scene.h"

#include <algorithm>
#include <utility>

#include <QEvent>
#include <QLabel>
#include <QVBoxLayout>

#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/simulator/pointer_controls.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr int kFrame_ms = 16;
constexpr double kLongestFrame_s = 0.25;

}  // namespace

LiveScene::LiveScene(SceneLoader loader, std::filesystem::path assets, QWidget* parent)
    : QWidget(parent),
      controller_(std::make_unique<SimulationController>(std::move(loader), TrialRecording{})),
      view_(new SceneView(this)),
      pointer_(new PointerControls(*view_)),
      tool_(*controller_, *pointer_, *view_),
      waiting_(new QLabel(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(view_);
  waiting_->setObjectName(QStringLiteral("waitingForOrgan"));
  waiting_->setProperty("quiet", true);
  waiting_->setAlignment(Qt::AlignCenter);
  waiting_->setAutoFillBackground(true);
  sayWaiting();
  pointer_->setKeys(PointerKeys::stored());
  view_->setInstrument(loadInstrument(assets, "grasper"));
  connect(pointer_, &PointerControls::gripLost, this, &LiveScene::gripLost);
  connect(pointer_, &PointerControls::changed, this, [this] { controller_->steer(pointer_->input()); });
  connect(controller_.get(), &SimulationController::sceneChanged, this, [this] {
    if (controller_->scene() == nullptr) {
      return;
    }
    framesBefore_ = view_->framesDrawn();
    view_->setScene(controller_->viewScene());
    pointer_->park(controller_->parkingPoint_m());
  });
  connect(view_, &SceneView::frameDrawn, this, &LiveScene::tell);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, [this] {
    const double elapsed_s = static_cast<double>(since_.nsecsElapsed()) * 1e-9;
    since_.restart();
    frame(std::min(elapsed_s, kLongestFrame_s));
  });
}

LiveScene::~LiveScene() {
  timer_.stop();
}

void LiveScene::setTheme(const Theme& theme) {
  view_->setTheme(theme);
}

bool LiveScene::pictured() const {
  return controller_->scene() != nullptr && (!view_->draws() || view_->framesDrawn() > framesBefore_);
}

void LiveScene::sayWaiting() {
  waiting_->setText(tr("Getting the organ ready\u2026"));
}

void LiveScene::frame(double elapsed_s) {
  pointer_->advance(elapsed_s);
  controller_->advance(elapsed_s);
  waiting_->setVisible(!pictured());
  if (controller_->scene() == nullptr) {
    return;
  }
  const LiveState state = controller_->state();
  view_->setTissue(tool_.show(state));  // with dents and the force on the tool
  tell();                               // of the previous tick, in which nothing moved and nothing was drawn
  untold_ = state;
  if (!view_->draws()) {
    tell();
  }
}

void LiveScene::tell() {
  if (const std::optional<LiveState> state = std::exchange(untold_, std::nullopt)) {
    Q_EMIT shown(*state);
  }
}

void LiveScene::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  since_.start();
  timer_.start(kFrame_ms);
}

void LiveScene::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  waiting_->setGeometry(rect());
}

void LiveScene::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) {
    sayWaiting();
  }
}

void LiveScene::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  timer_.stop();
}

}  // namespace torsio::gui
