"""Builds the head of a person: skin, eyes, mouth, hair and a shirt."""
