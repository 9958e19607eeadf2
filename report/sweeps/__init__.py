"""Sweeps: how times depend on density, size, threads, depth, level and compiler."""

from report.sweeps.section import Section, load_section

__all__ = ["Section", "load_section"]
