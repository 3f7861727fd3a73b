// SPDX-License-Identifier: GPL-3.0-or-later
// Signed acts: asks for the password if the signature requires it.
import { askSignature } from './dialogs.js';
import { problemText } from './problem.js';

/// Omits a password that was not requested.
export function shownPassword(password) {
  return password === null ? {} : { password };
}

/// Calls `send(password)`, asking for the password until it is right or cancelled. False: cancelled. Rethrows
/// other errors of `send`.
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
