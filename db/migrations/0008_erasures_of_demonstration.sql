-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: the tombstone of a simulated person goes with the demonstration data
-- compatible_from: 1

-- Until now not even the gate let an erasure go, so that a simulated person who had been erased on trial could never
-- be removed with the rest of the demonstration.
{{thaw erasure}}
{{append_only erasure}}
