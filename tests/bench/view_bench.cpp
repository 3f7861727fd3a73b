// SPDX-License-Identifier: GPL-3.0-or-later
// Frame rate and servo timing, measured simultaneously: a scripted hand twists an organ in real time with the
// same servo, recorder and view as a trainee's run, first without a picture, then at each level of quality.
//   torsio_bench_view [--seconds S] [--size WxH] [--organ ID] [--triangles N] [--level fast|fine|best]
//   [--smoke] [--parts] [--pictures FOLDER]
// Without --level: fast and fine. --pictures saves the last picture of each level.
// --parts prints the processor's work for a frame of the organ, without drawing.
// TORSIO_DEFORM=processor and =card choose who deforms the organ at the fine level: on a graphics card run
// both and compare.
// --smoke fails unless every level drew and the servo ticked; it asserts no timing.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QElapsedTimer>
#include <QTimer>

#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/scene/organ_geometry.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/widgets/theme.h"
#include "app/services/recording/recorded_run.h"
#include "sim/core/error.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/scene/hollow_organ.h"
#include "sim/servo/hand_task.h"
#include "tests/sim/servo/bar_scene.h"
#include "tests/support/shipped_scene.h"

namespace {

using namespace torsio;
using namespace torsio::gui;

constexpr double kWarmUp_s = 2.0;  // shaders are compiled during the first frames
constexpr double kTick_us = 1000.0;
constexpr int kPulse_ms = 4;
constexpr double kPatience_s = 120.0;

struct Options {
  double seconds = 10.0;
  QSize size{1280, 800};
  std::string organ = "stomach";
  int triangles = 0;  // 0: the shipped organ; otherwise a round bar with this number
  std::vector<RenderQuality> levels{RenderQuality::kFast, RenderQuality::kFine};
  bool smoke = false;
  bool parts = false;
  QString pictures;  // output folder; empty: none
};

const char* nameOf(RenderQuality level) {
  switch (level) {
    case RenderQuality::kFast:
      return "fast";
    case RenderQuality::kFine:
      return "fine";
    case RenderQuality::kBest:
      return "best";
    case RenderQuality::kAutomatic:
      break;
  }
  return "automatic";
}

struct Outcome {
  std::vector<double> frames_ms;  // sorted
  double span_s = 0.0;
  double processor_s = 0.0;  // of all threads
  std::int64_t ticks = 0;
  std::int64_t lateTicks = 0;
  TimingSummary wakeUp;
  TimingSummary duration;
  std::vector<std::pair<double, std::int64_t>> delays;  // upper edge in us, count
};

class NoSink final : public TrialSink {
 public:
  void begin(const TrialHeader&) override {}
  void append(const TrialChunk&) override {}
  void finish(const TrialSummary&) override {}
};

std::shared_ptr<const Scene> sceneOf(const Options& options) {
  if (options.triangles > 0) {
    const int rows = std::max(8, static_cast<int>(std::sqrt(options.triangles / 2.5)));
    const int sides = std::max(12, options.triangles / (2 * rows));
    return std::make_shared<const Scene>(barScene(
        torsio::testing::prism(torsio::testing::circleOutline(kBarRadius_m, sides), kBarLength_m, rows)));
  }
  return std::make_shared<const Scene>(torsio::testing::shippedScene(options.organ));
}

std::unique_ptr<ScriptedHand> handFor(const Scene& scene, double seconds) {
  ScriptedHandOptions hand;
  hand.task = handTask(scene);
  hand.duration_s = seconds;
  return std::make_unique<ScriptedHand>(hand);
}

std::unique_ptr<RecordedRun> runOf(const std::shared_ptr<const Scene>& scene, double seconds) {
  return std::make_unique<RecordedRun>(scene, handFor(*scene, seconds), RecordingSpec{.trialId = "bench"},
                                       std::make_shared<NoSink>());
}

/// Waits for an event; with a timeout, Qt would busy-wait and take the processor from the renderer.
void wait() {
  QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
}

double processor_s() {
  timespec used{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * 1e-9;
}

/// `view`: null to draw nothing.
Outcome measure(const std::shared_ptr<const Scene>& scene, SceneView* view, double seconds) {
  Outcome outcome;
  const std::unique_ptr<RecordedRun> run = runOf(scene, seconds + kPatience_s);
  run->start();
  QElapsedTimer clock;
  clock.start();
  QElapsedTimer sinceFrame;
  std::int64_t drawn = view != nullptr ? view->framesDrawn() : 0;
  const double begun_s = processor_s();
  while (static_cast<double>(clock.elapsed()) * 1e-3 < seconds) {
    const LiveState state = run->latest();
    if (view != nullptr) {
      view->setTissue(state);
      view->setTool(state.tool, state.grip);
      view->redraw();
    }
    wait();
    if (view == nullptr || view->framesDrawn() == drawn) {
      continue;
    }
    drawn = view->framesDrawn();
    if (sinceFrame.isValid()) {
      outcome.frames_ms.push_back(static_cast<double>(sinceFrame.nsecsElapsed()) * 1e-6);
    }
    sinceFrame.start();
  }
  outcome.span_s = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
  outcome.processor_s = processor_s() - begun_s;
  const ServoThread& thread = run->thread();
  outcome.wakeUp = thread.wakeUp();
  outcome.duration = thread.duration();
  thread.wakeUpHistogram().forEach(
      [&](double, double to_us, std::int64_t count) { outcome.delays.emplace_back(to_us, count); });
  outcome.ticks = run->latest().tick;
  outcome.lateTicks = run->latest().lateTicks;
  static_cast<void>(run->finish(TrialOutcome::kCompleted));
  std::sort(outcome.frames_ms.begin(), outcome.frames_ms.end());
  return outcome;
}

double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) {
    return 0.0;
  }
  const double place = share * static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(place)];
}

void print(const char* name, const Outcome& outcome, const Outcome& still) {
  std::printf("\n%s\n", name);
  if (!outcome.frames_ms.empty()) {
    const auto frames = static_cast<double>(outcome.frames_ms.size());
    // Servo and recorder need the same time however slow the frames.
    const double picture_s = outcome.processor_s - outcome.span_s * still.processor_s / still.span_s;
    std::printf(
        "  %.1f frames/s; frame time p50 %.1f, p95 %.1f, p99 %.1f ms; processor a frame %.1f ms, %.1f ms "
        "without servo and recorder\n",
        frames / outcome.span_s, quantile(outcome.frames_ms, 0.5), quantile(outcome.frames_ms, 0.95),
        quantile(outcome.frames_ms, 0.99), 1000.0 * outcome.processor_s / frames,
        1000.0 * picture_s / frames);
  }
  std::printf(
      "  servo: %lld ticks, %lld late (%.3f %%); wake-up delay p50 %.0f, p99 %.0f, p99.9 %.0f, max %.0f us; "
      "tick p99 %.0f us\n",
      static_cast<long long>(outcome.ticks), static_cast<long long>(outcome.lateTicks),
      100.0 * static_cast<double>(outcome.lateTicks) /
          static_cast<double>(std::max<std::int64_t>(outcome.ticks, 1)),
      outcome.wakeUp.median_us, outcome.wakeUp.p99_us, outcome.wakeUp.p999_us, outcome.wakeUp.max_us,
      outcome.duration.p99_us);
  std::printf("  wake-up delays:");
  double edge_us = 50.0;
  std::int64_t sum = 0;
  for (const auto& [to_us, count] : outcome.delays) {
    while (to_us > edge_us && edge_us < 2.0 * kTick_us) {
      std::printf(" <=%.0f us %lld,", edge_us, static_cast<long long>(sum));
      edge_us *= 2.0, sum = 0;
    }
    sum += count;
  }
  std::printf(" rest %lld\n", static_cast<long long>(sum));
  if (&outcome != &still && still.wakeUp.p99_us > 0.0) {
    std::printf("  against no picture: wake-up p99 x %.2f, late ticks %+lld\n",
                outcome.wakeUp.p99_us / still.wakeUp.p99_us,
                static_cast<long long>(outcome.lateTicks - still.lateTicks));
  }
}

Options parse(const QStringList& arguments) {
  QCommandLineParser parser;
  for (const char* name : {"seconds", "size", "organ", "triangles", "level", "pictures"}) {
    parser.addOption(QCommandLineOption(QLatin1String(name), QString(), QLatin1String(name)));
  }
  parser.addOption(QCommandLineOption(QStringLiteral("smoke")));
  parser.addOption(QCommandLineOption(QStringLiteral("parts")));
  parser.process(arguments);
  Options options;
  const auto value = [&](const char* name) { return parser.value(QLatin1String(name)); };
  options.smoke = parser.isSet(QStringLiteral("smoke"));
  options.parts = parser.isSet(QStringLiteral("parts"));
  if (options.smoke) {
    options.seconds = 1.0, options.size = {480, 320};
  }
  if (parser.isSet(QStringLiteral("seconds"))) {
    options.seconds = std::max(0.5, value("seconds").toDouble());
  }
  const QStringList sides = value("size").split(QLatin1Char('x'));
  if (sides.size() == 2) {
    options.size = QSize(sides[0].toInt(), sides[1].toInt());
  }
  if (parser.isSet(QStringLiteral("organ"))) {
    options.organ = value("organ").toStdString();
  }
  options.triangles = value("triangles").toInt();
  for (const RenderQuality level : {RenderQuality::kFast, RenderQuality::kFine, RenderQuality::kBest}) {
    if (value("level") == QLatin1String(nameOf(level))) {
      options.levels = {level};
    }
  }
  options.pictures = value("pictures");
  return options;
}

double now_us() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return 1e6 * static_cast<double>(used.tv_sec) + 1e-3 * static_cast<double>(used.tv_nsec);
}

/// Prints the processor's work for a frame before the scene graph, in us of processor time, medians: vertex
/// positions; view frame and normals; colours; the buffer for the graphics card. And what is left of all that
/// where a vertex shader deforms the organ: the rows of its sections, and the vertices of its shadow.
void measureParts(const std::shared_ptr<const Scene>& scene) {
  constexpr int kRepeats = 101;
  constexpr std::size_t kShadowVertices = 1200;  // as SceneView
  ViewScene view = makeViewScene(scene);
  OrganGeometry geometry;
  geometry.setSurface(view.surface, view.skin.get());
  std::vector<Vec3> moved_m(scene->mesh.vertices_m.size());
  std::vector<std::array<float, 3>> colours(moved_m.size());
  std::array<std::vector<double>, 5> parts_us;
  for (int i = 0; i < kRepeats; ++i) {
    const double most_rad =
        scene->hollow ? scene->hollow->detorsion().start.most_rad : scene->pattern.targetAngle_rad;
    const OrganState state = scene->stateAt(most_rad * (1.0 - 0.001 * i));
    double at_us = now_us();
    const auto note = [&](std::size_t part) {
      const double then_us = now_us();
      parts_us[part].push_back(then_us - at_us);
      at_us = then_us;
    };
    view.deform(state, moved_m);
    note(0);
    view.surface.update(moved_m);
    note(1);
    if (!view.blood.empty()) {
      view.blood.evaluate(state, colours);
      view.surface.paint(colours);
    }
    note(2);
    geometry.updateVertices(view.surface);
    note(3);
    if (view.shader) {
      view.shader->update(state);
      const std::size_t step = std::max<std::size_t>(1, moved_m.size() / kShadowVertices);
      for (std::size_t v = 0; v < moved_m.size(); v += step) {
        view.surface.place(static_cast<std::uint32_t>(v), view.shader->place_m(static_cast<std::uint32_t>(v)),
                           {});
      }
    }
    note(4);
  }
  std::printf("%-24s", scene->id.c_str());
  for (std::vector<double>& part_us : parts_us) {
    std::sort(part_us.begin(), part_us.end());
    std::printf(" %8.1f", quantile(part_us, 0.5));
  }
  std::printf("\n");
}

bool drawFor(SceneView& view, double seconds) {
  QElapsedTimer clock;
  clock.start();
  const std::int64_t before = view.framesDrawn();
  const auto over = [&] {
    const double now_s = static_cast<double>(clock.elapsed()) * 1e-3;
    return now_s > kPatience_s || (now_s > seconds && view.framesDrawn() > before + 3);
  };
  while (!over()) {
    view.redraw();
    wait();
  }
  return view.framesDrawn() > before;
}

int bench(const Options& options) {
  if (options.parts) {
    std::printf("us of the processor a frame    places  normals  colours   buffer   by shader\n");
    measureParts(sceneOf(options));
    return 0;
  }
  const std::shared_ptr<const Scene> scene = sceneOf(options);
  SceneView view;
  view.resize(options.size);
  view.setTheme(theme(ThemeKind::kLight));
  view.setInstrument(loadInstrument(std::filesystem::path(TORSIO_SOURCE_DIR) / "assets", "grasper"));
  view.setScene(makeViewScene(scene));
  QTimer pulse;  // ends each wait
  pulse.start(kPulse_ms);
  const Outcome still = measure(scene, nullptr, options.seconds);
  bool sound = still.ticks > 0;
  std::printf("%s, %zu triangles, %d x %d, %.0f s a level\n", scene->id.c_str(), scene->mesh.triangles.size(),
              options.size.width(), options.size.height(), options.seconds);
  print("no picture", still, still);
  view.show();
  for (const RenderQuality level : options.levels) {
    view.setQuality(level);
    sound = drawFor(view, options.smoke ? 0.0 : kWarmUp_s) && sound;
    const Outcome outcome = measure(scene, &view, options.seconds);
    print(nameOf(level), outcome, still);
    if (!options.pictures.isEmpty() &&
        !view.picture().save(QDir(options.pictures).filePath(QLatin1String(nameOf(level)) + ".png"))) {
      std::fputs("a picture could not be saved\n", stderr);
      return 1;
    }
    sound = sound && outcome.ticks > 0 && !outcome.frames_ms.empty();
  }
  std::printf("\nrenderer: %s\n", view.renderer().toUtf8().constData());
  return sound || !options.smoke ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  SceneView::prepareGraphics();
  const QApplication application(argc, argv);
  if (!SceneView::platformCanRender()) {
    std::fputs("this display cannot draw the scene; run it through xvfb-run\n", stderr);
    return 2;
  }
  try {
    return bench(parse(QApplication::arguments()));
  } catch (const Error& error) {
    std::fprintf(stderr, "%s: %s\n", error.where().c_str(), error.what());
    return 1;
  }
}
