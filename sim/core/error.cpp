// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/error.h"

#include <utility>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

std::string sentence(const std::string& what, const std::string& where, const std::string& remedy) {
  std::string text = where.empty() ? what : where + ": " + what;
  if (!remedy.empty()) {
    text += ". " + remedy;
  }
  return text;
}

}  // namespace

Error::Error(ErrorCode code, Text what, Text where, Text remedy)
    : std::runtime_error(sentence(what.str(), where.str(), remedy.str())),
      code_(code),
      happenedText_(std::move(what)),
      whereText_(std::move(where)),
      remedyText_(std::move(remedy)),
      happened_(happenedText_.str()),
      where_(whereText_.str()),
      remedy_(remedyText_.str()) {}

void contractBroken(const char* condition, const char* file, int line) {
  throw ContractError(std::string("broken contract: ") + condition + " (" + file + ":" +
                      std::to_string(line) + ")");
}

}  // namespace torsio
