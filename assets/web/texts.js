// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences of the pages. English stands in the sources as a literal of t(); app/web/web_texts.cpp
// lists it, and the server sends the translations.

const kStored = 'torsio.language';
let texts = {};
let present = 'en';

/// "en" or "zh_CN": what the reader chose, else what the browser asks for.
export function wantedLanguage() {
  try {
    const stored = localStorage.getItem(kStored);
    if (stored) return stored;
  } catch {
    // a browser that keeps nothing
  }
  return navigator.language.toLowerCase().startsWith('zh') ? 'zh_CN' : 'en';
}

export function chooseLanguage(language) {
  try {
    localStorage.setItem(kStored, language);
  } catch {
    // then it holds until the page is left
  }
}

export function language() {
  return present;
}

/// For Intl and the lang attribute.
export function locale() {
  return present === 'zh_CN' ? 'zh-CN' : 'en-GB';
}

/// `answer` of GET /api/texts.
export function useTexts(answer) {
  texts = answer.texts;
  present = answer.language;
}

/// The sentence in the present language; %1 to %9 stand for `values`, "%1 {case|cases}" follows the number.
export function t(english, ...values) {
  return filledIn(texts[english] || english, values.map(String));
}

/// As filledIn() of sim/core/text.h: all places in one pass, so that a value may look like a place.
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
