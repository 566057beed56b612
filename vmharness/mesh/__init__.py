"""The topology of a deck: nodes, elements, sets, outer faces, contact surfaces, supports, places of loads.

What a picture of the model shows, and what every solver reads alike; numpy alone, and no mechanics.
"""
