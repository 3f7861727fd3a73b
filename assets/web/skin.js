// SPDX-License-Identifier: GPL-3.0-or-later
// The painted skin of an organ: brought once, whatever number of cases show it.
import { api } from './api.js';
import { readContainer } from './container.js';

const skins = new Map();

/// {width, height, look, corner, place, index, colour, relief}: `corner` says whose vertex each drawn corner is,
/// `place` where it lies on the map, pixels; `colour`, `relief`: ImageBitmap. Null where it cannot be had: the
/// organ has its plain colours then.
export function skinOf(name) {
  if (!name) return Promise.resolve(null);
  if (!skins.has(name)) {
    const coming = bring(name).catch(() => {
      skins.delete(name); // the next case asks again
      return null;
    });
    skins.set(name, coming);
  }
  return skins.get(name);
}

async function bring(name) {
  const { meta, arrays } = readContainer(await api.file(`/api/skins/${name}`));
  const options = { colorSpaceConversion: 'none', premultiplyAlpha: 'none' };
  const decoded = (bytes) => createImageBitmap(new Blob([bytes], { type: 'image/jpeg' }), options);
  const [colour, relief] = await Promise.all([decoded(arrays.colour), decoded(arrays.relief)]);
  return { ...meta, ...arrays, colour, relief };
}
