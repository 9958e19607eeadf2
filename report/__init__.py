"""Starts the measuring programs, estimates times from their samples, and makes tables, the page and verdicts of them."""
