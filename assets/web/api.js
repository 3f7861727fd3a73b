// SPDX-License-Identifier: GPL-3.0-or-later
// HTTP client: errors, session token. Shows nothing.
import { language } from './texts.js';

const kPatience_ms = 20_000;
const kPatienceForFiles_ms = 120_000;

/// A refusal by the server: its `code`; `what` and `remedy` in the reader's language; `body`: the whole
/// answer.
export class Refusal extends Error {
  constructor(status, body, wait_s) {
    const error = body?.error ?? {};
    super(error.what ?? `HTTP ${status}`);
    this.status = status;
    this.code = error.code ?? '';
    this.where = error.where ?? '';
    this.remedy = error.remedy ?? '';
    this.body = body ?? {};
    this.wait_s = wait_s;
  }
  get needsSignIn() {
    return this.status === 401;
  }
  /// True if the same request may succeed later.
  get isTransient() {
    return this.status === 429 || this.status >= 500;
  }
}

/// No answer: the network or the server is down.
export class NoConnection extends Error {}

let token = '';
let onSignedOut = () => {};

export function useToken(fresh) {
  token = fresh;
}

/// `handler` is called for each request refused because nobody is signed in.
export function whenSignedOut(handler) {
  onSignedOut = handler;
}

async function ask(method, path, body, { patience_ms = kPatience_ms, accept = 'application/json', last = false, inLanguage = language() }) {
  const headers = { Accept: accept, 'X-Torsio-Language': inLanguage };
  if (method !== 'GET') {
    headers['Content-Type'] = 'application/json';
    headers['X-Torsio-Token'] = token;
  }
  try {
    return await fetch(path, {
      method,
      headers,
      body: body === undefined ? undefined : JSON.stringify(body),
      credentials: 'same-origin',
      cache: method === 'GET' && accept !== 'application/json' ? 'default' : 'no-store',
      keepalive: last,
      signal: AbortSignal.timeout(patience_ms),
    });
  } catch (error) {
    throw new NoConnection(error.message);
  }
}

async function jsonOf(answer) {
  try {
    return await answer.json();
  } catch {
    return null; // a proxy's page, or a truncated answer
  }
}

async function refuse(answer, quiet) {
  const body = await jsonOf(answer);
  const wait_s = Number(body?.error?.wait_s ?? body?.wait_s ?? answer.headers.get('Retry-After') ?? 0);
  const refusal = new Refusal(answer.status, body, Number.isFinite(wait_s) ? wait_s : 0);
  if (refusal.needsSignIn && !quiet) onSignedOut();
  throw refusal;
}

async function json(method, path, body, options = {}) {
  const answer = await ask(method, path, body, options);
  if (!answer.ok) await refuse(answer, options.quiet);
  if (answer.status === 204) return null; // nothing new
  const value = await jsonOf(answer);
  if (value === null) throw new NoConnection('the answer broke off');
  return value;
}

/// `quiet`: treats a 401 as an ordinary answer, not as the end of the session. `last`: the page may be closed
/// before the answer.
export const api = {
  get: (path, options) => json('GET', path, undefined, options),
  post: (path, body, options) => json('POST', path, body, options),
  put: (path, body, options) => json('PUT', path, body, options),
  async file(path) {
    const options = { patience_ms: kPatienceForFiles_ms, accept: 'application/octet-stream' };
    const answer = await ask('GET', path, undefined, options);
    if (!answer.ok) await refuse(answer, false);
    try {
      return await answer.arrayBuffer();
    } catch (error) {
      throw new NoConnection(error.message);
    }
  },
};
