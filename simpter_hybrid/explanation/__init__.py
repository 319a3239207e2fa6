"""Why it slipped here: an event taken apart, what could have followed, and the words."""
