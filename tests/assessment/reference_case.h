// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace torsio::test {

/// A case of tests/data/assessment: input, expected values, and their relative tolerance.
struct ReferenceCase {
  nlohmann::json input;
  nlohmann::json expected;
  double tolerance = 0.0;
};

inline ReferenceCase referenceCase(const std::string& family, const std::string& id) {
  const std::string path = std::string(TORSIO_TEST_DATA) + "/assessment/" + family + ".json";
  std::ifstream file(path);
  if (!file) {
    throw std::runtime_error("cannot read " + path);
  }
  const nlohmann::json all = nlohmann::json::parse(file);
  const nlohmann::json& found = all.at(id);
  return {found.at("input"), found.at("expected"), found.at("relative_tolerance").get<double>()};
}

/// |got - expected| <= tolerance * max(1e-12, |expected|), but at least an absolute 1e-12 for true zeros.
inline ::testing::AssertionResult matches(double got, double expected, double tolerance) {
  const double allowed = expected == 0.0 ? 1e-12 : tolerance * std::max(1e-12, std::abs(expected));
  if (std::isfinite(got) && std::abs(got - expected) <= allowed) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << std::scientific << "got " << ::testing::PrintToString(got)
                                       << ", expected " << ::testing::PrintToString(expected)
                                       << ", difference " << got - expected << ", allowed " << allowed;
}

inline std::vector<double> numbers(const nlohmann::json& list) {
  return list.get<std::vector<double>>();
}

}  // namespace torsio::test
