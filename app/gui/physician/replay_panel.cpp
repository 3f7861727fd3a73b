// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/replay_panel.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/physician/review_labels.h"
#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/icons.h"
#include "app/gui/widgets/value_text.h"
#include "assessment/catalogue/quantity.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr int kFrame_ms = 33;
constexpr double kLongestFrame_s = 0.25;  // dragging a window or closing a lid does not count as watching
constexpr std::int64_t kJump_us = 5'000'000;
constexpr std::int64_t kStep_us = 40'000;
constexpr qint64 kLongestWait_ms = 250;  // for a frame of a window that may be invisible

}  // namespace

namespace {

std::optional<float> asFloat(const std::optional<double>& value) {
  return value ? std::optional(static_cast<float>(*value)) : std::nullopt;
}

TraceMarks marksOf(const BlindedTask& task) {
  return {.target_deg = static_cast<float>(degrees(task.target_rad)),
          .tolerance_deg = static_cast<float>(degrees(task.rules.tolerance_rad)),
          .torqueLimit_Nm = asFloat(task.rules.torqueLimit_Nm),
          .forceLimit_N = asFloat(task.rules.forceLimit_N)};
}

}  // namespace

std::shared_ptr<LoadedRecording> loadForShowing(BlindedRecording recording,
                                                const std::filesystem::path& assets) {
  std::shared_ptr<LoadedRecording> loaded;
  try {
    // Moves the chunks to the playback, to hold them in memory only once; the scene keeps the header.
    Trial trial{recording.trial.header, std::move(recording.trial.chunks), recording.trial.summary};
    TraceCollector traces(trial.summary.samples);
    TrialPlayback playback(std::move(trial), [&](std::span<const Sample> samples) { traces.add(samples); });
    loaded = std::make_shared<LoadedRecording>(std::move(playback), traces.finish(), recording.digest);
    loaded->task = recording.task;
    loaded->traces.marks = marksOf(recording.task);
  } catch (...) {
    rethrowBlinded(std::current_exception(), recording.label);
  }
  try {
    auto scene = std::make_shared<const Scene>(loadScene(sceneOf(recording, assets)));
    checkScene(recording, *scene);
    loaded->playback.setPoses(PoseTrack(*scene, loaded->playback.header(), loaded->playback.chunks()));
    loaded->view = makeViewScene(scene);
    if (auto shape = showAsyncShape(*scene, loaded->view)) {
      loaded->async = std::make_unique<AsyncModelPlayback>(scene, std::move(shape));
    }
    loaded->scene = std::move(scene);
  } catch (const Error&) {
    loaded->scene.reset();  // a user's own organ: only traces are shown
  }
  return loaded;
}

ReplayPanel::ReplayPanel(const std::filesystem::path& assets, QWidget* parent)
    : QWidget(parent),
      task_(named(sentence(this, false), "task")),
      sentence_(sentence(this)),
      view_(new SceneView(this)),
      traces_(new TraceView(this)),
      back_(new QToolButton(this)),
      play_(new QToolButton(this)),
      forward_(new QToolButton(this)),
      time_(named(new QLabel(this), "time")),
      speed_(new QLabel(this)),
      digest_(new QLabel(this)),
      theme_(&theme(ThemeKind::kLight)) {
  sentence_->setAlignment(Qt::AlignCenter);
  sentence_->setContentsMargins(2 * kSpace, kSpace, 2 * kSpace, kSpace);
  view_->setInstrument(loadInstrument(assets, "grasper"));
  QVBoxLayout* column = columnOf(this, {}, kSpace);
  task_->setMinimumHeight(fontMetrics().height());
  column->addWidget(task_);
  column->addWidget(view_, 3);
  column->addWidget(sentence_, 1);
  column->addWidget(traces_, 0);
  createTransport();
  connect(view_, &SceneView::frameDrawn, this, [this] {
    if (awaitsFrame_) {
      showBeside();
    }
  });
  connect(traces_, &TraceView::soughtTo, this, [this](qint64 at) { seek_us(at); });
  connect(&timer_, &QTimer::timeout, this, [this] {
    const double elapsed_s = static_cast<double>(sinceFrame_.restart()) * 1e-3;
    frame(std::min(elapsed_s, kLongestFrame_s));
  });
  view_->hide();
}

void ReplayPanel::createTransport() {
  QHBoxLayout* bar = rowOf();
  for (QToolButton* button : {back_, play_, forward_}) {
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setFocusPolicy(Qt::TabFocus);
    bar->addWidget(button);
  }
  for (QLabel* label : {speed_, digest_}) {
    label->setProperty("quiet", true);
  }
  bar->addSpacing(kSpace);
  bar->addWidget(time_);
  bar->addWidget(speed_);
  bar->addStretch(1);
  bar->addWidget(digest_);
  static_cast<QVBoxLayout*>(layout())->addLayout(bar);
  connect(play_, &QToolButton::clicked, this, &ReplayPanel::togglePlay);
  connect(back_, &QToolButton::clicked, this, [this] { seek_us(position_us() - kJump_us); });
  connect(forward_, &QToolButton::clicked, this, [this] { seek_us(position_us() + kJump_us); });
}

void ReplayPanel::setTheme(const Theme& theme) {
  theme_ = &theme;
  view_->setTheme(theme);
  traces_->setTheme(theme);
  showTransport();
}

void ReplayPanel::retranslate() {
  traces_->retranslate();
  view_->setAccessibleName(tr("The organ in three dimensions"));
  back_->setText(tr("5 s back"));
  back_->setToolTip(tr("Jumps five seconds back (J)"));
  forward_->setText(tr("5 s forward"));
  forward_->setToolTip(tr("Jumps five seconds on; what is skipped does not count as watched"));
  play_->setToolTip(tr("Plays or pauses (Space)"));
  time_->setAccessibleName(tr("Time in the recording"));
  digest_->setToolTip(
      tr("Proves that this is the recording as it was stored. It reveals nothing else and differs for each "
         "physician"));
  showTask();
  showState();
  showTransport();
}

void ReplayPanel::showTask() {
  task_->setVisible(ready());
  task_->setText(ready() ? taskText(recording_->task) : QString());
}

QString ReplayPanel::taskText(const BlindedTask& task) {
  const AttemptRules& rules = task.rules;
  QStringList parts;
  if (task.untwisting()) {
    parts << tr("Undo the twist, then hands off");
  } else {
    parts << tr("Twist to %1\u00B0 and release within \u00B1%2\u00B0")
                 .arg(numberText(degrees(task.target_rad), 0), pointsText(degrees(rules.tolerance_rad)));
    if (rules.hold_s > 0.0) {
      parts << tr("hold for %1 s").arg(pointsText(rules.hold_s));
    }
    if (rules.leastTwists > 1) {
      parts << tr("at least %n twist(s)", nullptr, static_cast<int>(rules.leastTwists));
    }
  }
  if (rules.forceLimit_N) {
    parts << tr("force up to %1").arg(toQString(shownValue(Quantity::kPeakForce, *rules.forceLimit_N)));
  }
  if (rules.torqueLimit_Nm) {
    parts << tr("torque up to %1").arg(toQString(shownValue(Quantity::kPeakTorque, *rules.torqueLimit_Nm)));
  }
  return tr("Asked for: %1").arg(parts.join(QStringLiteral("  \u00b7  ")));
}

/// On a tall screen, the traces grow too.
void ReplayPanel::fitTraces() {
  constexpr int kShare = 4;  // a quarter of the panel
  const int share = height() / kShare;
  traces_->setMinimumHeight(share > traces_->sizeHint().height() ? share : 0);
}

void ReplayPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitTraces();
}

void ReplayPanel::showSentence(const QString& text) {
  sentence_->setText(text);
  sentence_->setVisible(!text.isEmpty());
}

void ReplayPanel::show(std::shared_ptr<LoadedRecording> recording) {
  timer_.stop();
  recording_ = std::move(recording);
  traces_->setData(recording_ != nullptr ? &recording_->traces : nullptr);
  fitTraces();
  const bool picture = recording_ != nullptr && recording_->scene != nullptr;
  view_->setVisible(picture);
  if (picture) {
    view_->setScene(recording_->view);
    view_->frameOrgan();
  } else {
    view_->forgetScene();
  }
  if (recording_ != nullptr) {
    showSentence(picture
                     ? QString()
                     : tr("The organ of this recording is not on this machine; the traces are complete."));
    recording_->playback.setSpeed(std::clamp(1.0, speeds_.front(), speeds_.back()));
  }
  showTask();
  showState();
  showTransport();
  if (std::exchange(playAsked_, false) && ready()) {
    togglePlay();
  }
}

void ReplayPanel::setSpeeds(std::vector<double> speeds) {
  speeds_ = std::move(speeds);
  showTransport();
}

void ReplayPanel::seek_us(std::int64_t position_us) {
  if (!ready()) {
    return;
  }
  recording_->playback.seek_us(position_us);
  showState();
  Q_EMIT moved(recording_->playback.position_us());
}

void ReplayPanel::togglePlay() {
  if (!ready()) {
    playAsked_ = !playAsked_;
    return;
  }
  recording_->playback.setPlaying(!playing());
  if (playing() && realTime_) {
    sinceFrame_.start();
    timer_.start(kFrame_ms);
  } else {
    timer_.stop();
  }
  showTransport();
}

void ReplayPanel::pause() {
  playAsked_ = false;
  if (playing()) {
    togglePlay();
  }
}

void ReplayPanel::changeSpeed(int direction) {
  const double now = recording_->playback.speed();
  auto at = std::min_element(speeds_.begin(), speeds_.end(),
                             [now](double a, double b) { return std::abs(a - now) < std::abs(b - now); });
  if (direction > 0 && at + 1 != speeds_.end()) {
    ++at;
  }
  if (direction < 0 && at != speeds_.begin()) {
    --at;
  }
  recording_->playback.setSpeed(*at);
  showTransport();
}

bool ReplayPanel::handleKey(int key) {
  switch (key) {
    case Qt::Key_Space:
      togglePlay();
      return true;
    case Qt::Key_K:
      pause();
      return true;
    case Qt::Key_L:
      if (!ready()) {
        playAsked_ = true;
        return true;
      }
      if (playing()) {
        changeSpeed(+1);
      } else {
        togglePlay();
      }
      return true;
    case Qt::Key_J:
      if (!ready()) {
        return true;
      }
      if (playing() && recording_->playback.speed() > speeds_.front()) {
        changeSpeed(-1);
      } else {
        seek_us(position_us() - kJump_us);
      }
      return true;
    case Qt::Key_Comma:
      pause();
      seek_us(position_us() - kStep_us);
      return true;
    case Qt::Key_Period:
      pause();
      seek_us(position_us() + kStep_us);
      return true;
    case Qt::Key_Home:
      pause();
      seek_us(0);
      return true;
    case Qt::Key_End:
      pause();
      if (ready()) {
        seek_us(recording_->playback.duration_us());
      }
      return true;
    default:
      return false;
  }
}

void ReplayPanel::frame(double elapsed_s) {
  if (!playing()) {
    return;
  }
  TrialPlayback& playback = recording_->playback;
  const std::int64_t before_us = playback.position_us();
  playback.advance(elapsed_s);
  showState();
  Q_EMIT played(before_us, playback.position_us(), playback.speed());
  Q_EMIT moved(playback.position_us());
  if (!playback.playing()) {
    timer_.stop();
    showTransport();
  }
}

void ReplayPanel::showState() {
  if (recording_ != nullptr && recording_->scene != nullptr) {
    const LiveState state = recording_->playback.state();
    if (recording_->async) {
      recording_->async->follow(state);
    }
    view_->setOrgan(organStateOf(state));
    view_->setTool(state.tool, state.grip);
    view_->setForce(state.tool.position_m, state.response.force_N);
    if (view_->draws()) {
      view_->redraw();
      if (!awaitsFrame_) {
        awaitsFrame_.emplace().start();
      }
      if (awaitsFrame_->elapsed() < kLongestWait_ms) {
        return;
      }
    }
  }
  showBeside();
}

void ReplayPanel::setWatched(std::vector<std::pair<std::int64_t, std::int64_t>> spans_us) {
  if (awaitsFrame_) {
    watched_us_ = std::move(spans_us);
  } else {
    traces_->setWatched(std::move(spans_us));
  }
}

void ReplayPanel::showBeside() {
  awaitsFrame_.reset();
  if (watched_us_) {
    traces_->setWatched(*std::exchange(watched_us_, std::nullopt));
  }
  if (!ready()) {
    time_->clear();
    return;
  }
  traces_->setPosition_us(position_us());
  const QString text =
      tr("%1 of %2").arg(clockTenthsOf(position_us()), clockTenthsOf(recording_->playback.duration_us()));
  if (time_->text() != text) {
    time_->setText(text);
  }
}

void ReplayPanel::showTransport() {
  const bool going = playing();
  play_->setText(going ? tr("Pause") : tr("Play"));
  play_->setIcon(icon(going ? QStringLiteral("pause") : QStringLiteral("play"), *theme_));
  for (QToolButton* button : {back_, play_, forward_}) {
    button->setEnabled(ready());
  }
  const double speed = ready() ? recording_->playback.speed() : 1.0;
  const QString figure = QLocale().toString(speed);
  speed_->setText(speeds_.size() == 1 ? tr("%1 \u00d7, locked").arg(figure) : tr("%1 \u00d7").arg(figure));
  speed_->setToolTip(speeds_.size() == 1 ? tr("Scored recordings play as they happened")
                                         : tr("J slower, L faster; the speed is kept with the mark"));
  digest_->setText(ready() ? tr("Recording %1, unchanged").arg(toQString(recording_->digest)) : QString());
}

}  // namespace torsio::gui
