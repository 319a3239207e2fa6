"""What a diagnosis says: sentences, data for machines, and the page."""
