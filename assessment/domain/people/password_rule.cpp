// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/people/password_rule.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <vector>

#include "sim/core/error.h"

namespace torsio {

namespace {

/// Counts UTF-8 characters: every byte that is not a continuation byte.
std::ptrdiff_t charactersOf(const std::string& text) {
  return std::count_if(text.begin(), text.end(),
                       [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
}

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Minimum number of letters left after the common words are removed.
constexpr std::size_t kMinOwnLetters = 6;

/// Words from lists of leaked passwords, and words that suggest themselves in this program. Not a dictionary:
/// a sentence of plain words is a good password.
constexpr std::string_view kWords[] = {
    "password",   "passwort", "passwords", "passw0rd",   "passphrase", "passcode",      "pass",
    "mima",       "letmein",  "welcome",   "willkommen", "admin",      "administrator", "root",
    "guest",      "login",    "signin",    "logmein",    "default",    "changeme",      "changeit",
    "secret",     "geheim",   "topsecret", "master",     "access",     "system",        "server",
    "computer",   "internet", "test",      "testing",    "tester",     "demo",          "sample",
    "qwertyuiop", "qwerty",   "qwertz",    "qwert",      "azerty",     "asdfghjkl",     "asdfgh",
    "asdf",       "zxcvbnm",  "zxcvbn",    "zxcv",       "qazwsx",     "qaz",           "wsx",
    "edc",        "rfv",      "tgb",       "yhn",        "ujm",        "abcdefgh",      "abcdef",
    "abcd",       "abc",      "iloveyou",  "loveyou",    "lovely",     "love",          "woaini",
    "sunshine",   "princess", "monkey",    "dragon",     "football",   "baseball",      "basketball",
    "soccer",     "hockey",   "superman",  "batman",     "spiderman",  "starwars",      "pokemon",
    "naruto",     "matrix",   "mustang",   "ferrari",    "mercedes",   "porsche",       "liverpool",
    "arsenal",    "chelsea",  "barcelona", "michael",    "jordan",     "jennifer",      "jessica",
    "michelle",   "daniel",   "andrew",    "thomas",     "charlie",    "george",        "joshua",
    "hannah",     "maggie",   "ashley",    "nicole",     "amanda",     "hunter",        "buster",
    "ginger",     "pepper",   "cookie",    "cheese",     "chocolate",  "banana",        "shadow",
    "killer",     "trustno",  "whatever",  "freedom",    "flower",     "angel",         "hello",
    "summer",     "winter",   "spring",    "autumn",     "january",    "february",      "march",
    "april",      "june",     "july",      "august",     "september",  "october",       "november",
    "december",   "monday",   "hospital",  "clinic",     "doctor",     "surgeon",       "surgery",
    "physician",  "trainee",  "torsio",
};

/// Well-known passphrases, letters only.
constexpr std::string_view kSentences[] = {
    "correcthorsebatterystaple",
    "thequickbrownfoxjumpsoverthelazydog",
    "thequickbrownfox",
    "tobeornottobethatisthequestion",
    "tobeornottobe",
    "maytheforcebewithyou",
    "loremipsumdolorsitamet",
    "loremipsumdolor",
    "iloveyouverymuch",
    "onceuponatime",
    "onceuponatimethere",
    "happybirthdaytoyou",
    "twinkletwinklelittlestar",
    "maryhadalittlelamb",
    "youshallnotpass",
    "winteriscoming",
    "openthisdoorplease",
    "thisismypassword",
    "thisisapassword",
    "thisisnotapassword",
    "ihavenopassword",
    "idontknowmypassword",
    "iforgotmypassword",
    "franzjagtimkomplettverwahrlostentaxi",
};

char unmasked(char c) {
  switch (c) {
    case '@':
    case '4':
      return 'a';
    case '0':
      return 'o';
    case '1':
    case '!':
      return 'i';
    case '3':
      return 'e';
    case '$':
    case '5':
      return 's';
    case '7':
      return 't';
    default:
      return c;
  }
}

bool isOwn(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || (static_cast<unsigned char>(c) & 0x80U) != 0;
}

std::string lettersOf(const std::string& text) {
  std::string letters;
  std::copy_if(text.begin(), text.end(), std::back_inserter(letters), isOwn);
  return letters;
}

/// Returns the words, longest first, so that removing a shorter word never splits a longer one.
const std::vector<std::string_view>& wordsByLength() {
  static const std::vector<std::string_view> kSorted = [] {
    std::vector<std::string_view> words(std::begin(kWords), std::end(kWords));
    std::stable_sort(words.begin(), words.end(),
                     [](std::string_view a, std::string_view b) { return a.size() > b.size(); });
    return words;
  }();
  return kSorted;
}

/// True if the text consists of common words with hardly a letter left.
bool isMadeOfWords(std::string text) {
  bool found = false;
  for (const std::string_view word : wordsByLength()) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at)) {
      std::fill_n(text.begin() + static_cast<std::ptrdiff_t>(at), word.size(), ' ');
      found = true;
    }
  }
  return found && lettersOf(text).size() < kMinOwnLetters;
}

/// True for a password that an attacker tries first: common words, years, digits and signs with hardly a
/// letter of its own, the same with 0 for o, @ for a and the like, or a well-known passphrase. Uses a
/// built-in list, no network.
bool isCommonPassword(const std::string& password) {
  const std::string plain = lowered(password);
  std::string bare = plain;
  std::transform(bare.begin(), bare.end(), bare.begin(), unmasked);
  return std::any_of(std::begin(kSentences), std::end(kSentences),
                     [letters = lettersOf(plain)](std::string_view one) { return letters == one; }) ||
         isMadeOfWords(plain) || isMadeOfWords(bare);
}

/// True for a short pattern repeated throughout: "aaaa...", "abcabcabc...".
bool repeats(const std::string& text) {
  constexpr std::size_t kPiece = 5;
  for (std::size_t piece = 1; piece <= kPiece; ++piece) {
    bool same = true;
    for (std::size_t i = piece; i < text.size() && same; ++i) {
      same = text[i] == text[i - piece];
    }
    if (same) {
      return true;
    }
  }
  return false;
}

/// True for a run along the keyboard or the alphabet: "123456789...", "qwertyuiop...".
bool isRun(const std::string& text) {
  static constexpr std::array<const char*, 3> kRuns{"12345678901234567890123456789012345678901234567890",
                                                    "abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz",
                                                    "qwertyuiopasdfghjklzxcvbnmqwertyuiopasdfghjklzxcvbnm"};
  return std::any_of(kRuns.begin(), kRuns.end(),
                     [&](const char* run) { return std::string(run).find(text) != std::string::npos; });
}

[[noreturn]] void refuse(const Text& what, const Text& remedy) {
  refuseParameter(what, Text::tr("password"), remedy);
}

}  // namespace

void checkPassword(const std::string& password, const std::string& login) {
  if (charactersOf(password) < kShortestPassword) {
    refuse(Text::tr("the password is shorter than %1 characters", kShortestPassword),
           Text::tr("Use a sentence: spaces and any letters are allowed"));
  }
  if (password.size() > static_cast<std::size_t>(kLongestPassword)) {
    refuse(Text::tr("the password is too long"), Text::tr("Shorten it"));
  }
  const std::string plain = lowered(password);
  const std::string name = lowered(login);
  if (isCommonPassword(password)) {
    refuse(Text::tr("the password is too easy to guess"), Text::tr("Use a sentence of your own"));
  }
  if (repeats(plain) || isRun(plain)) {
    refuse(Text::tr("the password is a simple pattern"), Text::tr("Use a sentence of your own"));
  }
  if (name.size() >= 3 && plain.size() < name.size() + 8 && plain.find(name) != std::string::npos) {
    refuse(Text::tr("the password is little more than the login name"),
           Text::tr("Use a sentence of your own"));
  }
}

}  // namespace torsio
