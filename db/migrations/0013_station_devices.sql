-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: what each station says about its device, beside its sign of life
-- compatible_from: 1

-- Which device stands there (null: no training station) and what its last check found; null before the first one. The
-- problem is a sentence with its arguments, so that whoever looks reads it in their own language.
ALTER TABLE station_state ADD COLUMN device_json TEXT;
ALTER TABLE station_state ADD COLUMN device_haptic BOOLEAN;
ALTER TABLE station_state ADD COLUMN device_light TEXT CHECK (device_light IN ('green', 'amber', 'red'));
ALTER TABLE station_state ADD COLUMN device_problem_json TEXT;
ALTER TABLE station_state ADD COLUMN device_checked_utc_us BIGINT;
