// SPDX-License-Identifier: GPL-3.0-or-later
// Talks to the server. Knows its errors and the token of the session; shows nothing.
import { language } from './texts.js';

const kPatience_ms = 20_000;
const kPatienceForFiles_ms = 120_000;

/// The server refused. `code` as it names it; `what`, `remedy` in the reader's language; `body`: all it said.
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
  /// Later the same request may be granted.
  get passes() {
    return this.status === 429 || this.status >= 500;
  }
}

/// No answer: the network is away, or the server.
export class NoConnection extends Error {}

let token = '';
let onSignedOut = () => {};

export function useToken(fresh) {
  token = fresh;
}

/// `handler` hears of each request that was refused because nobody is signed in.
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
    return null; // a proxy's page, or a connection that ended in the middle
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
  const value = await jsonOf(answer);
  if (value === null) throw new NoConnection('the answer broke off');
  return value;
}

/// `quiet`: a 401 is an answer like others and no end of the session. `last`: the page may be gone before the
/// answer.
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
