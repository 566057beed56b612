"""From the cards of a *CONTACT_... to its force: what all such keywords have in common."""
