// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/field_digest.h"

#include <span>
#include <string_view>

namespace torsio {

void addValue(Digest& digest, const Value& value, bool boolean) {
  struct Visitor {
    Digest& digest;
    bool boolean;
    void operator()(std::monostate) const { digest.update(std::int64_t{0}); }
    void operator()(std::int64_t number) const {
      digest.update(boolean ? std::int64_t{2} : std::int64_t{1});
      digest.update(number);
    }
    void operator()(bool flag) const {
      digest.update(std::int64_t{2});
      digest.update(std::int64_t{flag ? 1 : 0});
    }
    void operator()(double number) const {
      digest.update(std::int64_t{3});
      digest.update(number);
    }
    void operator()(const std::string& text) const {
      digest.update(std::int64_t{4});
      digest.update(static_cast<std::int64_t>(text.size()));
      digest.update(std::string_view(text));
    }
    void operator()(const Blob& bytes) const {
      digest.update(std::int64_t{5});
      digest.update(static_cast<std::int64_t>(bytes.size()));
      digest.update(std::span<const std::byte>(bytes));
    }
  };
  std::visit(Visitor{digest, boolean}, value.storage());
}

}  // namespace torsio
