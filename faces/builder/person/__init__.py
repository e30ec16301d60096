"""A person: the skin of the head, and eyes, mouth, hair and clothes on it."""
