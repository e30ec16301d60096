"""Builds a hand and a neck with joints."""
