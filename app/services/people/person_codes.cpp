// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/people/person_codes.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace torsio {

std::string PersonCodes::next(const std::string& prefix) {
  const std::string head = prefix + "-";
  std::int64_t highest = 0;
  for (const std::string& code : used_) {
    if (!code.starts_with(head)) {
      continue;
    }
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(code.data() + head.size(), code.data() + code.size(), number);
    if (error == std::errc() && end == code.data() + code.size()) {
      highest = std::max(highest, number);
    }
  }
  std::string digits = std::to_string(highest + 1);
  if (digits.size() < 2) {
    digits.insert(0, 1, '0');
  }
  return *used_.insert(head + digits).first;
}

}  // namespace torsio
