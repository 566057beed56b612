"""Worker processes: a pool, its messages, time limits; files written whole or not at all."""
