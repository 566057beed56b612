"""*ELEMENT: elements and their nodes."""
