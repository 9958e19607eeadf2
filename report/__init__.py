"""Turns the raw files of one benchmark run into tables, plots and one page.

The data flows one way through small modules: ``loading`` reads and checks the
three JSON files and hands out a ``model.Study``; ``tables``, ``plots``,
``summary`` and ``page`` each turn a study into finished text or bytes; and
``build`` puts those on disk, only once all of them exist.
"""
