// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/safety/passivity.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/core/error.h"

namespace torsio {

void HandPort::begin(const Vec3& tip_m) noexcept {
  energy_J_ = 0.0;
  last_m_ = tip_m;
  sent_N_.fill({});
  begun_ = true;
}

Vec3 HandPort::move(const Vec3& tip_m) noexcept {
  const Vec3 way_m = skip(tip_m);
  energy_J_ -= dot(acting_N(), way_m);
  return way_m;
}

Vec3 HandPort::skip(const Vec3& tip_m) noexcept {
  const Vec3 way_m = tip_m - last_m_;
  last_m_ = tip_m;
  return way_m;
}

bool HandPort::quiet(const Vec3& force_N) const noexcept {
  const auto acting = sent_N_.begin() + latency_ticks_ + 1;
  return force_N == Vec3{} &&
         std::all_of(sent_N_.begin(), acting, [](const Vec3& sent_N) { return sent_N == Vec3{}; });
}

void HandPort::keep(const Vec3& force_N) noexcept {
  std::copy_backward(sent_N_.begin(), sent_N_.end() - 1, sent_N_.end());
  sent_N_[0] = force_N;
}

PassivityController::PassivityController(const PassivityOptions& options)
    : HandPort(options.latency_ticks), options_(options) {
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

Vec3 PassivityController::control(std::int64_t now_us, const Vec3& tip_m, const Vec3& wanted_N, bool sound,
                                  std::uint32_t& limits) noexcept {
  if (!begun() || !sound) {
    begin(tip_m);
    places_.fill({tip_m, now_us});
  }
  const Vec3 way_m = move(tip_m);
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

StoredEnergyLimit::StoredEnergyLimit(const StoredEnergyOptions& options)
    : HandPort(options.latency_ticks), options_(options) {
  const bool latencyFits = options.latency_ticks >= 0 && options.latency_ticks <= kLongestLatency_ticks;
  if (options.tickPeriod_us <= 0 || !latencyFits) {
    throw Error(ErrorCode::kBadParameter,
                Text::tr("tick period %1 us, latency %2 {tick|ticks}", std::to_string(options.tickPeriod_us),
                         std::to_string(options.latency_ticks)),
                Text::tr("stored energy of the force"),
                Text::tr("The period lies above zero, the latency in 0..16 ticks"));
  }
}

Vec3 StoredEnergyLimit::account(const Vec3& tip_m, HandReading hand) noexcept {
  const auto hide = [&] {
    ++hidden_.ticks;
    hidden_.forces_N += acting_N();
    hidden_.given_J += dot(acting_N(), lastWay_m_);
  };
  if (!options_.countsHiddenWays) {
    return move(tip_m);
  }
  if (hand == HandReading::kStandsStill) {
    hide();
    return lastWay_m_;
  }
  if (hidden_.ticks == 0) {
    lastWay_m_ = move(tip_m);
    return lastWay_m_;
  }
  hide();
  lastWay_m_ = skip(tip_m) / static_cast<double>(hidden_.ticks);
  const double given_J = std::max(hidden_.given_J, dot(hidden_.forces_N, lastWay_m_));
  energy_J_ -= given_J;
  owed_J_ += std::max(0.0, given_J);
  hidden_ = {};
  return lastWay_m_;
}

Vec3 StoredEnergyLimit::limited(const Vec3& tip_m, const Vec3& command_N, HandReading hand,
                                std::uint32_t& limits) noexcept {
  if (!begun() || hand == HandReading::kNone) {
    begin(tip_m);
    hidden_ = {};
    lastWay_m_ = {};
    owed_J_ = 0.0;
  }
  const Vec3 way_m = account(tip_m, hand);
  energy_J_ = std::max(energy_J_, -kEnergyAllowance_J - owed_J_);
  const bool hides = options_.countsHiddenWays && hand == HandReading::kStandsStill;
  if (!hides && quiet(command_N)) {
    energy_J_ = 0.0;
    owed_J_ = 0.0;
  } else if (command_N == Vec3{}) {
    forget();
  }

  Vec3 force_N = command_N;
  const double size_N = norm(command_N);
  if (size_N > 0.0) {
    const double along_m = dot(way_m, command_N) / size_N;
    const double ahead_N = kHonestStiffness_N_per_m * std::max(0.0, along_m) * (options_.latency_ticks + 1);
    const double stored_J = std::max(0.0, energy_J_ - std::max(0.0, hidden_.given_J) + kEnergyAllowance_J);
    double most_N = std::sqrt(2.0 * kHonestStiffness_N_per_m * stored_J + ahead_N * ahead_N) - ahead_N;
    if (!(along_m > 0.0)) {
      most_N = std::max(most_N, kLeastResistance_N);
    }
    if (size_N > most_N) {
      force_N *= most_N / size_N;
      limits |= kForcePassivity;
    }
  }
  keep(force_N);
  return force_N;
}

}  // namespace torsio
