"""What the adapters share that translate a deck for another solver: its review, and what they read of its entries."""
