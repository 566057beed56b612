"""What cards refer to by number, and whether the deck defines it; reviewed before a model is built.

cards.py     which fields refer to what: curves, nodes, sets, parts, rigid bodies
parts.py     what the parts of elements need: section, material, hourglass control
defined.py   the numbers that a deck defines, and what is said of one that is missing
"""
