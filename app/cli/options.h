// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "sim/core/error.h"

namespace torsio::cli {

/// Adds an option whose help shows the default. `valid`: what is permitted.
template <class Value>
CLI::Option* addDefaulted(CLI::App& command, const std::string& name, Value& value, const std::string& what,
                          const CLI::Validator& valid = {}) {
  return command.add_option(name, value, what)->check(valid)->capture_default_str();
}

/// Throws Error{kUsage}.
[[noreturn]] inline void refuseUsage(const std::string& what, const std::string& where,
                                     const std::string& remedy) {
  throw Error(ErrorCode::kUsage, what, where, remedy);
}

}  // namespace torsio::cli
