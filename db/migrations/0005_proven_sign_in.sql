-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: a server proves who signs in
-- compatible_from: 1
--
-- Filled on a PostgreSQL server only, by its own functions (db/repository/people/server_functions.h); no station
-- may read them. Who has signed in, by a hash of the token that the station holds; client: the address from which it
-- counts. practice: with a PIN.
CREATE TABLE server_session (
  token_hash TEXT PRIMARY KEY,
  user_id TEXT NOT NULL REFERENCES app_user (id) ON DELETE CASCADE,
  practice BOOLEAN NOT NULL,
  client TEXT NOT NULL,
  begun_utc_us BIGINT NOT NULL,
  until_utc_us BIGINT NOT NULL
);
CREATE INDEX server_session_user ON server_session (user_id);

-- What goes into every stored password besides the password: without it nobody can try words on what
-- app_user.password_hash holds.
CREATE TABLE password_pepper (
  id BIGINT PRIMARY KEY CHECK (id = 1),
  pepper TEXT NOT NULL
);
