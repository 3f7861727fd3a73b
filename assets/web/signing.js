// SPDX-License-Identifier: GPL-3.0-or-later
// An act that is signed: the password is asked for where the signature wants it.
import { askSignature } from './dialogs.js';
import { problemText } from './problem.js';

/// A password that was not asked for is not sent.
export function shownPassword(password) {
  return password === null ? {} : { password };
}

/// Sends by `send(password)`; asks for the password until it is right or given up. False: given up. Throws what `send`
/// throws else.
export async function signed(send, login, password = null, meaning = '') {
  try {
    await send(password);
    return true;
  } catch (error) {
    const asked = error.status === 403 && error.body.need_password;
    if (!asked && (error.status !== 403 || password === null)) throw error;
    const means = error.body.meaning ?? meaning;
    const problem = asked && password === null ? '' : problemText(error);
    const given = await askSignature({ meaning: means, login, problem });
    return given === null ? false : signed(send, login, given, means);
  }
}
