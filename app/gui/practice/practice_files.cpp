// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/practice/practice_files.h"

#include <QInputDialog>
#include <QMessageBox>

#include "app/gui/base/scene_titles.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/simulator/shown_tool.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/picture.h"
#include "app/gui/widgets/value_text.h"
#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_space.h"
#include "sim/scene/organ_file.h"

namespace torsio::gui {

PracticeFiles::PracticeFiles(SimulationController& controller, SceneView& view, ShownTool& tool,
                             QWidget& window)
    : QObject(&window), controller_(controller), view_(view), tool_(tool), window_(window) {
  connect(&controller, &SimulationController::failed, this, &PracticeFiles::tellProblem);
}

void PracticeFiles::tellProblem(const QString& happened, const QString& remedy, const QString& details) {
  QMessageBox box(QMessageBox::Warning, tr("Torsio"), happened, QMessageBox::Ok, &window_);
  box.setInformativeText(remedy);
  box.setDetailedText(details);
  box.exec();
}

template <typename Act>
void PracticeFiles::attempt(const Act& act) {
  try {
    act();
  } catch (const Error& error) {
    const TranslatedError said = translated(error);
    tellProblem(said.happened, said.remedy, said.details);
  }
}

void PracticeFiles::openOrgan() {
  const QString file = askFileToOpen(
      &window_, tr("Open organ"),
      tr("Organs and meshes (*.organ *.obj *.stl *.ply *.off *.glb *.gltf *.dae);;All files (*)"));
  if (file.isEmpty()) {
    return;
  }
  SceneRequest request = controller_.request();
  request.organFile = toPath(file);
  request.pattern.clear();  // the new organ has its own patterns
  request.organScale_m = meshUnit_m(*request.organFile, {});
  if (!isOrganFile(*request.organFile) && !meshSpaceOf(*request.organFile).unit_m) {  // the file does not say
    const QStringList units{tr("millimetres"), tr("centimetres"), tr("metres"), tr("micrometres")};
    constexpr double kScales_m[] = {0.001, 0.01, 1.0, 1e-6};
    bool chosen = false;
    const QString unit = QInputDialog::getItem(&window_, tr("Open organ"), tr("The file's numbers are"),
                                               units, 0, false, &chosen);
    if (!chosen) {
      return;
    }
    request.organScale_m = kScales_m[units.indexOf(unit)];
  }
  controller_.load(request);
}

void PracticeFiles::openInstrument() {
  const QString file = askFileToOpen(&window_, tr("Instrument"), tr("Instruments (*.json)"));
  if (!file.isEmpty()) {
    attempt([&] { view_.setInstrument(loadInstrument(toPath(file))); });
  }
}

void PracticeFiles::openReplay(const TrialRecording& recording, const std::filesystem::path& assets) {
  attempt([&] {
    const std::vector<RecordedTrial> trials = recording.list();
    if (trials.empty()) {
      Q_EMIT controller_.noticed(tr("Nothing has been recorded yet."));
      return;
    }
    SceneTitles titles(assets);
    QStringList lines;
    for (const RecordedTrial& trial : trials) {
      lines << tr("%1   %2, %3   %4")
                   .arg(shownTime(trial.startedUtc_us), titles.scene(trial.sceneId),
                        titles.pattern(trial.sceneId, trial.patternId), clockTenths(trial.duration_s));
    }
    bool chosen = false;
    const QString line =
        QInputDialog::getItem(&window_, tr("Replay"), tr("Recorded run"), lines, 0, false, &chosen);
    if (chosen) {
      controller_.openReplay(recording.load(trials[static_cast<std::size_t>(lines.indexOf(line))].id));
    }
  });
}

void PracticeFiles::save(const QString& title, const QString& name, const std::function<QImage()>& draw) {
  const QString file = askFileToSave(&window_, title, name, tr("PNG pictures (*.png)"));
  if (!file.isEmpty()) {
    attempt([&] {
      writePicture(draw(), file.toStdString());
      Q_EMIT controller_.noticed(tr("Saved %1").arg(file));
    });
  }
}

void PracticeFiles::savePicture() {
  save(tr("Save picture"), tr("torsio.png"), [this] { return view_.picture(); });
}

void PracticeFiles::saveFilmStrip() {
  if (controller_.scene() == nullptr || !SceneView::platformCanRender()) {
    Q_EMIT controller_.noticed(tr("There is no picture to capture here"));
    return;
  }
  if (controller_.mode() == SimulationController::Mode::kRecording) {
    Q_EMIT controller_.noticed(tr("Stop the recording before you save a film strip."));
    return;
  }
  save(tr("Save film strip"), tr("film-strip.png"), [this] {
    return filmStrip(stripRows(controller_.playback() != nullptr
                                   ? replayFrames()
                                   : captureStrip(view_, *controller_.scene(), controller_.target_rad())));
  });
}

std::vector<StripFrame> PracticeFiles::replayFrames() {
  TrialPlayback& playback = *controller_.playback();
  const std::int64_t before_us = playback.position_us();
  std::vector<StripFrame> frames;
  for (const StripMoment& moment : stripMoments(playback)) {
    playback.seek_us(moment.position_us);
    view_.setTissue(tool_.show(playback.state()));
    const QString time = clockTenthsOf(moment.position_us);
    frames.push_back({tr("%1 after %2").arg(angleCaption(moment.angle_rad), time), view_.picture()});
  }
  playback.seek_us(before_us);
  return frames;
}

}  // namespace torsio::gui
