"""A person: skin of the head, eyes, mouth, hair and clothes."""
