// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/safety/stored_energy.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/core/error.h"

namespace torsio {

StoredEnergyLimit::StoredEnergyLimit(const StoredEnergyOptions& options) : options_(options) {
  const bool latencyFits = options.latency_ticks >= 0 && options.latency_ticks <= kLongestLatency_ticks;
  if (options.tickPeriod_us <= 0 || !latencyFits) {
    throw Error(ErrorCode::kBadParameter,
                Text::tr("tick period %1 us, latency %2 {tick|ticks}", std::to_string(options.tickPeriod_us),
                         std::to_string(options.latency_ticks)),
                Text::tr("stored energy of the force"),
                Text::tr("The period lies above zero, the latency in 0..16 ticks"));
  }
}

void StoredEnergyLimit::begin(const Vec3& tip_m) noexcept {
  energy_J_ = 0.0;
  last_m_ = tip_m;
  sent_N_.fill({});
}

bool StoredEnergyLimit::quiet(const Vec3& command_N) const noexcept {
  const auto acting = sent_N_.begin() + options_.latency_ticks + 1;
  return command_N == Vec3{} &&
         std::all_of(sent_N_.begin(), acting, [](const Vec3& force_N) { return force_N == Vec3{}; });
}

Vec3 StoredEnergyLimit::limited(const Vec3& tip_m, const Vec3& command_N, bool sound,
                                std::uint32_t& limits) noexcept {
  if (!begun_ || !sound) {
    begin(tip_m);
  }
  begun_ = true;
  const Vec3 way_m = tip_m - last_m_;
  energy_J_ -= dot(sent_N_[static_cast<std::size_t>(options_.latency_ticks)], way_m);
  energy_J_ = std::max(energy_J_, -kEnergyAllowance_J);
  last_m_ = tip_m;
  if (quiet(command_N)) {
    energy_J_ = 0.0;
  } else if (command_N == Vec3{}) {
    forget();
  }

  Vec3 force_N = command_N;
  const double size_N = norm(command_N);
  if (size_N > 0.0) {
    const double along_m = dot(way_m, command_N) / size_N;
    const double ahead_N = kHonestStiffness_N_per_m * std::max(0.0, along_m) * (options_.latency_ticks + 1);
    const double stored_J = std::max(0.0, energy_J_ + kEnergyAllowance_J);
    double most_N = std::sqrt(2.0 * kHonestStiffness_N_per_m * stored_J + ahead_N * ahead_N) - ahead_N;
    if (!(along_m > 0.0)) {
      most_N = std::max(most_N, kLeastResistance_N);
    }
    if (size_N > most_N) {
      force_N *= most_N / size_N;
      limits |= kForcePassivity;
    }
  }
  std::copy_backward(sent_N_.begin(), sent_N_.end() - 1, sent_N_.end());
  sent_N_[0] = force_N;
  return force_N;
}

}  // namespace torsio
