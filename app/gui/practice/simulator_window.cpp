// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/practice/simulator_window.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QScrollArea>
#include <QSettings>
#include <QStatusBar>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/practice/engineer_panel.h"
#include "app/gui/practice/hint_line.h"
#include "app/gui/practice/practice_commands.h"
#include "app/gui/practice/practice_files.h"
#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/simulator/detorsion_panel.h"
#include "app/gui/simulator/exercise_panel.h"
#include "app/gui/simulator/pointer_controls.h"
#include "app/gui/simulator/readout_panel.h"
#include "app/gui/simulator/replay_bar.h"
#include "app/gui/simulator/shown_tool.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/base/build_info.h"

namespace torsio::gui {

namespace {

constexpr int kFrame_ms = 16;
constexpr double kReadoutEvery_s = 0.08;  // faster figures are unreadable
constexpr double kRateOver_s = 1.0;
constexpr double kLongestFrame_s = 0.25;  // no jump after a pause
constexpr int kPanelWidth = 380;          // fits the longest name of an organ

}  // namespace

SimulatorWindow::SimulatorWindow(const WindowSetup& setup) : setup_(setup), themeKind_(setup.theme) {
  setWindowTitle(QStringLiteral("Torsio"));
  resize(1280, 800);
  controller_ = std::make_unique<SimulationController>(setup_.loader, setup_.recording);
  createLayout();
  createStatusBar();
  commands_ = new PracticeCommands(*this, setup_.embedded);
  files_ = new PracticeFiles(*controller_, *view_, *tool_, *this);
  connectCommands();
  connectController();
  connectPanels();
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
  auto* row = bareLayout<QHBoxLayout>(centre, 0);

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
}

void SimulatorWindow::createStatusBar() {
  hint_ = new HintLine(*controller_, *detorsion_, this);
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

void SimulatorWindow::connectCommands() {
  const auto on = [this](Command command, auto act) {
    connect(&commands_->action(command), &QAction::triggered, this, act);
  };
  on(Command::kOpen, [this] { files_->openOrgan(); });
  on(Command::kBring, [this] { Q_EMIT organWanted(); });
  on(Command::kInstrument, [this] { files_->openInstrument(); });
  on(Command::kPicture, [this] { files_->savePicture(); });
  on(Command::kStrip, [this] { files_->saveFilmStrip(); });
  on(Command::kRecord, [this] { toggleRecording(); });
  on(Command::kReplay, [this] { files_->openReplay(setup_.recording, setup_.assets); });
  on(Command::kCompare, [this] { Q_EMIT comparisonWanted(controller_->request()); });
  on(Command::kRelease, [this] { controller_->releaseTissue(); });
  on(Command::kRestart, [this] { controller_->load(controller_->request()); });
  on(Command::kFront, [this] { look(ViewPreset::kFront); });
  on(Command::kSide, [this] { look(ViewPreset::kSide); });
  on(Command::kTop, [this] { look(ViewPreset::kTop); });
  on(Command::kWhole, [this] { view_->frameOrgan(); });
  on(Command::kKeys, [this] { chooseKeys(); });
  on(Command::kHelp, [this] { showPointerKeys(this); });
  on(Command::kFull, [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  on(Command::kQuit, [this] { close(); });
  on(Command::kAbout, [this] { showAbout(); });
  const auto toggled = [this](Command command, auto act) {
    connect(&commands_->action(command), &QAction::toggled, this, act);
  };
  toggled(Command::kLattice, [this](bool shown) { view_->setLattice(shown); });
  toggled(Command::kWireframe, [this](bool shown) { view_->setWireframe(shown); });
  toggled(Command::kShear, [this](bool shown) { view_->setShearVisible(shown); });
  toggled(Command::kMarkers, [this](bool shown) { view_->setMarkersVisible(shown); });
  toggled(Command::kGhost, [this] { showGhost(); });
  if (!setup_.embedded) {
    toggled(Command::kDark,
            [this](bool shown) { setThemeKind(shown ? ThemeKind::kDark : ThemeKind::kLight); });
  }
  connect(commands_, &PracticeCommands::qualityChosen, view_, &SceneView::setQuality);
}

void SimulatorWindow::connectController() {
  SimulationController* c = controller_.get();
  connect(c, &SimulationController::sceneChanged, this, &SimulatorWindow::showScene);
  connect(c, &SimulationController::modeChanged, this, &SimulatorWindow::showMode);
  connect(c, &SimulationController::hapticModelChanged, this, &SimulatorWindow::showDevice);
  connect(c, &SimulationController::loadingChanged, this, [this](bool loading) {
    if (loading) {
      hint_->notice(tr("Loading\u2026"), true);
    } else {
      hint_->endNotice();
    }
    exercise_->setChangeable(!loading);
    engineer_->setChangeable(!loading);
  });
  connect(pointer_, &PointerControls::changed, this, [this] { controller_->steer(pointer_->input()); });
}

void SimulatorWindow::reload(const std::function<void(SceneRequest&)>& change) {
  SceneRequest request = controller_->request();
  change(request);
  controller_->load(request);
}

void SimulatorWindow::connectPanels() {
  connect(exercise_, &ExercisePanel::organChosen, this, [this](const QString& id) {
    SceneRequest request;
    request.assets = setup_.assets;
    request.id = id.toStdString();
    request.formulation = controller_->request().formulation;
    request.tissue = controller_->request().tissue;
    controller_->load(request);
  });
  connect(exercise_, &ExercisePanel::patternChosen, this, [this](const QString& id) {
    reload([&](SceneRequest& request) { request.pattern = id.toStdString(); });
  });
  connect(exercise_, &ExercisePanel::formulationChosen, this, [this](Formulation formulation) {
    reload([&](SceneRequest& request) {
      request.formulation = formulation;
      request.tissue = TissueModel::kTwist;
      request.model = choiceFor(request.model, formulation);
    });
  });
  connect(exercise_, &ExercisePanel::tissueChosen, this, [this](TissueModel tissue) {
    reload([&](SceneRequest& request) {
      request.formulation = Formulation::kSaintVenant;
      request.tissue = tissue;
      request.model = {};
    });
  });
  connect(engineer_, &EngineerPanel::chosen, this, [this](const ModelChoice& choice) {
    reload([&](SceneRequest& request) { request.model = choice; });
  });
  connect(exercise_, &ExercisePanel::targetChosen, this, [this](double target_rad) {
    controller_->setTarget(target_rad);
    showGhost();
  });

  const auto onPlayback = [this](auto signal, auto act) {
    connect(replayBar_, signal, this, [this, act](auto... value) {
      if (TrialPlayback* playback = controller_->playback()) {
        act(*playback, value...);
      }
    });
  };
  onPlayback(&ReplayBar::playToggled, [](TrialPlayback& one) { one.setPlaying(!one.playing()); });
  onPlayback(&ReplayBar::soughtTo, [](TrialPlayback& one, qint64 position_us) { one.seek_us(position_us); });
  onPlayback(&ReplayBar::speedChosen, [](TrialPlayback& one, double speed) { one.setSpeed(speed); });
  connect(replayBar_, &ReplayBar::closed, controller_.get(), &SimulationController::closeReplay);
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
  commands_->applyIcons(colours);
  commands_->action(Command::kDark).setChecked(kind == ThemeKind::kDark);
}

void SimulatorWindow::retranslate() {
  commands_->retranslate();
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
  hint_->endNotice();
  hint_->clear();  // set again in the next frame
  showMode();
}

void SimulatorWindow::pause() {
  frameTimer_.stop();
  controller_->releaseTissue();
  controller_->useHapticDevice({});  // a run may need the device
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
  QApplication::sendPostedEvents();  // applies the panel's height
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
  hint_->pass(elapsed_s);
  if (readoutDue_s_ > 0.0) {
    return;
  }
  readoutDue_s_ = kReadoutEvery_s;
  measureRate();
  readout_->show(state, controller_->frozen() ? 0.0 : framesPerSecond_);  // a screenshot has no frame rate
  detorsion_->show(state);
  exercise_->showBeside(controller_->asyncRate_per_s(), (state.limits & kForceModelLate) != 0);
  hint_->show(state);
  if (controller_->mode() == SimulationController::Mode::kRecording) {
    recordingTime_->setText(
        tr("\u25cf Recording  %1").arg(clockTime(std::llround(1e6 * controller_->recorded_s()))));
  }
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
  commands_->action(Command::kMarkers).setEnabled(!controller_->viewScene().markers.empty());
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
  if (scene == nullptr || !commands_->action(Command::kGhost).isChecked()) {
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
  const auto action = [this](Command command) -> QAction& { return commands_->action(command); };
  commands_->showRecording(recording);
  action(Command::kRecord).setEnabled(recording || (practice && !controller_->request().model.any()));
  action(Command::kRecord).setVisible(setup_.recording.open != nullptr);
  action(Command::kReplay).setVisible(setup_.recording.open != nullptr);
  action(Command::kReplay).setEnabled(!recording && setup_.recording.list != nullptr);
  action(Command::kRelease).setEnabled(recording || practice);
  action(Command::kRestart).setEnabled(practice);
  action(Command::kOpen).setEnabled(!recording);
  action(Command::kBring).setEnabled(!recording);
  action(Command::kCompare).setEnabled(practice && controller_->scene() != nullptr);
  recordingTime_->setVisible(recording);
  replayBar_->setVisible(mode == Mode::kReplay);
  exercise_->setChangeable(practice && !controller_->loading());
  detorsion_->setUsable(practice || recording);
  engineer_->setChangeable(practice && !controller_->loading());
  commands_->applyIcons(theme(themeKind_));
}

void SimulatorWindow::look(ViewPreset preset) {
  view_->camera().look(preset);
  view_->applyCamera();
}

void SimulatorWindow::toggleRecording() {
  if (controller_->mode() == SimulationController::Mode::kRecording) {
    controller_->stopRecording();
  } else {
    pointer_->park(controller_->parkingPoint_m());
    controller_->startRecording();
  }
}

void SimulatorWindow::chooseKeys() {
  if (askPointerKeys(this)) {
    pointer_->setKeys(PointerKeys::stored());
  }
}

void SimulatorWindow::showAbout() {
  QMessageBox::about(this, tr("About Torsio"),
                     tr("<h3>Torsio %1</h3><p>Training and assessment of surgical twist skills.</p>"
                        "<p>A training tool; not a medical device.</p>"
                        "<p>Free software under the GNU General Public License, version 3 or later.</p>")
                         .arg(toQString(softwareVersion())));
}

void SimulatorWindow::restoreChoices() {
  const QSettings settings;
  restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
  commands_->action(Command::kLattice)
      .setChecked(settings.value(QStringLiteral("view/lattice"), false).toBool());
}

void SimulatorWindow::saveChoices() const {
  QSettings settings;
  settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
  settings.setValue(QStringLiteral("view/lattice"), commands_->action(Command::kLattice).isChecked());
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
