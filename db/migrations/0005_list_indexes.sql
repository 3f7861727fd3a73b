-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: indexes in the order in which lists are shown
-- compatible_from: 1

CREATE INDEX trial_newest ON trial (started_utc_us, id);
DROP INDEX trial_started;
CREATE INDEX trial_station ON trial (station, started_utc_us);
