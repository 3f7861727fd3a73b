// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include <QCoreApplication>
#include <QElapsedTimer>

#include "app/gui/simulator/simulation_controller.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio::gui::testing {

inline SceneRequest requestFor(const std::string& id) {
  SceneRequest request;
  request.id = id;
  return request;
}

/// The straight bar of the servo tests as a scene for the window. Keeps `formulation` and `pattern`, so that
/// a choice is visible.
inline LoadedScene loadBar(const SceneRequest& request) {
  LoadedScene loaded;
  Scene scene = barScene();
  if (!request.id.empty()) {
    scene.id = request.id;
  }
  if (!request.pattern.empty()) {
    scene.pattern.id = request.pattern;
  }
  scene.tissue = request.tissue;
  loaded.scene = std::make_shared<const Scene>(std::move(scene));
  loaded.view = makeViewScene(loaded.scene);
  loaded.shape = showAsyncShape(*loaded.scene, loaded.view);
  return loaded;
}

/// Runs the event loop until `done`, for loads in a worker thread; false after twenty seconds.
template <typename Condition>
bool eventually(const Condition& done) {
  QElapsedTimer waited;
  waited.start();
  while (!done() && waited.elapsed() < 20'000) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
  }
  return done();
}

}  // namespace torsio::gui::testing
