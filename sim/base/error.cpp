// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/base/error.h"

#include "sim/base/contracts.h"

namespace torsio {

namespace {

std::string sentence(const std::string& what, const std::string& where, const std::string& remedy) {
  std::string text = where.empty() ? what : where + ": " + what;
  if (!remedy.empty()) text += ". " + remedy;
  return text;
}

}  // namespace

Error::Error(ErrorCode code, const std::string& what, const std::string& where, const std::string& remedy)
    : std::runtime_error(sentence(what, where, remedy)),
      code_(code),
      happened_(what),
      where_(where),
      remedy_(remedy) {}

void contractBroken(const char* condition, const char* file, int line) {
  throw ContractError(std::string("broken contract: ") + condition + " (" + file + ":" +
                      std::to_string(line) + ")");
}

}  // namespace torsio
