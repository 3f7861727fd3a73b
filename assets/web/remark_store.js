// SPDX-License-Identifier: GPL-3.0-or-later
// Remarks of a case at the server. Each function promises the list as it is then.
import { api, NoConnection } from './api.js';

/// `path()`: of the case. A new remark whose answer got lost is looked for before it is sent again.
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
