// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { NoConnection, Refusal } from '../../../assets/web/api.js';
import { DraftKeeper } from '../../../assets/web/draft_keeper.js';

/// A server that answers on the test's command, and a keeper that never really waits.
function desk() {
  const made = { asked: [], states: [], waits: [], saved: [] };
  made.sheet = { revision: 0, rows: [], overall_steps: null, comment: '' };
  made.keeper = new DraftKeeper({
    put: (sheet) => new Promise((grant, refuse) => made.asked.push({ sheet: { ...sheet }, grant, refuse })),
    onSaved: (answer) => {
      made.sheet.revision = answer.revision;
      made.saved.push(answer.revision);
    },
    onChange: ({ state }) => made.states.push(state),
    wait: (ms) => new Promise((done) => made.waits.push({ ms, done })),
  });
  made.type = (comment) => {
    made.sheet.comment = comment;
    made.keeper.change(() => ({ ...made.sheet }));
  };
  return made;
}

const turn = () => new Promise((done) => setTimeout(done));

function refusal(status, body = {}, wait_s = 0) {
  return new Refusal(status, { error: { code: 'x', what: 'said' }, ...body }, wait_s);
}

test('one request at a time, and the newest sheet wins', async () => {
  const { type, asked, keeper } = desk();
  type('a');
  type('ab');
  type('abc');
  assert.deepEqual(asked.map((one) => one.sheet.comment), ['a']);
  asked[0].grant({ revision: 1 });
  await turn();
  assert.deepEqual(asked.map((one) => one.sheet.comment), ['a', 'abc']);
  assert.equal(asked[1].sheet.revision, 1);
  assert.equal(keeper.state, 'saving');
  asked[1].grant({ revision: 2 });
  await turn();
  assert.equal(keeper.state, 'saved');
  assert.equal(keeper.unsaved, false);
});

test('a network that is away is tried again, later and later, with what is newest', async () => {
  const { type, asked, keeper, waits } = desk();
  type('a');
  for (let i = 0; i < 7; ++i) {
    asked.at(-1).refuse(new NoConnection());
    await turn();
    assert.equal(keeper.state, 'waiting');
    waits.at(-1).done();
    await turn();
  }
  assert.deepEqual(waits.map((one) => one.ms), [500, 1000, 2000, 4000, 8000, 15000, 15000]);
  type('ab');
  asked.at(-1).refuse(refusal(503, {}, 30));
  await turn();
  assert.equal(waits.at(-1).ms, 30000);
  waits.at(-1).done();
  await turn();
  assert.equal(asked.at(-1).sheet.comment, 'ab');
  asked.at(-1).grant({ revision: 1 });
  await turn();
  assert.equal(keeper.state, 'saved');
});

test('a newer sheet at the server is asked about; mine on top carries its revision', async () => {
  const { type, asked, keeper, sheet } = desk();
  type('mine');
  asked[0].refuse(refusal(409, { sheet: { revision: 8, rows: [], overall_steps: null, comment: 'theirs' } }));
  await turn();
  assert.equal(keeper.state, 'conflict');
  type('mine, more');
  assert.equal(asked.length, 1);
  sheet.revision = keeper.newer.revision;
  keeper.keepMine(() => ({ ...sheet }));
  await turn();
  assert.deepEqual([asked[1].sheet.revision, asked[1].sheet.comment], [8, 'mine, more']);
  asked[1].grant({ revision: 9 });
  await turn();
  assert.equal(keeper.state, 'saved');
});

test('taking the newer sheet ends the conflict without a request', async () => {
  const { type, asked, keeper } = desk();
  type('mine');
  asked[0].refuse(refusal(409, { sheet: { revision: 8, rows: [], overall_steps: null, comment: 'theirs' } }));
  await turn();
  keeper.takeNewer();
  await turn();
  assert.equal(asked.length, 1);
  assert.equal(keeper.unsaved, false);
});

test('an own save whose answer got lost is no conflict', async () => {
  const { type, asked, keeper, waits } = desk();
  type('a');
  asked[0].refuse(new NoConnection());
  await turn();
  type('ab');
  waits[0].done();
  await turn();
  asked[1].refuse(refusal(409, { sheet: { revision: 1, rows: [], overall_steps: null, comment: 'a' } }));
  await turn();
  assert.deepEqual([asked[2].sheet.revision, asked[2].sheet.comment], [1, 'ab']);
  asked[2].grant({ revision: 2 });
  await turn();
  assert.equal(keeper.state, 'saved');
});

test('an ended session keeps what was typed until somebody is back', async () => {
  const { type, asked, keeper } = desk();
  type('a');
  asked[0].refuse(refusal(401));
  await turn();
  assert.equal(keeper.state, 'signed_out');
  type('ab');
  assert.equal(asked.length, 1);
  keeper.resume();
  assert.equal(asked[1].sheet.comment, 'ab');
});

test('a refusal is told; the next change tries again', async () => {
  const { type, asked, keeper } = desk();
  type('a');
  asked[0].refuse(refusal(400));
  await turn();
  assert.equal(keeper.state, 'refused');
  assert.equal(keeper.problem.message, 'said');
  type('ab');
  asked[1].grant({ revision: 1 });
  await turn();
  assert.equal(keeper.state, 'saved');
});

test('settled waits for what is under way, and not for a network that is away', async () => {
  const { type, asked, keeper } = desk();
  type('a');
  const first = keeper.settled();
  asked[0].grant({ revision: 1 });
  assert.equal(await first, true);
  type('ab');
  const second = keeper.settled();
  asked[1].refuse(new NoConnection());
  assert.equal(await second, false);
});
