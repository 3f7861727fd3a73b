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

/// What a learning record store answered.
struct LrsAnswer {
  int status = 0;       ///< of HTTP; 0: no answer came, for the reason in `body`
  std::string body{};   ///< at most a megabyte of it
  std::string after{};  ///< header Retry-After; empty: none
};

/// Speaks xAPI 1.0.3 to one store. Certificates are checked; what a server says about going elsewhere is not
/// followed. Belongs to the thread that made it, which may have no event loop of its own.
class LrsClient {
 public:
  /// `stop`: may become true in another thread, and then a question is given up within a tenth of a second;
  /// null: never. Outlives the client.
  LrsClient(const std::string& endpoint, LrsKey key,
            std::chrono::milliseconds patience = std::chrono::seconds(30),
            const std::atomic<bool>* stop = nullptr);
  ~LrsClient();
  LrsClient(const LrsClient&) = delete;
  LrsClient& operator=(const LrsClient&) = delete;

  /// Hands one statement over.
  [[nodiscard]] LrsAnswer post(const std::string& statement);
  /// Asks for the statement with this id.
  [[nodiscard]] LrsAnswer get(const std::string& id);

 private:
  struct Talk;
  std::unique_ptr<Talk> talk_;
};

}  // namespace torsio
