// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/allocation_head.h"

#include <filesystem>
#include <optional>
#include <sstream>
#include <system_error>
#include <vector>

#include "app/services/maintenance/signing_key.h"
#include "app/services/maintenance/station_anchor.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

/// A parsed head.
struct HeadLine {
  std::string words{};  ///< format, version, records, hash
  std::int64_t utc_us = 0;
  std::string publicKey{};
  std::string signature{};
  bool isSigned = false;  ///< there are more than four words, complete or not

  [[nodiscard]] std::string signedText() const { return words + " " + std::to_string(utc_us); }
};

HeadLine headLineOf(const std::string& line) {
  constexpr int kUnsignedWords = 4;
  std::istringstream in(line);
  HeadLine head;
  std::string word;
  for (int i = 0; i < kUnsignedWords && in >> word; ++i) {
    head.words += (i > 0 ? " " : "") + word;
  }
  head.isSigned = !(in >> std::ws).eof();
  std::string more;
  in >> head.utc_us >> head.publicKey >> head.signature;
  if (in >> more) {
    head.signature.clear();  // something was appended
  }
  return head;
}

/// The expected signing key, and the keys before and after it.
struct Expected {
  std::string root{};  ///< public part; empty: none
  bool named = false;  ///< given by the command, not taken from the station
  std::vector<KeyReplacement> replacements{};
};

Expected expectedOf(const HeadKeys& keys) {
  Expected expected;
  const StationAnchor station = stationAnchor();
  expected.named = !keys.key.empty() || !keys.publicKey.empty();
  const std::filesystem::path file = expected.named ? std::filesystem::path(keys.key) : station.key;
  const auto add = [&expected](const std::filesystem::path& from) {
    for (KeyReplacement& made : replacementsIn(from)) {
      expected.replacements.push_back(std::move(made));
    }
  };
  expected.root = file.empty() ? keys.publicKey : publicOf(readKey(file));
  if (!file.empty()) {
    add(file);
  }
  std::error_code ignored;
  if (!keys.witness.empty()) {
    add(keys.witness);
  } else if (std::filesystem::is_regular_file(station.witness, ignored)) {
    add(station.witness);
  }
  return expected;
}

constexpr const char* kUnsigned =
    "this head is not signed: anybody who has the file has seed and salt, and can write another one that "
    "repeats";
constexpr const char* kUnknownKey =
    "the signature is genuine, but no key was given and this station has none: anybody who rewrites the file "
    "can sign it with their own key; give --public-key as published by its owner";
constexpr const char* kGenuine = "nobody without this key can have rewritten the file";

}  // namespace

std::string signedAllocationHead(const std::string& head, const std::string& key, std::int64_t now_us) {
  if (key.empty()) {
    return head;
  }
  const SecretKey secret = readKey(key);
  HeadLine line;
  line.words = head;
  line.utc_us = now_us;
  return line.signedText() + " " + publicOf(secret) + " " + signedWith(secret, line.signedText());
}

std::string unsignedAllocationHead(const std::string& line) {
  return headLineOf(line).words;
}

SignatureFinding checkSignatures(const std::string& fileHead, const std::string& keptHead,
                                 const HeadKeys& keys) {
  const Expected expected = expectedOf(keys);
  const TrustedKeys trusted(expected.root, expected.replacements, &KeyReplacement::utc_us);
  SignatureFinding finding;
  std::optional<HeadLine> shown;
  for (const std::string& text : {fileHead, keptHead}) {
    const HeadLine head = headLineOf(text);
    if (!head.isSigned || !finding.flaw.empty()) {
      continue;
    }
    shown = head;
    if (trusted.asksForSignatures()) {
      finding.flaw = trusted.flawOf(head.signedText(), head.signature, head.publicKey, head.utc_us);
    } else if (!genuine(head.signedText(), head.signature, head.publicKey)) {
      finding.flaw = "the signature of the head is not genuine";
    }
  }
  finding.isSigned = shown.has_value();
  if (!shown && expected.named) {
    finding.flaw = "the head is not signed, although a signing key was given";
  }
  const bool known = trusted.asksForSignatures();
  const std::string good = known ? kGenuine : kUnknownKey;
  const std::string said = shown ? good : kUnsigned;
  const std::string state = known ? "genuine" : "genuine, key not known";
  const std::string sound = shown ? state : "none";
  finding.json["state"] = finding.flaw.empty() ? sound : "wrong";
  finding.json["key"] = shown ? Json(shown->publicKey) : Json();
  finding.json["signed_utc_us"] = shown ? Json(shown->utc_us) : Json();
  finding.json["compared_with"] = expected.root.empty() ? Json() : Json(expected.root);
  finding.json["means"] = finding.flaw.empty() ? said : finding.flaw;
  return finding;
}

}  // namespace torsio::cli
