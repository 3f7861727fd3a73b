// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <random>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/allocation_file.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/maintenance/signing_key.h"
#include "app/services/maintenance/station_anchor.h"
#include "assessment/domain/study/allocation.h"
#include "sim/core/clock.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

struct AllocateArguments {
  std::string design;
  std::optional<std::uint64_t> seed;
  std::string salt;
  std::string replay;
  std::string head;
  HeadKeys keys;
};

constexpr int kSaltDraws = 16;  // of 32 bits each: twice the size of the salt

/// Returns what is wrong with a seed; empty: it is a 64-bit integer, which CLI11 does not check.
std::string seedProblem(const std::string& text) {
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, fault] = std::from_chars(text.data(), end, seed);
  return fault == std::errc{} && stopped == end
             ? std::string()
             : "a seed is a whole number from 0 to 18446744073709551615, not " + text;
}

std::string saltProblem(const std::string& text) {
  return isSalt(text) ? std::string() : "a salt is 64 hexadecimal digits in lower case, not " + text;
}

std::string publicKeyProblem(const std::string& text) {
  return isPublicKey(text) ? std::string() : "a public key is 64 hexadecimal digits, not " + text;
}

/// Returns 256 bits from the operating system's random numbers.
std::string drawnSalt() {
  std::random_device machine;
  Digest digest;
  for (int i = 0; i < kSaltDraws; ++i) {
    digest.update(static_cast<std::int64_t>(machine()));
  }
  return digest.hex();
}

void runAllocation(const AllocateArguments& arguments) {
  const AllocationOrder order = readAllocationOrder(arguments.design);
  Allocation allocation =
      allocate(order.design, arguments.seed.value_or(0), order.persons, order.jointLeftovers,
               arguments.salt.empty() ? drawnSalt() : arguments.salt);
  const std::string key = arguments.keys.key.empty() ? stationAnchor().key.string() : arguments.keys.key;
  allocation.head = signedAllocationHead(allocation.head, key, utcNow_us());
  printJson(allocationJson(allocation));
  if (key.empty()) {
    std::cerr << "torsio: the head is not signed: keep it away from the file. torsio audit key FILE makes a "
                 "key, --key FILE signs with it\n";
  }
}

/// Adds what a successful replay proves about the file, and what it could not check.
void addChecks(Json& out, const KeptAllocation& kept, const AllocateArguments& arguments, bool isSigned) {
  out["checked"] = {"commitment", "chain of records", "draws repeated from the seed"};
  out["not_checked"] = Json::array();
  const auto add = [&out](const char* what, bool checked) {
    out[checked ? "checked" : "not_checked"].push_back(what);
  };
  add("counts", kept.countsFit.has_value());
  add("head in the file", !kept.allocation.head.empty());
  add("head kept elsewhere", !arguments.head.empty());
  add("signature", isSigned);
}

void runReplay(const AllocateArguments& arguments) {
  const std::string& file = arguments.replay;
  KeptAllocation kept = readAllocation(file);
  const SignatureFinding signature = checkSignatures(kept.allocation.head, arguments.head, arguments.keys);
  kept.allocation.head = unsignedAllocationHead(kept.allocation.head);
  ReplayFinding finding = replayAllocation(kept.allocation, unsignedAllocationHead(arguments.head));
  if (finding.sound && !kept.countsFit.value_or(true)) {
    finding = {false, std::nullopt, "the counts are not those of the records"};
  }
  if (finding.sound && !signature.flaw.empty()) {
    finding = {false, std::nullopt, signature.flaw};
  }
  Json out{{"sound", finding.sound}, {"records", kept.allocation.records.size()}};
  out["commitment"] = kept.allocation.commitment;
  out["head"] = allocationHead(kept.allocation);
  out["signature"] = signature.json;
  if (finding.firstWrongPosition) {
    out["first_wrong_position"] = *finding.firstWrongPosition;
  }
  if (finding.sound) {
    addChecks(out, kept, arguments, signature.isSigned);
  } else {
    out["reason"] = finding.reason;
  }
  printJson(out);
  if (!finding.sound) {
    throw Error(ErrorCode::kVerifyFailed, "the allocation cannot be repeated: " + finding.reason, file,
                Text::verbatim("Compare the file with the one that was kept"));
  }
}

void run(const AllocateArguments& arguments) {
  if (!arguments.replay.empty()) {
    if (!arguments.design.empty() || arguments.seed || !arguments.salt.empty()) {
      refuseUsage("--replay stands alone: design and seed are in the file", arguments.replay,
                  "Leave out --design, --seed and --salt");
    }
    runReplay(arguments);
    return;
  }
  if (!arguments.head.empty() || !arguments.keys.publicKey.empty() || !arguments.keys.witness.empty()) {
    refuseUsage("--head, --public-key and --witness belong to --replay", "allocate",
                "Give --replay FILE, or leave them out");
  }
  if (arguments.design.empty() || !arguments.seed) {
    refuseUsage("an allocation needs --design and --seed, or --replay", "allocate",
                "Give the design and draw a seed at random: it is never chosen for you");
  }
  runAllocation(arguments);
}

}  // namespace

void addAllocate(CLI::App& program) {
  auto arguments = std::make_shared<AllocateArguments>();
  CLI::App* command = program.add_subcommand("allocate", "Reproducible random allocation to groups");
  command->add_option("--design", arguments->design, "Design and persons, JSON: docs/cli.md");
  command->add_option("--seed", arguments->seed, "Determines the allocation; keep it sealed until the end")
      ->check(CLI::Validator(seedProblem, "UINT64"));
  command->add_option("--salt", arguments->salt, "256 bits in hexadecimal; default: drawn at random")
      ->check(CLI::Validator(saltProblem, "HEX"));
  command->add_option("--head", arguments->head, "With --replay: a head stored elsewhere, in quotes");
  CLI::Option* key = command->add_option(
      "--key", arguments->keys.key,
      "File of the key that signs the head, or must have signed it; default: the station's key");
  command->add_option("--public-key", arguments->keys.publicKey, "With --replay: the public part of that key")
      ->check(CLI::Validator(publicKeyProblem, "HEX"))
      ->excludes(key);
  command->add_option("--witness", arguments->keys.witness,
                      "With --replay: file with the lines that record replacements of keys");
  command->add_option("--replay", arguments->replay, "Repeat an allocation and compare: exit code 13");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace torsio::cli
