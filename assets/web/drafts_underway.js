// SPDX-License-Identifier: GPL-3.0-or-later
// Drafts of closed cases that are still being saved.

const keepers = new Map(); // path of the case -> DraftKeeper

export function letGoOn(path, keeper) {
  keepers.set(path, keeper);
}

/// Call before another page opens the same case. Resolves when no request is pending.
export async function stopDraft(path) {
  await keepers.get(path)?.stop();
  keepers.delete(path);
}

/// Call when signing out.
export function stopDrafts() {
  for (const keeper of keepers.values()) keeper.stop();
  keepers.clear();
}

export function draftsUnderway() {
  return [...keepers.values()].some((keeper) => keeper.unsaved);
}
