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

/// Pictures of recordings that were opened lately, so that the traces, the organ, a second look and the look
/// of another rater cost one making. One is made at a time: it takes a core. Any thread.
class PictureCache {
 public:
  explicit PictureCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// Returns the picture of a recording (RecordingName::key); `make` is called when there is none. The caller
  /// has asked for the right to see it in this very call.
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
