"""Random heads for tests: shapes of many people, without maps."""
