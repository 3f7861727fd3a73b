// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "assessment/domain/ids.h"
#include "sim/core/digest.h"

namespace torsio {

/// Hash of a row. Every text is hashed with its length, so that different rows never yield the same bytes.
class FieldDigest {
 public:
  /// `purpose`: what is hashed, with the version of the field list ("torsio allocation 1").
  explicit FieldDigest(std::string_view purpose) { add(purpose); }

  FieldDigest& add(std::string_view text) {
    digest_.update(static_cast<std::int64_t>(text.size()));
    digest_.update(text);
    return *this;
  }
  template <typename Tag>
  FieldDigest& add(const Id<Tag>& id) {
    return add(std::string_view(id.text()));
  }
  template <std::integral T>
  FieldDigest& add(T number) {
    digest_.update(static_cast<std::int64_t>(number));
    return *this;
  }
  FieldDigest& add(double number) {
    digest_.update(number);
    return *this;
  }
  [[nodiscard]] std::string hex() const { return digest_.hex(); }

 private:
  Digest digest_;
};

}  // namespace torsio
