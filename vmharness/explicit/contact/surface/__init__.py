"""Contact surfaces of the deck: faces of shells and solids, with their penalty stiffness and thickness, and nodes."""
