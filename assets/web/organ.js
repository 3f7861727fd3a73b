// SPDX-License-Identifier: GPL-3.0-or-later
// What the server sends of an organ: its body once, whatever number of recordings show it; how it was moved, and its
// painted skin.
import { api } from './api.js';
import { readContainer } from './container.js';

const bodies = new Map();
const skins = new Map();

/// {meta, arrays} as Morph takes them, of the recording at this path. Throws Refusal, NoConnection, RangeError.
export async function organOf(path) {
  const moved = readContainer(await api.file(`${path}/organ`));
  return onBody(await once(bodies, moved.meta.body, bringBody), moved);
}

/// {width, height, look, corner, place, index, colour, relief}: `corner` says whose vertex each drawn corner is,
/// `place` where it lies on the map, pixels; `colour`, `relief`: ImageBitmap. Null where it cannot be had: the
/// organ has its plain colours then.
export function skinOf(name) {
  return name ? once(skins, name, bringSkin).catch(() => null) : Promise.resolve(null);
}

/// A recording's own displacements follow those that it shares with others; `weights` are of both.
export function onBody(body, moved) {
  const joined = (name) => {
    const all = new Int16Array(body.arrays[name].length + moved.arrays[name].length);
    all.set(body.arrays[name]);
    all.set(moved.arrays[name], body.arrays[name].length);
    return all;
  };
  const scale = [...body.meta.scale, ...moved.meta.scale];
  return {
    meta: { ...body.meta, ...moved.meta, components: scale.length, scale },
    arrays: { ...body.arrays, ...moved.arrays, basis: joined('basis') },
  };
}

/// What did not come is asked for again the next time.
function once(kept, name, bring) {
  if (!kept.has(name)) {
    const coming = bring(`/api/organs/${name}`);
    coming.catch(() => kept.delete(name));
    kept.set(name, coming);
  }
  return kept.get(name);
}

async function bringBody(path) {
  return readContainer(await api.file(path));
}

async function bringSkin(path) {
  const { meta, arrays } = readContainer(await api.file(path));
  const options = { colorSpaceConversion: 'none', premultiplyAlpha: 'none' };
  const decoded = (bytes) => createImageBitmap(new Blob([bytes], { type: 'image/jpeg' }), options);
  const [colour, relief] = await Promise.all([decoded(arrays.colour), decoded(arrays.relief)]);
  return { ...meta, ...arrays, colour, relief };
}
