"""Builds a clothed figure with joints."""
