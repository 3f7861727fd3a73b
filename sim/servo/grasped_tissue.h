// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "sim/servo/grasped_bar.h"
#include "sim/servo/grasped_hollow.h"
#include "sim/servo/grasped_rod.h"

namespace torsio {

/// The organ under the jaw, whatever kind it is. A further kind is a type with these functions (those of
/// CommonTissue come for free), named in Kind and chosen in the constructor. `scene` outlives it.
///
/// A plain value; servo thread. After construction noexcept (but for start()), no allocation.
class GraspedTissue {
  using Kind = std::variant<GraspedBar, GraspedRod, GraspedHollow, GraspedAsync>;

  template <typename AnyKind, typename Call>
  static decltype(auto) ask(AnyKind& kind, Call&& call) {
    return std::visit(std::forward<Call>(call), kind);
  }

 public:
  GraspedTissue(const Scene& scene, std::int64_t tickPeriod_us);

  // As CommonTissue says.
  [[nodiscard]] OrganState start(std::uint64_t seed) {
    return ask(kind_, [&](auto& kind) { return kind.start(seed); });
  }
  void apply(const ServoCommand& command) noexcept {
    ask(kind_, [&](auto& kind) { kind.apply(command); });
  }
  void takeAnswer(const AsyncAnswer& answer) noexcept {
    ask(kind_, [&](auto& kind) { kind.takeAnswer(answer); });
  }
  void setHolders(const JawState& jaw, OrganState& organ, std::uint32_t& events) noexcept {
    ask(kind_, [&](auto& kind) { kind.setHolders(jaw, organ, events); });
  }
  [[nodiscard]] double step(const JawState& jaw, OrganState& organ, std::uint32_t& events) noexcept {
    return ask(kind_, [&](auto& kind) { return kind.step(jaw, organ, events); });
  }
  [[nodiscard]] ToolState carried(const ToolState& tool, const JawMotion& motion,
                                  const OrganState& organ) const noexcept {
    return ask(kind_, [&](const auto& kind) { return kind.carried(tool, motion, organ); });
  }
  [[nodiscard]] bool keepsJaw() const noexcept {
    return ask(kind_, [](const auto& kind) { return kind.keepsJaw(); });
  }
  [[nodiscard]] bool forgets() const noexcept {
    return ask(kind_, [](const auto& kind) { return kind.forgets(); });
  }

  /// Closes the jaw at `held_m` of the organ at rest, at this arc length. Returns the axis that the hand
  /// turns about; none where nothing can be twisted.
  [[nodiscard]] std::optional<AxisFrame> grip(const Vec3& held_m, double arc_m, const ToolState& tool,
                                              OrganState& organ) noexcept {
    return ask(kind_, [&](auto& kind) { return kind.grip(held_m, arc_m, tool, organ); });
  }
  /// Turns the organ with the jaw. Returns the event that ends the grip, kEventNone while it holds.
  [[nodiscard]] std::uint32_t follow(const ToolState& tool, JawMotion& motion, OrganState& organ) noexcept {
    return ask(kind_, [&](auto& kind) { return kind.follow(tool, motion, organ); });
  }
  /// Lets the organ go back by a tick without a hand.
  [[nodiscard]] TissueReturn relax(OrganState& organ) noexcept {
    return ask(kind_, [&](auto& kind) { return kind.relax(organ); });
  }
  /// Returns what a hand with the tip of its tool at `tip_m` feels of the grip.
  [[nodiscard]] GripFeel feel(const Vec3& tip_m, const JawMotion& motion,
                              const OrganState& organ) const noexcept {
    return ask(kind_, [&](const auto& kind) { return kind.feel(tip_m, motion, organ); });
  }

 private:
  [[nodiscard]] static Kind kindOf(const Scene& scene, std::int64_t tickPeriod_us);
  Kind kind_;
};
static_assert(std::is_trivially_copyable_v<GraspedTissue>);

}  // namespace torsio
