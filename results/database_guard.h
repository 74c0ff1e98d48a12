// A run's database may come from anybody: what of it is refused before anything in it is believed. Private to results/.
//
// SQLite believes the files beside a database: a journal is played back into it, and may name a further file, which
// SQLite then deletes; a write-ahead log takes the place of what the database holds. And it obeys the schema: triggers,
// views, defaults and checks are programs. dobbench makes none of these but one view for readers, which it never reads.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <filesystem>

namespace dob {

// Before it is opened. Throws StoreError if the database, or a journal beside it, is no plain file, if the journal
// names another file, or if there is a write-ahead log.
void require_harmless_files(const std::filesystem::path& file);

// Right after it has been opened: no triggers, no views, no more than `attached` others attached, no function that has
// an effect in a schema.
void distrust(SQLite::Database& database, int attached = 0);

// Throws StoreError for whatever is in the schema that no dobbench puts there, and if SQLite's own check finds it
// damaged.
void require_sound(SQLite::Database& database, const std::filesystem::path& file);

}  // namespace dob
