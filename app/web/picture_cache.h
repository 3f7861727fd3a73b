// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "app/web/case_picture.h"

namespace torsio::web {

/// Pictures of recently opened recordings, so that traces, organ, reopening and other raters share one
/// computation. One is made at a time, as it takes a core. Thread-safe.
class PictureCache {
 public:
  explicit PictureCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// Returns the picture of a recording (RecordingName::key), calling `make` if it is not cached. The caller
  /// must have checked the right to see it in the same call.
  [[nodiscard]] std::shared_ptr<const CasePicture> of(const std::string& recording,
                                                      const std::function<CasePicture()>& make);

 private:
  struct Kept {
    std::string recording{};
    std::shared_ptr<const CasePicture> picture;
  };
  [[nodiscard]] std::shared_ptr<const CasePicture> kept(const std::string& recording);

  std::size_t most_bytes_;
  std::mutex making_;
  std::mutex mutex_;
  std::size_t bytes_ = 0;
  std::list<Kept> kept_;  // newest first
};

}  // namespace torsio::web
