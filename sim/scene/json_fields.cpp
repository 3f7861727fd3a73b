// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/json_fields.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <system_error>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/plain_text.h"

namespace torsio {

namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

constexpr std::size_t kLargestFile_MiB = 16;
constexpr int kDeepest = 64;
constexpr std::size_t kLongestText_KiB = 64;
constexpr std::size_t kShown = 200;  // characters of a parser's words, which quote the text

/// Returns the number of the first character of valid UTF-8 that is not in its plain text, "202E".
std::string firstHidden(const std::string& text, const std::string& plain) {
  const auto isWithin = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; };
  auto at = std::mismatch(text.begin(), text.end(), plain.begin(), plain.end()).first;
  while (at != text.begin() && isWithin(*at)) {
    --at;
  }
  const auto lead = static_cast<unsigned char>(*at);
  unsigned code = lead < 0x80U ? lead : lead < 0xE0U ? lead & 0x1FU : lead < 0xF0U ? lead & 0x0FU : lead & 7U;
  for (++at; at != text.end() && isWithin(*at); ++at) {
    code = code << 6U | (static_cast<unsigned char>(*at) & 0x3FU);
  }
  std::ostringstream number;
  number << std::uppercase << std::hex << std::setw(4) << std::setfill('0') << code;
  return number.str();
}

/// Goes through a JSON text without keeping it.
class SoundJson : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit SoundJson(const std::string& name) : name_(name) {}

  bool null() override { return true; }
  bool boolean(bool /*value*/) override { return true; }
  bool number_integer(number_integer_t /*value*/) override { return true; }
  bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
  bool binary(binary_t& /*value*/) override { return true; }
  bool string(string_t& value) override { return take(value); }
  bool key(string_t& value) override { return take(value); }
  bool start_object(std::size_t /*count*/) override { return enter(); }
  bool start_array(std::size_t /*count*/) override { return enter(); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  bool parse_error(std::size_t /*at*/, const std::string& /*token*/,
                   const nlohmann::detail::exception& problem) override {
    refuseIt(Text::tr("is not JSON: %1", plainLine(problem.what(), kShown)));
  }

 private:
  [[noreturn]] void refuseIt(const Text& what) const {
    throw Error(ErrorCode::kBadData, what, name_, Text::tr("Correct the text"));
  }
  bool take(const std::string& text) {
    if (text.size() > kLongestText_KiB * 1024) {
      refuseIt(Text::tr("holds a text of more than %1 KiB", kLongestText_KiB));
    }
    std::string seen = text;
    std::erase(seen, '\r');
    const std::string plain = plainText(seen);
    if (plain != seen) {
      refuseIt(Text::tr("contains the invisible character U+%1", firstHidden(seen, plain)));
    }
    return true;
  }
  bool enter() {
    if (++depth_ > kDeepest) {
      refuseIt(Text::tr("has more than %1 brackets within each other", kDeepest));
    }
    return true;
  }
  bool leave() {
    --depth_;
    return true;
  }

  const std::string& name_;
  int depth_ = 0;
};

[[noreturn]] void refuseSize(const std::string& name) {
  throw Error(ErrorCode::kBadData, Text::tr("is larger than %1 MiB", kLargestFile_MiB), name,
              Text::tr("Check that it is the right file"));
}

}  // namespace

std::string jsonTextIn(const std::filesystem::path& file) {
  std::error_code unknown;
  if (std::filesystem::is_regular_file(file, unknown) &&
      std::filesystem::file_size(file, unknown) > kLargestFile_MiB << 20U) {
    refuseSize(file.string());
  }
  std::string text = readFile(file);
  requireSoundJson(text, file.string());
  return text;
}

void requireSoundJson(const std::string& text, const std::string& name) {
  if (text.size() > kLargestFile_MiB << 20U) {
    refuseSize(name);
  }
  SoundJson sound(name);
  (void)nlohmann::json::sax_parse(text, &sound);
}

JsonFields::JsonFields(const nlohmann::json& json, std::string where)
    : json_(json), where_(std::move(where)) {
  if (!json_.is_object()) {
    throw Error(ErrorCode::kBadData, Text::tr("must be an object in braces"), where_,
                Text::tr("Correct the file."));
  }
}

void JsonFields::refuse(const std::string& name, const Text& problem, const Text& remedy) const {
  throw Error(ErrorCode::kBadData, Text::tr("field '%1' %2", name, problem), where_, remedy);
}

bool JsonFields::has(const std::string& name) const {
  return json_.contains(name);
}

const nlohmann::json& JsonFields::find(const std::string& name) {
  asked_.insert(name);
  const auto found = json_.find(name);
  if (found == json_.end()) {
    refuse(name, Text::tr("is missing"), Text::tr("Add it."));
  }
  return *found;
}

const nlohmann::json& JsonFields::child(const std::string& name) {
  return find(name);
}

std::string JsonFields::text(const std::string& name) {
  const nlohmann::json& value = find(name);
  if (!value.is_string()) {
    refuse(name, Text::tr("must be a text"), Text::tr("Put it in quotes."));
  }
  return value.get<std::string>();
}

std::string JsonFields::text(const std::string& name, const std::string& fallback) {
  asked_.insert(name);
  return has(name) ? text(name) : fallback;
}

double JsonFields::number(const std::string& name, double low, double high) {
  const nlohmann::json& value = find(name);
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!(number >= low && number <= high)) {
    std::ostringstream limits;
    limits << "must be a number from " << low << " to " << high;
    if (value.is_number()) {
      limits << ", not " << number;
    }
    refuse(name, limits.str(), Text::tr("Correct the value."));
  }
  return number;
}

double JsonFields::number(const std::string& name, double low, double high, double fallback) {
  asked_.insert(name);
  return has(name) ? number(name, low, high) : fallback;
}

int JsonFields::integer(const std::string& name, int low, int high, int fallback) {
  const double value = number(name, low, high, fallback);
  if (value != std::floor(value)) {
    refuse(name, Text::tr("must be a whole number"), Text::tr("Correct the value."));
  }
  return static_cast<int>(value);
}

bool JsonFields::flag(const std::string& name, bool fallback) {
  asked_.insert(name);
  if (!has(name)) {
    return fallback;
  }
  const nlohmann::json& value = find(name);
  if (!value.is_boolean()) {
    refuse(name, Text::tr("must be true or false"), Text::tr("Correct the value."));
  }
  return value.get<bool>();
}

Vec3 JsonFields::vector(const std::string& name) {
  const nlohmann::json& value = find(name);
  if (!value.is_array() || value.size() != 3 || !value[0].is_number() || !value[1].is_number() ||
      !value[2].is_number()) {
    refuse(name, Text::tr("must be three numbers in brackets"), Text::tr("Write [x, y, z]."));
  }
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

std::size_t JsonFields::choice(const std::string& name, const std::vector<std::string>& names,
                               std::size_t fallback) {
  asked_.insert(name);
  if (!has(name)) {
    return fallback;
  }
  const std::string given = text(name);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == given) {
      return i;
    }
  }
  refuse(name, Text::tr("is '%1'", given), Text::tr("Choose one of %1.", joined(names)));
}

void JsonFields::finish() const {
  for (const auto& item : json_.items()) {
    if (!asked_.contains(item.key())) {
      refuse(item.key(), Text::tr("is not known here"), Text::tr("Remove it, or check its spelling."));
    }
  }
}

}  // namespace torsio
