// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/picture_cache.h"

#include <algorithm>

namespace torsio::web {

namespace {

std::size_t bytesOf(const CasePicture& picture) {
  return picture.recording.size() + picture.organ.size();
}

}  // namespace

std::shared_ptr<const CasePicture> PictureCache::kept(const std::string& recording) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(kept_.begin(), kept_.end(),
                                  [&recording](const Kept& one) { return one.recording == recording; });
  if (found == kept_.end()) {
    return nullptr;
  }
  kept_.splice(kept_.begin(), kept_, found);
  return kept_.front().picture;
}

std::shared_ptr<const CasePicture> PictureCache::of(const std::string& recording,
                                                    const std::function<CasePicture()>& make) {
  if (auto picture = kept(recording)) {
    return picture;
  }
  const std::lock_guard one(making_);
  if (auto picture = kept(recording)) {
    return picture;  // made by another thread meanwhile
  }
  auto made = std::make_shared<const CasePicture>(make());
  const std::lock_guard lock(mutex_);
  kept_.push_front({recording, made});
  bytes_ += bytesOf(*made);
  while (bytes_ > most_bytes_ && kept_.size() > 1) {
    bytes_ -= bytesOf(*kept_.back().picture);
    kept_.pop_back();
  }
  return made;
}

}  // namespace torsio::web
