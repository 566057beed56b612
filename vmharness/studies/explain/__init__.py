"""Value less target, cause by cause; the reading that gives a published column."""
