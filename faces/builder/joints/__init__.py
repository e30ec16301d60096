"""A hand and a neck with joints and creases."""
