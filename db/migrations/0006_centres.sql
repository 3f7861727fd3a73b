-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: a short code of the centre; records of several centres in one
-- compatible_from: 1
--
-- The code by which a centre is told from others, until somebody chooses a better one.
INSERT INTO setting (name, value, changed_utc_us)
  SELECT 'centre.code', 'C' || upper(substr(id, 1, 4)), created_utc_us FROM centre
  WHERE NOT EXISTS (SELECT 1 FROM setting WHERE name = 'centre.code')
  ORDER BY created_utc_us, id LIMIT 1;

-- Centres whose packages were pooled here. public_key: of the first package; every later one must be signed with it.
-- code: by which their people are qualified here, as "NJ" in NJ/T-07.
CREATE TABLE site (
  centre_id TEXT PRIMARY KEY,
  code TEXT NOT NULL UNIQUE,
  name TEXT NOT NULL,
  public_key TEXT NOT NULL,
  first_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL
);
{{frozen site code}}

-- What each package brought. trail_*: head of the centre's own audit trail, by which an older package is told.
CREATE TABLE site_delivery (
  id TEXT PRIMARY KEY,
  centre_id TEXT NOT NULL REFERENCES site (centre_id),
  sequence BIGINT NOT NULL CHECK (sequence >= 1),
  package_hash TEXT NOT NULL,
  made_utc_us BIGINT NOT NULL,
  trail_length BIGINT NOT NULL,
  trail_hash TEXT NOT NULL,
  protocol_hash TEXT NOT NULL,
  rows_added BIGINT NOT NULL,
  left_out BIGINT NOT NULL CHECK (left_out >= 0),
  received_by TEXT NOT NULL,
  received_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  UNIQUE (centre_id, sequence)
);
{{append_only site_delivery}}

-- Which row came with which delivery, and the seal that it has in the record of its centre.
CREATE TABLE site_row (
  delivery_id TEXT NOT NULL REFERENCES site_delivery (id),
  table_name TEXT NOT NULL,
  row_key TEXT NOT NULL,
  site_seal TEXT NOT NULL,
  PRIMARY KEY (delivery_id, table_name, row_key)
);
CREATE INDEX site_row_key ON site_row (row_key, table_name);
{{append_only site_row}}

-- Null: entered here. Else `code` is qualified, and site_code is the code that the centre gave and that stands in its
-- recordings.
ALTER TABLE person ADD COLUMN site_id TEXT REFERENCES site (centre_id);
ALTER TABLE person ADD COLUMN site_code TEXT;
CREATE INDEX person_site ON person (site_id) WHERE site_id IS NOT NULL;
