// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the pages. English is the literal of t() in the sources; app/web/web_texts.cpp lists them, and the
// server sends translations.

const kStored = 'torsio.language';
let texts = {};
let present = 'en';

/// Returns "en" or "zh_CN": the reader's choice, otherwise the browser's language.
export function wantedLanguage() {
  try {
    const stored = localStorage.getItem(kStored);
    if (stored) return stored;
  } catch {
    // no storage
  }
  return navigator.language.toLowerCase().startsWith('zh') ? 'zh_CN' : 'en';
}

export function chooseLanguage(language) {
  try {
    localStorage.setItem(kStored, language);
  } catch {
    // no storage: applies until the page is left
  }
}

export function language() {
  return present;
}

/// Returns the locale for Intl and the lang attribute.
export function locale() {
  return present === 'zh_CN' ? 'zh-CN' : 'en-GB';
}

/// `answer`: of GET /api/texts.
export function useTexts(answer) {
  texts = answer.texts;
  present = answer.language;
}

/// Returns the sentence in the current language; %1 to %9 are replaced by `values`, "%1 {case|cases}" follows
/// the number.
export function t(english, ...values) {
  return filledIn(texts[english] || english, values.map(String));
}

/// Like filledIn() of sim/core/text.h: replaces all placeholders in one pass, so that values may contain
/// placeholders.
export function filledIn(pattern, values) {
  let number = null;
  return pattern.replace(/%([1-9])|\{([^|{}]*)\|([^{}]*)\}/g, (whole, place, one, many) => {
    if (place) {
      const value = values[Number(place) - 1];
      if (value === undefined) return whole;
      number = value;
      return value;
    }
    if (number === null) return whole;
    return number === '1' ? one : many;
  });
}
