// SPDX-License-Identifier: GPL-3.0-or-later
// Error messages: what went wrong and what to do.
import { NoConnection, Refusal } from './api.js';
import { clockTime } from './numbers.js';
import { t } from './texts.js';

/// Returns the message in one line.
export function problemText(error) {
  if (error instanceof NoConnection) return t('The server does not answer. Look at the network, then try again.');
  if (!(error instanceof Refusal)) throw error; // a bug of the pages
  if (error.status === 429 && error.wait_s > 0) return t('Please wait %1, then try again.', clockTime(1e6 * Math.ceil(error.wait_s)));
  if (error.isTransient && !error.code) return t('The server is busy. Try again in a moment.');
  const said = error.message.charAt(0).toUpperCase() + error.message.slice(1);
  return error.remedy ? t('%1. %2', said, error.remedy) : said;
}
