"""What is wrong with a scenario and its parts, found before anything runs."""
