// SPDX-License-Identifier: GPL-3.0-or-later
// Loads organs: the body once for any number of recordings, the movement of a recording, and the painted
// skin.
import { api } from './api.js';
import { readContainer } from './container.js';

const bodies = new Map();
const skins = new Map();

/// Loads the organ of the recording at this path as {meta, arrays} for Morph. Throws Refusal, NoConnection,
/// RangeError.
export async function organOf(path) {
  const moved = readContainer(await api.file(`${path}/organ`));
  return onBody(await once(bodies, moved.meta.body, bringBody), moved);
}

/// Resolves with {width, height, look, corner, place, index, colour, relief}: `corner`: vertex of each drawn
/// corner; `place`: its position on the map in pixels; `colour`, `relief`: ImageBitmap. Null if unavailable:
/// the organ is then drawn in plain colours.
export function skinOf(name) {
  return name ? once(skins, name, bringSkin).catch(() => null) : Promise.resolve(null);
}

/// Appends the recording's own displacements to the shared ones; `weights` cover both.
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

/// Caches a promise; failures are retried the next time.
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
