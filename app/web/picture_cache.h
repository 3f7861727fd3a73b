// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <mutex>

#include "app/web/case_picture.h"
#include "sim/base/ids.h"

namespace torsio::web {

/// Pictures of cases that were opened lately, so that the traces, the organ and a second look cost one
/// making. One is made at a time: it takes a core. Any thread.
class PictureCache {
 public:
  explicit PictureCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// Returns the picture of a case; `make` is called when there is none. The caller has asked for the right
  /// to see the case in this very call.
  [[nodiscard]] std::shared_ptr<const CasePicture> of(const AssignmentId& assignmentId,
                                                      const std::function<CasePicture()>& make);

 private:
  struct Kept {
    AssignmentId assignmentId{};
    std::shared_ptr<const CasePicture> picture;
  };
  [[nodiscard]] std::shared_ptr<const CasePicture> kept(const AssignmentId& assignmentId);

  std::size_t most_bytes_;
  std::mutex making_;
  std::mutex mutex_;
  std::size_t bytes_ = 0;
  std::list<Kept> kept_;  // newest first
};

}  // namespace torsio::web
