// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/twist_bench.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <functional>

#include "sim/core/contracts.h"
#include "sim/core/portable_math.h"
#include "sim/tissue/twist/twist_bench_platform.h"
#include "sim/tissue/twist/twist_model_view.h"
#include "sim/tissue/view/twist_kernels.h"
#include "sim/tissue/view/twist_kernels_buffer.h"

namespace torsio {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kRingPoints = 200;
constexpr double kOrganRadius_m = 0.04;
constexpr double kOrganBend_m = 0.12;
constexpr double kOrganTurn_rad = 2.0;
constexpr int kQueriesABatch = 1000;
constexpr int kBatches = 51;
constexpr int kSingleQueries = 20000;
// Targets (docs/model.md, "Speed").
constexpr double kLatticeTarget = 0.90;
constexpr double kVertexTarget = 0.75;
constexpr double kPortableTarget = 0.25;
constexpr double kDoubleTarget = 0.80;
constexpr double kComponentTarget = 8.0;
constexpr double kQueryTarget_ns = 100.0;
constexpr double kQueryTailTarget_us = 5.0;
constexpr double kSetUpTarget_s = 2.0;

double seconds(const std::function<void()>& work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
  TORSIO_EXPECTS(!values.empty());
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Pair {
  double ratio = 0.0;   // yardstick time over work time, median of pairs
  double work_s = 0.0;  // median
};

// Measured in turn, so that what else happens on the machine meets both alike.
Pair compare(int repeats, const std::function<void()>& yardstick, const std::function<void()>& work) {
  yardstick();
  work();
  std::vector<double> ratios;
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    const double a = seconds(yardstick);
    const double b = seconds(work);
    ratios.push_back(a / b);
    times.push_back(b);
  }
  return {median(ratios), median(times)};
}

/// The STREAM triad over `bytes` of memory in three arrays, whose starts are staggered.
class Triad {
 public:
  Triad(std::size_t bytes, Isa isa) : isa_(isa), count_(static_cast<int>(bytes / (3 * sizeof(float)))) {
    const std::size_t n = static_cast<std::size_t>(count_);
    a_ = KernelBuffer<float>(n);
    b_ = KernelBuffer<float>(n, 32);
    c_ = KernelBuffer<float>(n, 64);
  }
  void operator()() { twistKernels(isa_).triad(a_.data(), b_.data(), 0.5F, count_, c_.data()); }

 private:
  Isa isa_;
  int count_ = 0;
  KernelBuffer<float> a_;
  KernelBuffer<float> b_;
  KernelBuffer<float> c_;
};

/// A bent, tapering tube with flat ends.
TriangleMesh benchOrgan(int vertices) {
  const int rings = std::max(8, vertices / kRingPoints);
  TriangleMesh mesh;
  const auto index = [](int ring, int point) {
    return static_cast<std::uint32_t>(ring * kRingPoints + point);
  };
  Vec3 ends[2];
  for (int ring = 0; ring < rings; ++ring) {
    const double along = static_cast<double>(ring) / (rings - 1);
    const SinCos turn = portableSinCos(kOrganTurn_rad * along);
    const Vec3 centre{kOrganBend_m * (1.0 - turn.cos), 0.0, kOrganBend_m * turn.sin};
    const Vec3 outwards{turn.cos, 0.0, -turn.sin};
    if (ring == 0 || ring == rings - 1) {
      ends[ring == 0 ? 0 : 1] = centre;
    }
    const double radius = kOrganRadius_m * (1.0 - 0.4 * along);
    for (int point = 0; point < kRingPoints; ++point) {
      const SinCos a = portableSinCos(2.0 * kPi * point / kRingPoints);
      mesh.vertices_m.push_back(centre + (1.2 * radius * a.cos) * outwards +
                                (0.9 * radius * a.sin) * Vec3{0, 1, 0});
    }
  }
  for (int ring = 0; ring + 1 < rings; ++ring) {
    for (int point = 0; point < kRingPoints; ++point) {
      const int next = (point + 1) % kRingPoints;
      mesh.triangles.push_back({index(ring, point), index(ring, next), index(ring + 1, next)});
      mesh.triangles.push_back({index(ring, point), index(ring + 1, next), index(ring + 1, point)});
    }
  }
  for (const int end : {0, 1}) {
    const std::uint32_t middle = static_cast<std::uint32_t>(mesh.vertices_m.size());
    mesh.vertices_m.push_back(ends[end]);
    for (int point = 0; point < kRingPoints; ++point) {
      const int next = (point + 1) % kRingPoints;
      const int ring = end == 0 ? 0 : rings - 1;
      if (end == 0) {
        mesh.triangles.push_back({middle, index(ring, next), index(ring, point)});
      }
      if (end == 1) {
        mesh.triangles.push_back({middle, index(ring, point), index(ring, next)});
      }
    }
  }
  return mesh;
}

TwistModel benchModel(const TriangleMesh& mesh, const TissueBenchOptions& options) {
  LatticeOptions lattice;
  lattice.ridges = options.ridges;
  lattice.sections = options.sections;
  lattice.fixedEnd_m = mesh.vertices_m[mesh.vertices_m.size() - 2];
  lattice.freeEnd_m = mesh.vertices_m.back();
  return {mesh, SectionLattice(mesh, lattice), Material{}, {}};
}

void addLattices(TissueBenchResult& result, const TissueBenchOptions& options, Isa isa) {
  const int blocks = (options.ridges + kKernelBlock - 1) / kKernelBlock;
  const std::size_t numbers =
      static_cast<std::size_t>(3 * kKernelBlock) * static_cast<std::size_t>(blocks * options.sections);
  const std::size_t moves = 12 * static_cast<std::size_t>(options.sections);
  const TwistKernels& kernels = twistKernels(isa);
  {
    KernelBuffer<float> in(numbers);
    KernelBuffer<float> out(numbers, 32);
    KernelBuffer<float> motions(moves);
    Triad triad(2 * numbers * sizeof(float), isa);
    const Pair pair = compare(options.repeats, std::ref(triad), [&] {
      kernels.lattice(in.data(), options.sections, blocks, motions.data(), out.data());
    });
    result.rows.push_back({"lattice_over_triad", pair.ratio, "1", kLatticeTarget});
    result.rows.push_back({"lattice_update", 1e6 * pair.work_s, "us"});
  }
  KernelBuffer<double> in(numbers);
  KernelBuffer<double> out(numbers, 16);
  KernelBuffer<double> motions(moves);
  Triad triad(2 * numbers * sizeof(double), isa);
  const Pair pair = compare(options.repeats, std::ref(triad), [&] {
    kernels.latticeDouble(in.data(), options.sections, blocks, motions.data(), out.data());
  });
  result.rows.push_back({"double_lattice_over_triad", pair.ratio, "1", kDoubleTarget});
}

void addVertices(TissueBenchResult& result, const TissueBenchOptions& options, const TwistModel& model,
                 Isa isa) {
  const TwistState state{0.7 * model.lattice().length_m(), 2.0};
  TwistView view(model, isa);
  TwistView portable(model, Isa::kPortable);
  // 11 streams in and 3 out (twist_kernels.h).
  const std::size_t bytes = static_cast<std::size_t>(view.vertices()) * 14 * sizeof(float);
  Triad triad(bytes, isa);
  const Pair wide = compare(options.repeats, std::ref(triad), [&] { (void)view.updateBlocks(state); });
  const Pair narrow = compare(options.repeats, std::ref(triad), [&] { (void)portable.updateBlocks(state); });
  result.rows.push_back({"vertices_over_triad", wide.ratio, "1", kVertexTarget});
  result.rows.push_back({"vertices_portable_over_triad", narrow.ratio, "1", kPortableTarget});
  result.rows.push_back({"vertices_update", 1e6 * wide.work_s, "us"});
  std::vector<float> xyz(3 * static_cast<std::size_t>(view.vertices()));
  const Pair whole = compare(options.repeats, std::ref(triad), [&] { view.update(state, xyz); });
  result.rows.push_back({"view_frame", 1e6 * whole.work_s, "us"});
}

// The paper's way, in every frame: Eqs. 21-23 at all key points, then Eq. 15 at all vertices with eight
// weights along the ridge, two ridges, three components. The weights are known beforehand.
void addComponents(TissueBenchResult& result, const TissueBenchOptions& options, const TwistModel& model,
                   Isa isa) {
  const SectionLattice& lattice = model.lattice();
  const std::size_t count = lattice.vertexCoordinates().size();
  std::vector<double> arcs;
  arcs.reserve(static_cast<std::size_t>(lattice.sections()));
  for (int j = 0; j < lattice.sections(); ++j) {
    arcs.push_back(lattice.sectionArc_m(j));
  }
  std::vector<double> queries;
  for (const LatticeCoordinate& c : lattice.vertexCoordinates()) {
    queries.push_back(c.arc_m);
  }
  const KrigingTable table(Kriging1d(arcs, model.options().kriging), queries);
  if (table.width() != 8) {
    return;
  }
  std::vector<float> weights(table.lambda().begin(), table.lambda().end());
  std::vector<int> first(count);
  std::vector<int> firstNext(count);
  std::vector<float> share(count);
  for (std::size_t v = 0; v < count; ++v) {
    const double place = lattice.vertexCoordinates()[v].angle_rad * lattice.ridges() / (2.0 * kPi);
    const int ridge = std::min(static_cast<int>(place), lattice.ridges() - 1);
    const int next = (ridge + 1) % lattice.ridges();
    first[v] = ridge * lattice.sections() + table.first()[v];
    firstNext[v] = next * lattice.sections() + table.first()[v];
    share[v] = static_cast<float>(place - ridge);
  }
  const std::size_t keys =
      static_cast<std::size_t>(lattice.ridges()) * static_cast<std::size_t>(lattice.sections());
  std::vector<float> displacements(4 * keys);
  std::vector<float> keyUnits(3 * keys);  // -Y, X, lift of each key point, [ridge][section]
  for (std::size_t k = 0; k < keys; ++k) {
    const int key = static_cast<int>(k);
    const Vec3 place = lattice.keyPoint_m(key / lattice.sections(), key % lattice.sections());
    keyUnits[3 * k] = static_cast<float>(-place.y);
    keyUnits[3 * k + 1] = static_cast<float>(place.x);
    keyUnits[3 * k + 2] = 0.001F;
  }
  std::vector<float> rest(3 * count, 0.1F);
  std::vector<float> out(3 * count);
  KrigedComponents components;
  components.weights = weights.data();
  components.first = first.data();
  components.firstNext = firstNext.data();
  components.share = share.data();
  components.displacements = displacements.data();
  components.rest = rest.data();
  TwistView view(model, isa);
  const TwistState state{0.7 * lattice.length_m(), 2.0};
  const Pair pair = compare(
      options.repeats,
      [&] {
        for (std::size_t k = 0; k < keys; ++k) {
          const float angle = 0.01F * static_cast<float>(k % arcs.size());
          displacements[4 * k] = angle * keyUnits[3 * k];
          displacements[4 * k + 1] = angle * keyUnits[3 * k + 1];
          displacements[4 * k + 2] = keyUnits[3 * k + 2];
        }
        twistKernels(isa).componentKriging(components, static_cast<int>(count), out.data());
      },
      [&] { (void)view.updateBlocks(state); });
  result.rows.push_back({"precomputed_over_live_kriging", pair.ratio, "1", kComponentTarget});
}

void addQueries(TissueBenchResult& result, const TwistModel& model) {
  TwistState state{0.7 * model.lattice().length_m(), 0.5};
  const AxisFrame frame = model.graspFrame(state.graspArc_m);
  const Vec3 grip = frame.centre_m + 0.03 * frame.e1;
  std::vector<double> batches;
  double sink = 0.0;
  for (int b = 0; b < kBatches; ++b) {
    const double time = seconds([&] {
      for (int i = 0; i < kQueriesABatch; ++i) {  // each query waits for the one before
        const Vec3 force = model.graspForce_N(state, grip);
        state.graspAngle_rad = 0.5 + 1e-3 * force.y;
      }
    });
    batches.push_back(1e9 * time / kQueriesABatch);
    sink += state.graspAngle_rad;
  }
  std::vector<double> single;
  single.reserve(kSingleQueries);
  for (int i = 0; i < kSingleQueries; ++i) {
    single.push_back(1e6 * seconds([&] { sink += model.graspForce_N(state, grip).x; }));
  }
  TORSIO_EXPECTS(std::isfinite(sink));
  std::sort(single.begin(), single.end());
  result.rows.push_back({"haptic_query", median(batches), "ns", kQueryTarget_ns, false});
  result.rows.push_back(
      {"haptic_query_p999", single[single.size() * 999 / 1000], "us", kQueryTailTarget_us, false});
}

}  // namespace

TissueBenchResult runTissueBench(const TissueBenchOptions& options) {
  TORSIO_EXPECTS(options.repeats >= 1 && options.vertices >= 16 * kRingPoints);
  const CorePin pin;
  TissueBenchResult result;
  const Isa isa = bestIsa();
  result.isa = isaName(isa);
  result.core = pin.core();
  result.loadAverage = loadAverage();
  const TriangleMesh mesh = benchOrgan(options.vertices);
  const auto start = Clock::now();
  const std::clock_t startCpu = std::clock();
  const TwistModel model = benchModel(mesh, options);
  const double setUpCpu_s = static_cast<double>(std::clock() - startCpu) / CLOCKS_PER_SEC;
  const double setUp_s = std::chrono::duration<double>(Clock::now() - start).count();
  addLattices(result, options, isa);
  addVertices(result, options, model, isa);
  addComponents(result, options, model, isa);
  addQueries(result, model);
  // The processor's time is what counts: by the wall clock the same work takes longer on a busy machine.
  result.rows.push_back({"set_up_cpu", setUpCpu_s, "s", kSetUpTarget_s, false});
  result.rows.push_back({"set_up", setUp_s, "s"});
  return result;
}

}  // namespace torsio
