// SPDX-License-Identifier: GPL-3.0-or-later
// The shipped hollow organs: set-up of their tables, one look-up of a wrung tube, and the torque and slope of
// a servo tick over all spans. Medians over batches of queries at angles and pressures in random order, in
// processor time, which is independent of other load. Exit code 1 if a target is missed: set-up 1 s, torque
// with slope 300 ns. Then the nearest surface of the twisted organ, with the bounds of its map compared with
// the general assumption of DeformedSurface, alternating over the same places. Then the view of each scene,
// whole frames against the triad over the bytes of vertices read and written (without padding), and the
// kernels alone over 4,000 and 100,000 vertices; target: half of the triad. Run from the repository's root.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/random.h"
#include "sim/scene/hollow_map.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/hollow_view.h"
#include "sim/scene/scene.h"
#include "sim/tissue/view/twist_kernels.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

constexpr double kSetUpTarget_ms = 1000.0;
constexpr double kQueryTarget_ns = 300.0;

double processor_ns() {
  return static_cast<double>(std::clock()) * (1e9 / static_cast<double>(CLOCKS_PER_SEC));
}

double now_ns() {
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<double>(std::chrono::duration_cast<std::chrono::nanoseconds>(time).count());
}

/// Returns the median time of `query(angle, fraction of the pressure)`.
template <typename Query>
double median_ns(const Query& query) {
  constexpr int kBatches = 201;
  constexpr int kQueries = 2000;
  std::vector<double> times_ns;
  double sum = 0.0;
  unsigned state = 1;
  for (int batch = 0; batch < kBatches; ++batch) {
    const double start = processor_ns();
    for (int k = 0; k < kQueries; ++k) {
      state = state * 1664525U + 1013904223U;
      const double share = static_cast<double>(state >> 8U) / 16777216.0;
      sum += query(4.0 * share, 1.0 - share);
    }
    times_ns.push_back((processor_ns() - start) / kQueries);
  }
  std::nth_element(times_ns.begin(), times_ns.begin() + kBatches / 2, times_ns.end());
  return sum != 0.0 ? times_ns[kBatches / 2] : 0.0;
}

SceneRequest requestOf(const std::string& id) {
  SceneRequest request = testing::shippedRequest(id, "detorse");
  return request;
}

bool measure(const std::string& id) {
  const Scene scene = loadScene(requestOf(id));
  const HollowOrgan::Parts parts{.lattice = &scene.lattice(),
                                 .shearModulus_Pa = scene.model.material().shearModulus_Pa,
                                 .graspArc = scene.pattern.graspArc,
                                 .detorsion = *scene.pattern.detorsion,
                                 .vertices_m = scene.mesh.vertices_m,
                                 .patches = &scene.collision.patches()};
  const double begun = processor_ns();
  const HollowOrgan organ(parts);
  const double setUp_ms = 1e-6 * (processor_ns() - begun);
  const double pressure_Pa = organ.detorsion().wall.pressure_Pa;
  const double torque_ns = median_ns(
      [&](double angle_rad, double share) { return organ.torque_Nm(angle_rad, share * pressure_Pa); });
  const double slope_ns = median_ns(
      [&](double angle_rad, double share) { return organ.slope_Nm_per_rad(angle_rad, share * pressure_Pa); });
  const bool met = setUp_ms <= kSetUpTarget_ms && torque_ns + slope_ns <= kQueryTarget_ns;
  std::printf("%-24s set-up %6.1f ms   torque %5.1f ns   with its slope %5.1f ns   %s\n", id.c_str(),
              setUp_ms, torque_ns, torque_ns + slope_ns, met ? "ok" : "over the target");
  return met;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Prints the time to find the nearest point to a tip and to a shaft within 20 mm of the organ's surface at
/// its largest twist, with either bound, and how often the assumed one misses it.
void measureNearestSurface(const std::string& id) {
  constexpr int kPlaces = 4000;
  const Scene scene = loadScene(requestOf(id));
  const OrganState lies = scene.stateAt(scene.hollow->detorsion().start.most_rad);
  const HollowMap map(scene.lattice(), *scene.hollow, lies);
  Random random(5);
  const auto way = [&random] { return normalized(Vec3{random.normal(), random.normal(), random.normal()}); };
  std::vector<double> assumed_ns;
  std::vector<double> bounded_ns;
  int missed = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const auto vertex = static_cast<std::size_t>(random.bounded(scene.mesh.vertices_m.size()));
    const Vec3 from_m = map.vertex(scene.hollow->vertices()[vertex]) + way() * (0.020 * random.uniform());
    const Vec3 to_m = from_m + (i % 2 == 0 ? Vec3{} : 0.1 * way());
    const auto ask = [&](bool bounded, std::vector<double>& times_ns) {
      const double begun = now_ns();
      const WrungSurface moved{HollowMap(scene.lattice(), *scene.hollow, lies), *scene.hollow};
      DeformedSurface surface(scene.collision.patches(), moved.places(),
                              bounded ? moved.bounds() : PieceBounds{});
      const SegmentHit hit = surface.nearest({from_m, to_m}, 0.030);
      times_ns.push_back(now_ns() - begun);
      return std::abs(hit.surface.distance_m);
    };
    const double assumed_m = ask(false, assumed_ns);
    missed += ask(true, bounded_ns) < assumed_m - 1e-12 ? 1 : 0;
  }
  std::printf(
      "%-24s nearest surface: assumed stretch %6.1f us, missed %d of %d; bounds of the map %6.1f us\n",
      id.c_str(), 1e-3 * median(assumed_ns), missed, kPlaces, 1e-3 * median(bounded_ns));
}

/// Prints the time of work, and its ratio to the triad over as many bytes: medians of alternating pairs.
void beside(const std::string& name, Isa isa, std::size_t bytes, const std::function<void()>& work) {
  constexpr int kRepeats = 301;
  const std::size_t count = bytes / (3 * sizeof(float));
  const KernelBuffer<float> a(count);
  const KernelBuffer<float> b(count, 32);
  KernelBuffer<float> c(count, 64);
  std::vector<double> ratios;
  std::vector<double> times_ns;
  for (int i = 0; i < kRepeats; ++i) {
    const double begun = now_ns();
    twistKernels(isa).triad(a.data(), b.data(), 0.5F, static_cast<int>(count), c.data());
    const double between = now_ns();
    work();
    const double done = now_ns();
    ratios.push_back((between - begun) / (done - between));
    times_ns.push_back(done - between);
  }
  std::printf("%-33s %-8s %5zu kB %8.1f us   of the triad %5.2f\n", name.c_str(), isaName(isa).data(),
              bytes / 1000, 1e-3 * median(times_ns), median(ratios));
}

void drawScene(const std::string& id) {
  const auto scene = std::make_shared<const Scene>(loadScene(requestOf(id)));
  const OrganState state = scene->stateAt(scene->hollow->detorsion().start.least_rad);
  std::vector<Vec3> drawn_m(scene->mesh.vertices_m.size());
  const double begun = now_ns();
  scene->deform(state, drawn_m);
  const double double_us = 1e-3 * (now_ns() - begun);
  const HollowOrgan& organ = *scene->hollow;
  const double pressure_Pa = organ.detorsion().wall.pressure_Pa;
  const double most_rad = organ.detorsion().start.most_rad;
  const double closing_rad = std::min(organ.closing_rad(pressure_Pa), most_rad);
  for (const Isa isa : usableIsas()) {
    HollowView view(scene, isa);
    for (const auto& [name, angle_rad] : {std::pair{"least", organ.detorsion().start.least_rad},
                                          {"closing", closing_rad},
                                          {"most", most_rad}}) {
      const OrganState turned[] = {scene->stateAt(angle_rad), scene->stateAt(0.99 * angle_rad)};
      int frame = 0;
      beside(id + ", " + name, isa, view.bytesAFrame(), [&] { view.updateBlocks(turned[++frame % 2]); });
    }
  }
  HollowView view(scene);
  std::vector<double> times_ns;
  for (int i = 0; i < 301; ++i) {
    const double start = now_ns();
    view.deform(state, drawn_m);
    times_ns.push_back(now_ns() - start);
  }
  std::printf("%-24s %zu vertices: written in the order of the mesh %.1f us; the double path %.1f us\n",
              id.c_str(), drawn_m.size(), 1e-3 * median(times_ns), double_us);
}

void drawTube(Isa isa, bool wound, std::size_t blocks) {
  constexpr std::size_t kCells = 63;
  const std::size_t streams = wound ? 12 : 15;
  KernelBuffer<float> in(blocks * streams * 16);
  for (std::size_t i = 0; i < in.size(); ++i) {
    in[i] = static_cast<float>(i % 97) * 0.01F;
  }
  KernelBuffer<float> out(blocks * 3 * 16, 32);
  constexpr float kCell[] = {1.2F,  0.02F, 0.0F, 0.8F,  0.01F, 0.0F, 0.2F,
                             0.01F, 0.0F,  0.7F, 0.02F, 0.0F,  1.0F};
  KernelBuffer<float> cells(std::size(kCell) * kHollowRow);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    cells[k] = kCell[k / kHollowRow];
  }
  std::vector<int> first;
  for (std::size_t k = 0; k < blocks; ++k) {
    first.push_back(static_cast<int>(k * kCells / blocks));
  }
  const HollowFrame frame{cells.data(), 3.0F, {}, {0.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};
  const TwistKernels& kernels = twistKernels(isa);
  beside(wound ? "wound limbs" : "own axes", isa, blocks * 16 * (streams + 3) * sizeof(float), [&] {
    (wound ? kernels.hollowWound : kernels.hollowOwn)(in.data(), first.data(), static_cast<int>(blocks),
                                                      frame, out.data());
  });
}

}  // namespace
}  // namespace torsio

int main() {
  constexpr const char* kScenes[] = {"gastric-mesentero-axial", "midgut", "sigmoid", "small-bowel-loop",
                                     "testis"};
  bool met = true;
  for (const char* id : kScenes) {
    met = torsio::measure(id) && met;
  }
  for (const char* id : kScenes) {
    torsio::measureNearestSurface(id);
  }
  for (const torsio::Isa isa : torsio::usableIsas()) {
    for (const std::size_t blocks : {250U, 6250U}) {  // 4,000 vertices fit into the second-level cache
      torsio::drawTube(isa, false, blocks);
      torsio::drawTube(isa, true, blocks);
    }
  }
  for (const char* id : kScenes) {
    torsio::drawScene(id);
  }
  return met ? 0 : 1;
}
