// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "app/services/access/session_context.h"

namespace torsio::testing {

/// One service function and the operation that it must ask for. Each service stands here: .ci/rights looks
/// for functions that ask for a right and are not called. Its arguments name nothing that exists: whoever may
/// do it gets an empty answer or is told that there is no such thing, and nothing that matters changes.
/// `name`: the function, behind a comma what is special about this call. `also`: a second operation that
/// opens it as well (SessionContext::requireEither()).
struct ServiceCall {
  Operation operation;
  const char* name;
  std::function<void(SessionContext&, const std::filesystem::path& folder)> run;
  std::optional<Operation> also{};
};

/// Id of nothing.
inline constexpr const char* kNoSuch = "none";

[[nodiscard]] std::vector<ServiceCall> administratorCalls();  ///< access, people, maintenance
[[nodiscard]] std::vector<ServiceCall> studyCalls();          ///< study
[[nodiscard]] std::vector<ServiceCall> reportingCalls();      ///< reporting
[[nodiscard]] std::vector<ServiceCall> connectorCalls();      ///< mail, learning records, imports
[[nodiscard]] std::vector<ServiceCall> reviewCalls();         ///< review
[[nodiscard]] std::vector<ServiceCall> trainingCalls();       ///< training

}  // namespace torsio::testing
