// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/practice/simulator_window.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QScrollArea>
#include <QSettings>
#include <QStatusBar>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/practice/engineer_panel.h"
#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/simulator/detorsion_panel.h"
#include "app/gui/simulator/exercise_panel.h"
#include "app/gui/simulator/pointer_controls.h"
#include "app/gui/simulator/readout_panel.h"
#include "app/gui/simulator/replay_bar.h"
#include "app/gui/simulator/shown_tool.h"
#include "app/gui/simulator/validity_button.h"

namespace torsio::gui {

namespace {

constexpr int kFrame_ms = 16;
constexpr double kReadoutEvery_s = 0.08;  // figures that change faster cannot be read
constexpr double kRateOver_s = 1.0;
constexpr double kNoticeFor_s = 6.0;
constexpr double kLongestFrame_s = 0.25;  // after a pause nothing jumps
constexpr int kPanelWidth = 380;          // so that the longest name of an organ is read whole

}  // namespace

SimulatorWindow::SimulatorWindow(const WindowSetup& setup) : setup_(setup), themeKind_(setup.theme) {
  setWindowTitle(QStringLiteral("Torsio"));
  resize(1280, 800);
  controller_ = std::make_unique<SimulationController>(setup_.loader, setup_.recording);
  createLayout();
  createActions();
  createMenus();
  createToolBar();
  connectController();
  exercise_->setOrgans(setup_.assets);
  view_->setInstrument(loadInstrument(setup_.assets, "grasper"));
  if (setup_.embedded) {
    applyColours(themeKind_);
  } else {
    setThemeKind(themeKind_);
  }
  retranslate();
  if (setup_.remember) {
    restoreChoices();
  }
  showMode();
  frameTimer_.setTimerType(Qt::PreciseTimer);
  connect(&frameTimer_, &QTimer::timeout, this, [this] {
    const double elapsed_s = static_cast<double>(sinceFrame_.nsecsElapsed()) * 1e-9;
    sinceFrame_.restart();
    frame(std::min(elapsed_s, kLongestFrame_s));
  });
  sinceFrame_.start();
  sinceRate_.start();
  frameTimer_.start(kFrame_ms);
}

SimulatorWindow::~SimulatorWindow() {
  frameTimer_.stop();
}

void SimulatorWindow::createLayout() {
  auto* centre = new QWidget(this);
  auto* row = new QHBoxLayout(centre);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);

  auto* left = new QVBoxLayout;
  left->setSpacing(0);
  view_ = new SceneView(centre);
  view_->setObjectName(QStringLiteral("view"));
  pointer_ = new PointerControls(*view_);
  pointer_->setKeys(PointerKeys::stored());
  tool_ = std::make_unique<ShownTool>(*controller_, *pointer_, *view_);
  replayBar_ = new ReplayBar(centre);
  replayBar_->hide();
  left->addWidget(view_, 1);
  left->addWidget(replayBar_);
  row->addLayout(left, 1);

  auto* panel = new QWidget;
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(kSpace + 4, kSpace + 4, kSpace + 4, kSpace + 4);
  column->setSpacing(kSpace + 2);
  exercise_ = new ExercisePanel(panel);
  readout_ = new ReadoutPanel(panel);
  detorsion_ = new DetorsionPanel(panel);
  detorsion_->steer(*controller_);
  column->addWidget(exercise_);
  column->addWidget(detorsion_);
  column->addWidget(readout_);
  engineer_ = new EngineerPanel(panel);
  column->addWidget(engineer_);
  column->addStretch(1);
  side_ = new QScrollArea(centre);
  side_->setWidgetResizable(true);
  side_->setFixedWidth(kPanelWidth);
  side_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  side_->setFocusPolicy(Qt::NoFocus);
  side_->setWidget(panel);
  row->addWidget(side_);
  setCentralWidget(centre);

  hint_ = new QLabel(this);
  recordingTime_ = new QLabel(this);
  recordingTime_->hide();
  source_ = new QLabel(this);
  statusBar()->addWidget(hint_, 1);
  statusBar()->addPermanentWidget(recordingTime_);
  device_ = new QLabel(this);
  device_->setObjectName(QStringLiteral("deviceName"));
  statusBar()->addPermanentWidget(device_);
  statusBar()->addPermanentWidget(source_);
  validity_ = new ValidityButton(this);
  statusBar()->addPermanentWidget(validity_);
  statusBar()->setSizeGripEnabled(false);
}

void SimulatorWindow::connectController() {
  SimulationController* c = controller_.get();
  connect(c, &SimulationController::sceneChanged, this, &SimulatorWindow::showScene);
  connect(c, &SimulationController::modeChanged, this, &SimulatorWindow::showMode);
  connect(c, &SimulationController::failed, this, &SimulatorWindow::showProblem);
  connect(c, &SimulationController::hapticModelChanged, this, &SimulatorWindow::showDevice);
  connect(c, &SimulationController::noticed, this, [this](const QString& sentence) {
    notice_ = sentence;
    noticeLeft_s_ = kNoticeFor_s;
  });
  connect(c, &SimulationController::loadingChanged, this, [this](bool loading) {
    if (loading) {
      notice_ = tr("Loading\u2026");
      noticeLeft_s_ = 1e9;
    } else {
      noticeLeft_s_ = 0.0;
    }
    exercise_->setChangeable(!loading);
    engineer_->setChangeable(!loading);
  });
  connect(pointer_, &PointerControls::changed, this, [this] { controller_->steer(pointer_->input()); });

  connect(exercise_, &ExercisePanel::organChosen, this, [this](const QString& id) {
    SceneRequest request;
    request.assets = setup_.assets;
    request.id = id.toStdString();
    request.formulation = controller_->request().formulation;
    request.tissue = controller_->request().tissue;
    controller_->load(request);
  });
  connect(exercise_, &ExercisePanel::patternChosen, this, [this](const QString& id) {
    SceneRequest request = controller_->request();
    request.pattern = id.toStdString();
    controller_->load(request);
  });
  connect(exercise_, &ExercisePanel::formulationChosen, this, [this](Formulation formulation) {
    SceneRequest request = controller_->request();
    request.formulation = formulation;
    request.tissue = TissueModel::kTwist;
    request.model = choiceFor(request.model, formulation);
    controller_->load(request);
  });
  connect(exercise_, &ExercisePanel::tissueChosen, this, [this](TissueModel tissue) {
    SceneRequest request = controller_->request();
    request.formulation = Formulation::kSaintVenant;
    request.tissue = tissue;
    request.model = {};
    controller_->load(request);
  });
  connect(engineer_, &EngineerPanel::chosen, this, [this](const ModelChoice& choice) {
    SceneRequest request = controller_->request();
    request.model = choice;
    controller_->load(request);
  });
  connect(exercise_, &ExercisePanel::targetChosen, this, [this](double target_rad) {
    controller_->setTarget(target_rad);
    showGhost();
  });

  connect(replayBar_, &ReplayBar::playToggled, this, [this] {
    if (TrialPlayback* playback = controller_->playback()) {
      playback->setPlaying(!playback->playing());
    }
  });
  connect(replayBar_, &ReplayBar::soughtTo, this, [this](qint64 position_us) {
    if (TrialPlayback* playback = controller_->playback()) {
      playback->seek_us(position_us);
    }
  });
  connect(replayBar_, &ReplayBar::speedChosen, this, [this](double speed) {
    if (TrialPlayback* playback = controller_->playback()) {
      playback->setSpeed(speed);
    }
  });
  connect(replayBar_, &ReplayBar::closed, c, &SimulationController::closeReplay);
}

void SimulatorWindow::setThemeKind(ThemeKind kind) {
  applyTheme(*qApp, theme(kind));
  applyColours(kind);
}

void SimulatorWindow::applyColours(ThemeKind kind) {
  themeKind_ = kind;
  const Theme& colours = theme(kind);
  view_->setTheme(colours);
  readout_->setTheme(colours);
  replayBar_->setTheme(colours);
  recordingTime_->setStyleSheet(QStringLiteral("color: %1; font-weight: 600;").arg(colours.recording.name()));
  applyIcons();
  if (actions_.dark != nullptr) {
    actions_.dark->setChecked(kind == ThemeKind::kDark);
  }
}

void SimulatorWindow::retranslate() {
  nameActions();
  exercise_->retranslate();
  engineer_->retranslate();
  readout_->retranslate();
  detorsion_->retranslate();
  validity_->retranslate();
  replayBar_->retranslate();
  hint_->setAccessibleName(tr("Hint"));
  recordingTime_->setAccessibleName(tr("Recording"));
  source_->setAccessibleName(tr("Source of the organ"));
  device_->setAccessibleName(tr("Device"));
  showDevice();
  if (controller_->scene() != nullptr) {
    showTitle();
  }
  noticeLeft_s_ = 0.0;
  hint_->clear();  // the next frame says it again
  showMode();
}

void SimulatorWindow::pause() {
  frameTimer_.stop();
  controller_->releaseTissue();
  controller_->useHapticDevice({});  // a run may need it
}

void SimulatorWindow::resume() {
  if (setup_.openHaptic) {
    controller_->useHapticDevice(setup_.openHaptic);
  }
  sinceFrame_.restart();
  frameTimer_.start(kFrame_ms);
}

void SimulatorWindow::unfoldEngineerPanel() {
  engineer_->setFolded(false);
  QApplication::sendPostedEvents();  // the panel has its height
  side_->ensureWidgetVisible(engineer_);
}

void SimulatorWindow::showDevice() {
  const QString& model = controller_->hapticModel();
  device_->setText(model.isEmpty() ? tr("Mouse and keyboard") : model);
  device_->setVisible(static_cast<bool>(setup_.openHaptic));
}

void SimulatorWindow::frame(double elapsed_s) {
  pointer_->advance(elapsed_s);
  controller_->advance(elapsed_s);
  const LiveState state = controller_->state();
  if (controller_->scene() != nullptr) {
    view_->setTissue(tool_->show(state));
    if (setup_.outlet != nullptr && !controller_->frozen()) {
      setup_.outlet->show(state);
    }
  }
  readoutDue_s_ -= elapsed_s;
  noticeLeft_s_ -= elapsed_s;
  if (readoutDue_s_ > 0.0) {
    return;
  }
  readoutDue_s_ = kReadoutEvery_s;
  measureRate();
  readout_->show(state, controller_->frozen() ? 0.0 : framesPerSecond_);  // a picture has no rate
  detorsion_->show(state);
  exercise_->showBeside(controller_->asyncRate_per_s(), (state.limits & kForceModelLate) != 0);
  showHint(state);
  replayBar_->show(controller_->playback());
}

void SimulatorWindow::measureRate() {
  const double span_s = static_cast<double>(sinceRate_.elapsed()) * 1e-3;
  if (span_s < kRateOver_s) {
    return;
  }
  framesPerSecond_ = static_cast<double>(view_->framesDrawn() - framesAtRate_) / span_s;
  framesAtRate_ = view_->framesDrawn();
  sinceRate_.restart();
}

void SimulatorWindow::showScene() {
  const Scene& scene = *controller_->scene();
  view_->setScene(controller_->viewScene());
  detorsion_->setScene(&scene);
  validity_->setScene(&scene);
  showGhost();
  actions_.markers->setEnabled(!controller_->viewScene().markers.empty());
  exercise_->showScene(scene, controller_->target_rad(), controller_->request().organFile.has_value());
  engineer_->showModel(scene.model.options(), scene.model.material(), scene.modelChoice,
                       controller_->request().model.any());
  readout_->setLimits({.tolerance_rad = scene.pattern.tolerance_rad,
                       .force_N = scene.pattern.forceLimit_N,
                       .torque_Nm = scene.pattern.torqueLimit_Nm});
  showTitle();
  pointer_->park(controller_->parkingPoint_m());
  view_->setFocus();
}

void SimulatorWindow::showGhost() {
  const Scene* scene = controller_->scene();
  if (scene == nullptr || !actions_.ghost->isChecked()) {
    view_->setGhost(std::nullopt);
    return;
  }
  view_->setGhost(scene->stateAt(controller_->target_rad()));
}

void SimulatorWindow::showTitle() {
  const Scene& scene = *controller_->scene();
  const QString title = toQString(Text(scene.title));
  setWindowTitle(tr("%1 \u2013 Torsio").arg(title));
  source_->setText(title);
  source_->setToolTip(toQString(scene.provenance));
}

void SimulatorWindow::showMode() {
  using Mode = SimulationController::Mode;
  const Mode mode = controller_->mode();
  const bool recording = mode == Mode::kRecording;
  const bool practice = mode == Mode::kPractice;
  actions_.record->setText(recording ? tr("Stop") : tr("Record"));
  actions_.record->setEnabled(recording || (practice && !controller_->request().model.any()));
  actions_.record->setVisible(setup_.recording.open != nullptr);
  actions_.replay->setVisible(setup_.recording.open != nullptr);
  actions_.replay->setEnabled(!recording && setup_.recording.list != nullptr);
  actions_.release->setEnabled(recording || practice);
  actions_.restart->setEnabled(practice);
  actions_.open->setEnabled(!recording);
  actions_.bring->setEnabled(!recording);
  actions_.compare->setEnabled(practice && controller_->scene() != nullptr);
  recordingTime_->setVisible(recording);
  replayBar_->setVisible(mode == Mode::kReplay);
  exercise_->setChangeable(practice && !controller_->loading());
  detorsion_->setUsable(practice || recording);
  engineer_->setChangeable(practice && !controller_->loading());
  applyIcons();
}

void SimulatorWindow::look(ViewPreset preset) {
  view_->camera().look(preset);
  view_->applyCamera();
}

void SimulatorWindow::lookWhole() {
  view_->frameOrgan();
}

void SimulatorWindow::toggleRecording() {
  if (controller_->mode() == SimulationController::Mode::kRecording) {
    controller_->stopRecording();
  } else {
    pointer_->park(controller_->parkingPoint_m());
    controller_->startRecording();
  }
}

void SimulatorWindow::restoreChoices() {
  const QSettings settings;
  restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
  actions_.lattice->setChecked(settings.value(QStringLiteral("view/lattice"), false).toBool());
}

void SimulatorWindow::saveChoices() const {
  QSettings settings;
  settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
  settings.setValue(QStringLiteral("view/lattice"), actions_.lattice->isChecked());
  settings.setValue(QStringLiteral("view/dark"), themeKind_ == ThemeKind::kDark);
}

void SimulatorWindow::closeEvent(QCloseEvent* event) {
  frameTimer_.stop();
  controller_->shutDown();
  if (setup_.remember) {
    saveChoices();
  }
  event->accept();
}

}  // namespace torsio::gui
