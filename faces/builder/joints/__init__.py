"""Builds a hand and a neck with joints, and draws their creases."""
