// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/program/screenshot.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QGuiApplication>
#include <QPixmap>
#include <QTimer>

#include "app/gui/simulator/posed_states.h"
#include "app/gui/simulator/replay_bar.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/picture.h"
#include "app/services/recording/recorded_run.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/device/virtual/pointer_device.h"

namespace torsio::gui {

namespace {

constexpr int kPatience_ms = 120'000;
constexpr int kSettlingFrames = 3;  // quality and textures take effect after the second
constexpr double kSwing_rad_per_s = 1.5;
constexpr int kPulse_ms = 5;
constexpr double kWarmUp_s = 2.0;

/// Runs the event loop until `done`; throws on timeout.
template <typename Condition>
void waitUntil(const Condition& done, const char* what) {
  QElapsedTimer waited;
  waited.start();
  while (!done()) {
    QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 50);
    if (waited.elapsed() > kPatience_ms) {
      throw Error(ErrorCode::kDevice, Text::tr("gave up waiting for %1", what),
                  QGuiApplication::platformName().toStdString(), Text::tr("Try again on a faster display"));
    }
  }
}

void requireDisplay() {
  if (SceneView::platformCanRender()) {
    return;
  }
  throw Error(ErrorCode::kDevice, Text::tr("this display cannot draw the scene: it has no OpenGL"),
              Text::tr("platform %1", QGuiApplication::platformName().toStdString()),
              Text::tr("Run it on a desktop, or through xvfb-run with QT_QPA_PLATFORM=xcb"));
}

/// The window with the requested organ, drawn at least once.
struct Stage {
  Stage(const WindowSetup& setup, const ScreenshotRequest& request)
      : window(setup), view(child<SceneView>(window, "view")) {
    LoadedScene loaded = setup.loader(request.scene);
    window.resize(request.size);
    view.setQuality(request.quality);
    view.setLattice(request.lattice);
    view.setWireframe(request.wireframe);
    view.setShearVisible(request.shear);
    view.setMarkersVisible(request.markers);
    window.show();
    window.controller().adopt(request.scene, std::move(loaded));
    if (request.ghost) {
      const Scene& scene = *window.controller().scene();
      view.setGhost(scene.stateAt(window.controller().target_rad()));
    }
    view.camera().orbit({-request.orbit_deg / OrbitCamera::kDegreesPerPixel, 0.0});
    view.camera().zoom(request.zoom);
    view.applyCamera();
    waitUntil([this] { return view.framesDrawn() > 0; }, "the first frame");
  }
  SimulatorWindow window;
  SceneView& view;
};

void settle(SimulatorWindow& window) {
  SceneView& view = child<SceneView>(window, "view");
  const std::int64_t before = view.framesDrawn();
  waitUntil(
      [&] {
        view.redraw();
        return view.framesDrawn() >= before + kSettlingFrames;
      },
      "the picture");
}

double angleOf(const ScreenshotRequest& request, SimulatorWindow& window) {
  const Scene& scene = *window.controller().scene();
  const double target_rad = usualAngle_rad(scene);
  const double angle_rad = request.angle_rad.value_or(target_rad);
  if (scene.rod && angle_rad * target_rad < 0.0) {
    throw Error(ErrorCode::kBadParameter, Text::tr("this task turns the other way"),
                Text::tr("--angle %1, target %2", std::to_string(std::lround(degrees(angle_rad))),
                         std::to_string(std::lround(degrees(target_rad)))),
                Text::tr("Give an angle with the sign of the target"));
  }
  return angle_rad;
}

}  // namespace

void takeScreenshot(const WindowSetup& setup, const ScreenshotRequest& request) {
  requireDisplay();
  Stage stage(setup, request);
  SimulatorWindow& window = stage.window;
  if (request.strip) {
    settle(window);
    writePicture(filmStrip(stripRows(captureStrip(child<SceneView>(window, "view"),
                                                  *window.controller().scene(), angleOf(request, window)))),
                 request.file);
    return;
  }
  if (request.sides) {
    settle(window);
    writePicture(filmStrip(captureSides(child<SceneView>(window, "view"), *window.controller().scene(),
                                        angleOf(request, window)),
                           kSideFrame),
                 request.file);
    return;
  }
  LiveState held = scriptedTwist(*window.controller().scene(), angleOf(request, window));
  held.targetAngle_rad = window.controller().target_rad();  // the exercise's target
  window.controller().freeze(held);
  settle(window);
  writePicture(request.sceneOnly ? child<SceneView>(window, "view").picture() : window.grab().toImage(),
               request.file);
}

FrameRate measureFrameRate(const WindowSetup& setup, const ScreenshotRequest& request, double seconds) {
  requireDisplay();
  Stage stage(setup, request);
  SimulatorWindow& window = stage.window;
  SimulationController& controller = window.controller();
  LiveState state = scriptedTwist(*controller.scene(), angleOf(request, window));
  const double widest_rad = state.response.angle_rad;
  // The window shows scripted states, so that every machine draws the same; the servo runs alongside.
  Pose parked;
  parked.position_m = controller.parkingPoint_m();
  RecordedRun servo(controller.sharedScene(), std::make_unique<PointerDevice>(parked), {}, nullptr);
  servo.start();
  FrameRate rate;
  // Ends each wait; with a timeout, Qt would busy-wait and take the processor from the renderer.
  QTimer pulse;
  pulse.start(kPulse_ms);
  QElapsedTimer clock;
  clock.start();
  std::int64_t firstFrame = 0;
  LiveState begun;
  double begun_s = -1.0;
  while (begun_s < 0.0 || static_cast<double>(clock.elapsed()) * 1e-3 < begun_s + seconds) {
    const double now_s = static_cast<double>(clock.elapsed()) * 1e-3;
    const LiveState& live = servo.latest();
    if (begun_s < 0.0 && now_s > kWarmUp_s) {
      begun_s = now_s;
      firstFrame = child<SceneView>(window, "view").framesDrawn();
      begun = live;
    }
    if (begun_s >= 0.0) {
      rate.slowestTick_us = std::max(rate.slowestTick_us, live.tickDuration_us);
    }
    const OrganState swung = controller.scene()->stateAt(widest_rad * std::sin(kSwing_rad_per_s * now_s));
    state.response.angle_rad = swung.twist.graspAngle_rad;
    state.pose = swung.pose;
    controller.freeze(state);
    QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
  }
  const double span_s = static_cast<double>(clock.elapsed()) * 1e-3 - begun_s;
  rate.frames_per_s =
      static_cast<double>(child<SceneView>(window, "view").framesDrawn() - firstFrame) / span_s;
  rate.ticks = servo.latest().tick - begun.tick;
  rate.lateTicks = servo.latest().lateTicks - begun.lateTicks;
  return rate;
}

}  // namespace torsio::gui
