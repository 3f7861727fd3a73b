// SPDX-License-Identifier: GPL-3.0-or-later
// Drafts of cases that were left while they were still on their way to the server.

const keepers = new Map(); // path of the case -> DraftKeeper

export function letGoOn(path, keeper) {
  keepers.set(path, keeper);
}

/// Before a page of the same case takes over. Resolves when nothing is under way.
export async function stopDraft(path) {
  await keepers.get(path)?.stop();
  keepers.delete(path);
}

/// Somebody signs out.
export function stopDrafts() {
  for (const keeper of keepers.values()) keeper.stop();
  keepers.clear();
}

export function draftsUnderway() {
  return [...keepers.values()].some((keeper) => keeper.unsaved);
}
