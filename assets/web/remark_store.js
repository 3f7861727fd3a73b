// SPDX-License-Identifier: GPL-3.0-or-later
// Stores remarks of a case on the server. Each function promises the resulting list.
import { api, NoConnection } from './api.js';

/// `path()`: of the case. If the answer to a new remark was lost, looks for the remark before sending it
/// again.
export function remarkStore(path) {
  let doubtful = false;
  return {
    async add(time_us, text) {
      if (doubtful) {
        const { remarks } = await api.get(path());
        doubtful = false;
        if (remarks.some((one) => one.time_us === time_us && one.text === text)) return remarks;
      }
      try {
        return (await api.post(`${path()}/remarks`, { time_us, text })).remarks;
      } catch (error) {
        doubtful = error instanceof NoConnection;
        throw error;
      }
    },
    async edit(id, text) {
      return (await api.put(`${path()}/remarks/${encodeURIComponent(id)}`, { text })).remarks;
    },
  };
}
