// SPDX-License-Identifier: GPL-3.0-or-later
// What the window asks and tells in boxes of its own.
#include <utility>

#include <QInputDialog>
#include <QMessageBox>

#include "app/gui/base/clock_time.h"
#include "app/gui/base/scene_titles.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/practice/simulator_window.h"
#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/simulator/detorsion_panel.h"
#include "app/gui/simulator/pointer_controls.h"
#include "app/gui/widgets/date_text.h"
#include "app/gui/widgets/file_choice.h"
#include "app/services/base/build_info.h"
#include "sim/core/error.h"
#include "sim/scene/organ_file.h"

namespace torsio::gui {

void SimulatorWindow::chooseOrganFile() {
  const QString file = askFileToOpen(
      this, tr("Open organ"),
      tr("Organs and meshes (*.organ *.obj *.stl *.ply *.off *.glb *.gltf *.dae);;All files (*)"));
  if (file.isEmpty()) {
    return;
  }
  SceneRequest request = controller_->request();
  request.organFile = toPath(file);
  request.pattern.clear();  // those of its own anatomy, not of the organ before
  if (isOrganFile(*request.organFile)) {
    request.organScale_m = 0.001;  // it says its unit itself
    controller_->load(request);
    return;
  }
  const QStringList units{tr("millimetres"), tr("centimetres"), tr("metres")};
  const double scales_m[] = {0.001, 0.01, 1.0};
  bool chosen = false;
  const QString unit =
      QInputDialog::getItem(this, tr("Open organ"), tr("The file's numbers are"), units, 0, false, &chosen);
  if (!chosen) {
    return;
  }
  request.organScale_m = scales_m[units.indexOf(unit)];
  controller_->load(request);
}

void SimulatorWindow::showInstrument(const std::filesystem::path& file) {
  view_->setInstrument(loadInstrument(file));
}

void SimulatorWindow::chooseInstrument() {
  const QString file = askFileToOpen(this, tr("Instrument"), tr("Instruments (*.json)"));
  if (file.isEmpty()) {
    return;
  }
  try {
    showInstrument(toPath(file));
  } catch (const Error& error) {
    const TranslatedError said = translated(error);
    showProblem(said.happened, said.remedy, said.details);
  }
}

void SimulatorWindow::chooseReplay() {
  try {
    const std::vector<RecordedTrial> trials = setup_.recording.list();
    if (trials.empty()) {
      Q_EMIT controller_->noticed(tr("Nothing has been recorded yet."));
      return;
    }
    SceneTitles titles(setup_.assets);
    QStringList lines;
    for (const RecordedTrial& trial : trials) {
      lines << tr("%1   %2, %3   %4")
                   .arg(shownTime(trial.startedUtc_us), titles.scene(trial.sceneId),
                        titles.pattern(trial.sceneId, trial.patternId), clockTenths(trial.duration_s));
    }
    bool chosen = false;
    const QString line =
        QInputDialog::getItem(this, tr("Replay"), tr("Recorded run"), lines, 0, false, &chosen);
    if (!chosen) {
      return;
    }
    controller_->openReplay(setup_.recording.load(trials[static_cast<std::size_t>(lines.indexOf(line))].id));
  } catch (const Error& error) {
    const TranslatedError said = translated(error);
    showProblem(said.happened, said.remedy, said.details);
  }
}

void SimulatorWindow::showProblem(const QString& happened, const QString& remedy, const QString& details) {
  QMessageBox box(QMessageBox::Warning, tr("Torsio"), happened, QMessageBox::Ok, this);
  box.setInformativeText(remedy);
  box.setDetailedText(details);
  box.exec();
}

std::vector<std::pair<QString, QString>> SimulatorWindow::pointerKeys() {
  std::vector<std::pair<QString, QString>> all{
      {tr("Move the instrument"), tr("Mouse, or arrow keys")},
      {tr("Depth"), tr("Wheel, or Page Up and Page Down")},
      {tr("Grip"), tr("Left button or Space (hold), G (keep)")},
      {tr("Twist what is held"), tr("Drag, Shift + wheel, or Q and E")},
      {tr("Tilt the instrument"), tr("A, D, W, S")},
      {tr("Release"), tr("Release the button, or Esc")},
      {tr("Bookmark"), tr("B")},
      {tr("Turn the view"), tr("Right drag, or Ctrl + arrow keys")},
      {tr("Move the view"), tr("Middle drag")},
      {tr("Zoom"), tr("Ctrl + wheel, or + and \u2212")},
  };
  for (auto& key : DetorsionPanel::keys()) {
    all.push_back(std::move(key));
  }
  return all;
}

void SimulatorWindow::chooseKeys() {
  if (askPointerKeys(this)) {
    pointer_->setKeys(PointerKeys::stored());
  }
}

void SimulatorWindow::showHelp() {
  QString text = QStringLiteral("<table cellspacing='6'>");
  for (const auto& [what, how] : pointerKeys()) {
    text +=
        QStringLiteral("<tr><td style='padding-right:24px'><b>%1</b></td><td>%2</td></tr>").arg(what, how);
  }
  text += QStringLiteral("</table>");
  QMessageBox box(QMessageBox::NoIcon, tr("Controls"), text, QMessageBox::Close, this);
  box.setTextFormat(Qt::RichText);
  box.exec();
}

void SimulatorWindow::showAbout() {
  QMessageBox::about(this, tr("About Torsio"),
                     tr("<h3>Torsio %1</h3><p>Training and assessment of surgical twist skills.</p>"
                        "<p>A training tool; not a medical device.</p>"
                        "<p>Free software under the GNU General Public License, version 3 or later.</p>")
                         .arg(toQString(softwareVersion())));
}

}  // namespace torsio::gui
