// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/error.h"

namespace torsio::testing {

/// The Error that `action` throws; none when it is accepted.
template <typename Action>
[[nodiscard]] std::optional<Error> errorOf(const Action& action) {
  try {
    static_cast<void>(action());
  } catch (const Error& error) {
    return error;
  }
  return std::nullopt;
}

/// The Error that `action` throws, which it must.
template <typename Action>
[[nodiscard]] Error refusal(const Action& action) {
  if (std::optional<Error> error = errorOf(action)) {
    return *error;
  }
  ADD_FAILURE() << "nothing was refused";
  return {ErrorCode::kInternal, "", "", ""};
}

/// Expects the code of an error, and each of `said` in its message.
inline void expectError(const Error& error, ErrorCode code, const std::vector<std::string>& said) {
  EXPECT_EQ(error.code(), code);
  for (const std::string& part : said) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what() << " lacks " << part;
  }
}

/// The code of the Error that `action` throws; kInternal when it is accepted.
template <typename Action>
[[nodiscard]] ErrorCode refusalCode(const Action& action) {
  const std::optional<Error> error = errorOf(action);
  return error ? error->code() : ErrorCode::kInternal;
}

/// What the Error that `action` throws says, which has a remedy and the code, where one is asked for;
/// "accepted" when there is none.
template <typename Action>
[[nodiscard]] std::string refusalText(const Action& action, std::optional<ErrorCode> code = {}) {
  const std::optional<Error> error = errorOf(action);
  if (!error) {
    return "accepted";
  }
  EXPECT_FALSE(error->remedy().empty()) << error->happened();
  EXPECT_EQ(error->code(), code.value_or(error->code())) << error->happened();
  return error->happened();
}

}  // namespace torsio::testing
