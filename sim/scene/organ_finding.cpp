// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/organ_finding.h"

#include <cctype>
#include <utility>
#include <vector>

namespace torsio {

namespace {

constexpr std::size_t kCodeLength = 3;

bool beginsWithCode(const std::string& sentence) {
  const auto digit = [&sentence](std::size_t i) {
    return std::isdigit(static_cast<unsigned char>(sentence[i])) != 0;
  };
  const bool letter = !sentence.empty() && (sentence[0] == 'M' || sentence[0] == 'D' || sentence[0] == 'N');
  return sentence.size() > kCodeLength && letter && digit(1) && digit(2) && sentence[kCodeLength] == ' ';
}

}  // namespace

Text coded(const OrganWarning& warning) {
  return beginsWithCode(warning.text.str()) ? warning.text
                                            : Text::verbatim("%1 %2", warning.code, warning.text);
}

OrganFinding findingOf(const Error& refusal) {
  OrganFinding finding;
  finding.weight = FindingWeight::kRefusal;
  finding.code = beginsWithCode(refusal.happened())             ? refusal.happened().substr(0, kCodeLength)
                 : refusal.code() == ErrorCode::kFileUnreadable ? "M05"
                                                                : "M00";
  finding.what = refusal.happenedText();
  finding.where = refusal.whereText();
  finding.remedy = refusal.remedyText();
  return finding;
}

Error refusalOf(const OrganFinding& finding, const std::string& file) {
  return {ErrorCode::kBadMesh, coded(OrganWarning{finding.code, finding.what}), file, finding.remedy};
}

}  // namespace torsio
