// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of the compared models on the shipped forearm, 36 ridges and 37 sections: the cost of a frame of
// finite elements and springs in frames of the twist model. Prints the machine's load.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "app/services/comparison/comparison_run.h"
#include "sim/baseline/lattice_update.h"
#include "sim/baseline/twist_simulation.h"
#include "sim/scene/scene.h"
#include "sim/tissue/view/cpu_features.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

constexpr double kLatticeTarget = 10'000.0;
constexpr double kViewTarget = 500.0;

double medianFrame_s(TwistSimulation& model, double torque_Nm, int frames) {
  std::vector<double> times_s;
  for (int frame = 1; frame <= frames; ++frame) {
    const auto start = std::chrono::steady_clock::now();
    model.step(torque_Nm * frame / frames);
    times_s.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(times_s.begin(), times_s.end());
  return times_s[times_s.size() / 2];
}

int run() {
  SceneRequest request = testing::shippedRequest();
  request.ridges = 36;
  request.sections = 37;
  const Scene scene = loadScene(request);
  const TwistModel twist(scene.mesh, scene.lattice(), scene.model.material(), {});
  const double torque_Nm = 1.0 / twist.graspCompliance(scene.lattice().length_m());
  ComparedOrgan organ{&scene.mesh, &scene.lattice(), {scene.model.material().shearModulus_Pa, 0.45}, {}, {}};
  organ.dynamics.drag_per_s = criticalDrag_per_s(organ.constants, 1000.0, scene.lattice().length_m());
  const auto view = twistModelSimulation(organ, twist, bestIsa());
  const auto elements = finiteElementSimulation(organ, 4);
  const auto springs = massSpringSimulation(organ, twist, 4, {});

  const double lattice_s = latticeUpdateTime_s(twist, bestIsa());
  const double view_s = medianFrame_s(*view, torque_Nm, 501);
  const double elements_s = medianFrame_s(*elements, torque_Nm, 61);
  const double springs_s = medianFrame_s(*springs, torque_Nm, 61);

  const MachineFacts machine = machineFacts();
  std::printf("%s, %d cores, load %.2f, view %s, %s\n", machine.processor.c_str(), machine.cores,
              machine.loadAverage, std::string(isaName(bestIsa())).c_str(), machine.flags.c_str());
  std::printf("lattice update %.2f us, view of %zu vertices %.1f us, elements %.1f ms, springs %.1f ms\n",
              1e6 * lattice_s, scene.mesh.vertices_m.size(), 1e6 * view_s, 1e3 * elements_s, 1e3 * springs_s);
  const auto tell = [](const char* name, double ratio, double target) {
    std::printf("%-40s %8.0f  at least %.0f: %s\n", name, ratio, target, ratio >= target ? "met" : "MISSED");
    return ratio >= target;
  };
  bool met = tell("elements over lattice update", elements_s / lattice_s, kLatticeTarget);
  met = tell("elements over whole view", elements_s / view_s, kViewTarget) && met;
  met = tell("springs over whole view", springs_s / view_s, kViewTarget) && met;
  return met ? 0 : 1;
}

}  // namespace
}  // namespace torsio

int main() {
  return torsio::run();
}
