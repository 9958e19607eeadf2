"""The page of a run, and the tables made with it."""
