"""A hand and a neck with joints, and the creases at these joints."""
