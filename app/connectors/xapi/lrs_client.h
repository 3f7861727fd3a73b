// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/connectors/xapi/lrs_settings.h"

namespace torsio {

/// Answer of a learning record store.
struct LrsAnswer {
  int status = 0;       ///< HTTP status; 0: no answer, for the reason in `body`
  std::string body{};   ///< at most a megabyte
  std::string after{};  ///< Retry-After header; empty: none
};

/// Client of an xAPI 1.0.3 store. Checks certificates and follows no redirects. Used by the thread that
/// created it, which needs no event loop.
class LrsClient {
 public:
  /// `stop` (may be null; outlives the client): once another thread sets it, a request is aborted within a
  /// tenth of a second.
  LrsClient(const std::string& endpoint, LrsKey key,
            std::chrono::milliseconds patience = std::chrono::seconds(30),
            const std::atomic<bool>* stop = nullptr);
  ~LrsClient();
  LrsClient(const LrsClient&) = delete;
  LrsClient& operator=(const LrsClient&) = delete;

  /// Sends a statement.
  [[nodiscard]] LrsAnswer post(const std::string& statement);
  /// Requests the statement with this id.
  [[nodiscard]] LrsAnswer get(const std::string& id);

 private:
  struct Talk;
  std::unique_ptr<Talk> talk_;
};

}  // namespace torsio
