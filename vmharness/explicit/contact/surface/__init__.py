"""Contact surfaces of the deck: faces of shells and solids, their penalty stiffness and thickness, and their nodes."""
