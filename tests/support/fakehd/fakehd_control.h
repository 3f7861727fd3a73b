// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "sim/device/hdapi/hdapi_library.h"
#include "tests/support/fakehd/fakehd.h"

namespace torsio::testing {

/// The controls of a loaded fake: FakeHd fake(path); fake.reset(); fake.run(10).
struct FakeHd {
  explicit FakeHd(const std::string& path) {
    const LoadedLibrary library = loadLibrary(path);
    if (library.handle == nullptr) {
      throw std::runtime_error(library.systemText);
    }
#define FAKEHD_RESOLVE(name) \
  name = reinterpret_cast<decltype(name)>(librarySymbol(library.handle, "fakehd_" #name));
// clang-format off
#define FAKEHD_EACH(X) \
  X(reset) X(set_present) X(set_garbage_handle) X(set_only_name) X(set_model) \
  X(set_gimbal) X(set_number) X(set_pose) X(set_pose_function) X(set_buttons) \
  X(set_stuck_force) X(set_temperature) X(set_calibration) X(dock) X(fault) X(push_error) \
  X(unplug) X(die) X(keep_task) X(call_kept) X(replug) X(run) X(set_tick_us) X(advance_us) X(now_us) X(set_hook) \
  X(set_real_time) X(log_count) X(log_entry) X(calls) X(off_thread) X(rule_breaks) \
  X(callbacks) X(running) X(errors_pending) X(loads) X(force) X(commanded) \
  X(force_enabled)
    // clang-format on
    FAKEHD_EACH(FAKEHD_RESOLVE)
  }

#define FAKEHD_MEMBER(name) decltype(&::fakehd_##name) name = nullptr;
  FAKEHD_EACH(FAKEHD_MEMBER)
#undef FAKEHD_MEMBER
#undef FAKEHD_RESOLVE
};

}  // namespace torsio::testing
