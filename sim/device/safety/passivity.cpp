// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/safety/passivity.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/core/error.h"

namespace torsio {

PassivityController::PassivityController(const PassivityOptions& options) : options_(options) {
  const bool latencyFits = options.latency_ticks >= 0 && options.latency_ticks <= kLongestLatency_ticks;
  const bool dampingFits =
      options.largestDamping_Ns_per_m > 0.0 && std::isfinite(options.largestDamping_Ns_per_m);
  if (options.tickPeriod_us <= 0 || !latencyFits || !dampingFits) {
    throw Error(ErrorCode::kBadParameter,
                Text::tr("tick period %1 us, latency %2 {tick|ticks}, damping %3 N s/m",
                         std::to_string(options.tickPeriod_us), std::to_string(options.latency_ticks),
                         std::to_string(options.largestDamping_Ns_per_m)),
                Text::tr("passivity controller"),
                Text::tr("Period and damping lie above zero, the latency in 0..16 ticks"));
  }
}

void PassivityController::begin(std::int64_t now_us, const Vec3& tip_m) noexcept {
  energy_J_ = 0.0;
  last_m_ = tip_m;
  places_.fill({tip_m, now_us});
  sent_N_.fill({});
}

bool PassivityController::quiet(const Vec3& wanted_N) const noexcept {
  const auto acting = sent_N_.begin() + options_.latency_ticks + 1;
  return wanted_N == Vec3{} &&
         std::all_of(sent_N_.begin(), acting, [](const Vec3& force_N) { return force_N == Vec3{}; });
}

Vec3 PassivityController::control(std::int64_t now_us, const Vec3& tip_m, const Vec3& wanted_N, bool sound,
                                  std::uint32_t& limits) noexcept {
  if (!begun_ || !sound) {
    begin(now_us, tip_m);
  }
  begun_ = true;
  const Vec3 way_m = tip_m - last_m_;
  last_m_ = tip_m;
  energy_J_ -= dot(sent_N_[static_cast<std::size_t>(options_.latency_ticks)], way_m);
  const Place oldest = places_[nextPlace_];
  places_[nextPlace_] = {tip_m, now_us};
  nextPlace_ = (nextPlace_ + 1) % kWindow;
  if (quiet(wanted_N)) {
    energy_J_ = std::min(energy_J_, 0.0);
  }
  // Out of contact nothing is felt, not even damping: what is still owed waits for the next contact.
  if (!(energy_J_ < 0.0) || wanted_N == Vec3{} || now_us <= oldest.time_us) {
    return wanted_N;
  }

  const Vec3 velocity_m_per_s =
      (tip_m - oldest.tip_m) / (static_cast<double>(now_us - oldest.time_us) * 1e-6);
  // Where the hand has just turned round, the mean still points the old way: damping would push it.
  if (!(dot(velocity_m_per_s, way_m) > 0.0)) {
    return wanted_N;
  }
  const double step_s = static_cast<double>(options_.tickPeriod_us) * 1e-6;
  const double wanted_Ns_per_m = -energy_J_ / (step_s * dot(velocity_m_per_s, velocity_m_per_s));
  limits |= kForcePassivity;
  return wanted_N - velocity_m_per_s * std::min(wanted_Ns_per_m, options_.largestDamping_Ns_per_m);
}

void PassivityController::sent(const Vec3& force_N) noexcept {
  std::copy_backward(sent_N_.begin(), sent_N_.end() - 1, sent_N_.end());
  sent_N_[0] = force_N;
}

}  // namespace torsio
