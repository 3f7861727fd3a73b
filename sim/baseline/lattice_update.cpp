// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/lattice_update.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <vector>

#include "sim/core/portable_math.h"
#include "sim/tissue/view/twist_kernels.h"
#include "sim/tissue/view/twist_kernels_buffer.h"

namespace torsio {

namespace {

using UpdateClock = std::chrono::steady_clock;
constexpr int kUpdatesABatch = 100;
constexpr int kUpdateBatches = 31;

/// x' = c + R (x - c), R the turn about the tangent: rows of R, then c - R c.
void writeMotion(const AxisFrame& frame, double angle_rad, float* motion) {
  const SinCos turn = portableSinCos(angle_rad);
  const Vec3& t = frame.tangent;
  const double rest = 1.0 - turn.cos;
  const std::array<Vec3, 3> rows{
      Vec3{turn.cos + rest * t.x * t.x, rest * t.x * t.y - turn.sin * t.z, rest * t.x * t.z + turn.sin * t.y},
      Vec3{rest * t.y * t.x + turn.sin * t.z, turn.cos + rest * t.y * t.y, rest * t.y * t.z - turn.sin * t.x},
      Vec3{rest * t.z * t.x - turn.sin * t.y, rest * t.z * t.y + turn.sin * t.x,
           turn.cos + rest * t.z * t.z}};
  const std::array<double, 3> centre{frame.centre_m.x, frame.centre_m.y, frame.centre_m.z};
  for (std::size_t r = 0; r < 3; ++r) {
    motion[3 * r] = static_cast<float>(rows[r].x);
    motion[3 * r + 1] = static_cast<float>(rows[r].y);
    motion[3 * r + 2] = static_cast<float>(rows[r].z);
    motion[9 + r] = static_cast<float>(centre[r] - dot(rows[r], frame.centre_m));
  }
}

}  // namespace

double latticeUpdateTime_s(const TwistModel& model, Isa isa) {
  const SectionLattice& lattice = model.lattice();
  const int blocks = (lattice.ridges() + kKernelBlock - 1) / kKernelBlock;
  const auto sections = static_cast<std::size_t>(lattice.sections());
  KernelBuffer<float> rest(sections * static_cast<std::size_t>(3 * kKernelBlock * blocks));
  KernelBuffer<float> now(rest.size(), 32);
  KernelBuffer<float> motions(12 * sections);
  std::vector<AxisFrame> frames;
  std::vector<double> turn_rad_per_Nm;
  const TwistState unit = model.stateForTorque(lattice.length_m(), 1.0);
  for (int j = 0; j < lattice.sections(); ++j) {
    frames.push_back(lattice.frameAt(lattice.sectionArc_m(j)));
    turn_rad_per_Nm.push_back(model.angleAt(lattice.sectionArc_m(j), unit));
    for (int k = 0; k < lattice.ridges(); ++k) {
      const Vec3 p = lattice.keyPoint_m(k, j);
      float* block = rest.data() + 3 * kKernelBlock * (j * blocks + k / kKernelBlock) + k % kKernelBlock;
      block[0] = static_cast<float>(p.x);
      block[kKernelBlock] = static_cast<float>(p.y);
      block[2 * kKernelBlock] = static_cast<float>(p.z);
    }
  }
  const TwistKernels& kernels = twistKernels(isa);
  const double perRadian = 1.0 / model.graspCompliance(lattice.length_m());
  std::vector<double> times_s;
  for (int batch = 0; batch < kUpdateBatches; ++batch) {
    const auto start = UpdateClock::now();
    for (int i = 0; i < kUpdatesABatch; ++i) {
      const double torque_Nm = perRadian * (1.0 + 1e-3 * i);
      for (std::size_t j = 0; j < sections; ++j) {
        writeMotion(frames[j], torque_Nm * turn_rad_per_Nm[j], motions.data() + 12 * j);
      }
      kernels.lattice(rest.data(), lattice.sections(), blocks, motions.data(), now.data());
    }
    times_s.push_back(std::chrono::duration<double>(UpdateClock::now() - start).count() / kUpdatesABatch);
  }
  std::sort(times_s.begin(), times_s.end());
  return times_s[times_s.size() / 2];
}

}  // namespace torsio
