// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and film strips of what the window shows.
#include <QLocale>

#include "app/gui/base/clock_time.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/practice/simulator_window.h"
#include "app/gui/simulator/shown_tool.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/picture.h"
#include "sim/core/error.h"

namespace torsio::gui {

void SimulatorWindow::choosePicture() {
  const QString file = askFileToSave(this, tr("Save picture"), tr("torsio.png"), tr("PNG pictures (*.png)"));
  if (file.isEmpty()) {
    return;
  }
  savePicture(view_->picture(), file);
}

void SimulatorWindow::savePicture(const QImage& picture, const QString& file) {
  try {
    writePicture(picture, file.toStdString());
    Q_EMIT controller_->noticed(tr("Saved %1").arg(file));
  } catch (const Error& error) {
    const TranslatedError said = translated(error);
    showProblem(said.happened, said.remedy, said.details);
  }
}

void SimulatorWindow::chooseFilmStrip() {
  if (controller_->scene() == nullptr || !SceneView::platformCanRender()) {
    Q_EMIT controller_->noticed(tr("There is no picture to capture here"));
    return;
  }
  if (controller_->mode() == SimulationController::Mode::kRecording) {
    Q_EMIT controller_->noticed(tr("Stop the recording before you save a film strip."));
    return;
  }
  const QString file =
      askFileToSave(this, tr("Save film strip"), tr("film-strip.png"), tr("PNG pictures (*.png)"));
  if (file.isEmpty()) {
    return;
  }
  const std::vector<StripFrame> frames =
      controller_->playback() != nullptr
          ? replayFrames()
          : captureStrip(*view_, *controller_->scene(), controller_->target_rad());
  savePicture(filmStrip(stripRows(frames)), file);
}

std::vector<StripFrame> SimulatorWindow::replayFrames() {
  TrialPlayback& playback = *controller_->playback();
  const std::int64_t before_us = playback.position_us();
  std::vector<StripFrame> frames;
  for (const StripMoment& moment : stripMoments(playback)) {
    playback.seek_us(moment.position_us);
    const LiveState state = playback.state();
    view_->setTissue(tool_->show(state));
    const QString time = clockTenthsOf(moment.position_us);
    frames.push_back({tr("%1 after %2").arg(angleCaption(moment.angle_rad), time), view_->picture()});
  }
  playback.seek_us(before_us);
  return frames;
}

}  // namespace torsio::gui
