// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const kRoot = fileURLToPath(new URL('../../../', import.meta.url));

test('the list for translation contains exactly the sentences of the pages', () => {
  const pages = `${kRoot}assets/web/`;
  const said = new Set();
  for (const file of readdirSync(pages).filter((name) => name.endsWith('.js'))) {
    const source = readFileSync(pages + file, 'utf8');
    for (const [, , text] of source.matchAll(/\bt\(\s*(['"])((?:(?!\1)[^\\])*)\1/g)) said.add(text);
  }
  const list = readFileSync(`${kRoot}app/web/web_texts.cpp`, 'utf8');
  const listed = [...list.matchAll(/Text::tr\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)\)/g)].map(([, literals]) =>
    [...literals.matchAll(/"((?:[^"\\]|\\.)*)"/g)].map(([, part]) => part.replaceAll('\\"', '"')).join(''));
  assert.deepEqual(listed.sort(), [...said].sort());
});
