"""The topology of a deck: nodes, elements, sets, outer faces, contact surfaces, supports, places of loads.

It is the same for every solver, and is what the figure of a model shows. It has no mechanics and needs numpy only.
"""
