// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/debrief_replay.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/icons.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr int kReplayFrame_ms = 33;
constexpr double kLongestReplayFrame_s = 0.25;
constexpr double kSliderSteps_per_s = 100.0;
constexpr int kSliderPage = 100;  // one second
constexpr int kLeastReplayHeight = 260;

std::int64_t inMicroseconds(double time_s) noexcept {
  return std::llround(time_s * 1e6);
}

TrialPlayback playbackOf(const Trial& trial, const Scene& scene) {
  TrialPlayback playback{trial};
  playback.setPoses(PoseTrack(scene, playback.header(), playback.chunks()));
  return playback;
}

}  // namespace

std::optional<double> DebriefRecordings::expertTime_s(double at_s) const noexcept {
  const auto after = std::upper_bound(grips_s.begin(), grips_s.end(), at_s);
  if (!expert || after == grips_s.begin()) {
    return std::nullopt;
  }
  const double since_s = at_s - *(after - 1);
  return since_s <= expertLasts_s ? std::optional(expertGrip_s + since_s) : std::nullopt;
}

std::shared_ptr<DebriefRecordings> loadForDebrief(const Debrief& debrief, const std::filesystem::path& assets,
                                                  std::shared_ptr<const Scene> scene) {
  if (debrief.recording == nullptr) {
    return nullptr;
  }
  const TrialHeader& header = debrief.recording->header;
  try {
    if (scene == nullptr || scene->parameterHash != header.parameterHash ||
        scene->organHash != header.organHash) {
      SceneRequest request = sceneRequestFor(header.parametersJson);
      request.assets = assets;
      request.id = header.sceneId;
      request.pattern = header.patternId;
      scene = std::make_shared<const Scene>(loadScene(request));
    }
    if (scene->parameterHash != header.parameterHash || scene->organHash != header.organHash) {
      return nullptr;
    }
    auto loaded = std::make_shared<DebriefRecordings>(playbackOf(*debrief.recording, *scene));
    if (debrief.expertRecording != nullptr && !debrief.expert.empty()) {
      loaded->expert = playbackOf(*debrief.expertRecording, *scene);
      loaded->expertGrip_s = debrief.expertGrip_s;
      loaded->expertLasts_s = debrief.expert.time_s.back();
      loaded->grips_s = debrief.grips_s;
    }
    loaded->view = makeViewScene(scene);
    if (auto shape = showAsyncShape(*scene, loaded->view)) {
      loaded->async = std::make_unique<AsyncModelPlayback>(scene, std::move(shape));
    }
    loaded->scene = std::move(scene);
    return loaded;
  } catch (const Error&) {
    return nullptr;  // a user's own organ: only curves are shown
  }
}

DebriefReplay::DebriefReplay(const std::filesystem::path& assets, QWidget* parent)
    : QWidget(parent),
      view_(new SceneView(this)),
      play_(named(new QToolButton(this), "play")),
      slider_(named(new QSlider(Qt::Horizontal, this), "slider")),
      time_(new QLabel(this)),
      theme_(&theme(ThemeKind::kLight)) {
  view_->setInstrument(loadInstrument(assets, "grasper"));
  view_->setMinimumHeight(kLeastReplayHeight);
  slider_->setPageStep(kSliderPage);
  play_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  play_->setFocusPolicy(Qt::TabFocus);
  QVBoxLayout* column = columnOf(this, {}, kSpace);
  column->addWidget(view_, 1);
  QHBoxLayout* bar = rowOf({play_});
  bar->addWidget(slider_, 1);
  bar->addWidget(time_);
  column->addLayout(bar);
  connect(play_, &QToolButton::clicked, this, &DebriefReplay::togglePlay);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) { seek(value / kSliderSteps_per_s); });
  connect(&timer_, &QTimer::timeout, this, [this] {
    const double elapsed_s = static_cast<double>(sinceFrame_.restart()) * 1e-3;
    frame(std::min(elapsed_s, kLongestReplayFrame_s));
  });
  retranslate();
}

void DebriefReplay::show(std::shared_ptr<DebriefRecordings> recordings) {
  timer_.stop();
  recordings_ = std::move(recordings);
  setVisible(recordings_ != nullptr);
  ghost_ = false;
  if (recordings_ == nullptr) {
    view_->forgetScene();
    return;
  }
  view_->setScene(recordings_->view);
  view_->frameOrgan();
  {
    const QSignalBlocker quiet(slider_);
    slider_->setRange(
        0, static_cast<int>(static_cast<double>(recordings_->own.duration_us()) * 1e-6 * kSliderSteps_per_s));
    slider_->setValue(0);
  }
  showState();
  showTransport();
}

void DebriefReplay::setExpertVisible(bool visible) {
  expertVisible_ = visible;
  showState();
}

void DebriefReplay::setTheme(const Theme& theme) {
  theme_ = &theme;
  view_->setTheme(theme);
  showTransport();
}

void DebriefReplay::retranslate() {
  view_->setAccessibleName(tr("Your run in three dimensions; the expert's organ shines through"));
  slider_->setAccessibleName(tr("Time in the run, for your run and the expert's"));
  play_->setToolTip(tr("Plays or pauses"));
  showTransport();
  showTime();
}

double DebriefReplay::position_s() const noexcept {
  return recordings_ == nullptr ? 0.0 : static_cast<double>(recordings_->own.position_us()) * 1e-6;
}

void DebriefReplay::seek(double at_s) {
  if (recordings_ == nullptr) {
    return;
  }
  recordings_->own.seek_us(inMicroseconds(at_s));
  showState();
  Q_EMIT moved(position_s());
}

QImage DebriefReplay::pictureAt(double at_s) {
  if (recordings_ == nullptr || !SceneView::platformCanRender()) {
    return {};
  }
  const double before_s = position_s();
  const bool expert = std::exchange(expertVisible_, false);
  recordings_->own.seek_us(inMicroseconds(at_s));
  showState();
  QImage picture = view_->picture();
  expertVisible_ = expert;
  recordings_->own.seek_us(inMicroseconds(before_s));
  showState();
  return picture;
}

void DebriefReplay::togglePlay() {
  if (recordings_ == nullptr) {
    return;
  }
  recordings_->own.setPlaying(!recordings_->own.playing());
  if (recordings_->own.playing()) {
    sinceFrame_.start();
    timer_.start(kReplayFrame_ms);
  } else {
    timer_.stop();
  }
  showTransport();
}

void DebriefReplay::frame(double elapsed_s) {
  if (recordings_ == nullptr || !recordings_->own.playing()) {
    return;
  }
  recordings_->own.advance(elapsed_s);
  showState();
  Q_EMIT moved(position_s());
  if (!recordings_->own.playing()) {
    timer_.stop();
    showTransport();
  }
}

void DebriefReplay::showState() {
  if (recordings_ == nullptr) {
    return;
  }
  const LiveState state = recordings_->own.state();
  if (recordings_->async) {
    recordings_->async->follow(state);
  }
  view_->setOrgan(organStateOf(state));
  view_->setTool(state.tool, state.grip);
  view_->setForce(state.tool.position_m, state.response.force_N);
  const std::optional<double> expert_s =
      expertVisible_ ? recordings_->expertTime_s(position_s()) : std::nullopt;
  ghost_ = expert_s.has_value();
  if (expert_s) {
    recordings_->expert->seek_us(inMicroseconds(*expert_s));
    view_->setGhost(organStateOf(recordings_->expert->state()));
  } else {
    view_->setGhost(std::nullopt);
  }
  view_->redraw();
  const QSignalBlocker quiet(slider_);
  slider_->setValue(static_cast<int>(position_s() * kSliderSteps_per_s));
  showTime();
}

void DebriefReplay::showTime() {
  if (recordings_ == nullptr) {
    return;
  }
  time_->setText(
      tr("%1 of %2").arg(clockTenths(position_s()), clockTenthsOf(recordings_->own.duration_us())));
}

void DebriefReplay::showTransport() {
  const bool going = recordings_ != nullptr && recordings_->own.playing();
  play_->setText(going ? tr("Pause") : tr("Play"));
  play_->setIcon(icon(going ? QStringLiteral("pause") : QStringLiteral("play"), *theme_));
}

}  // namespace torsio::gui
