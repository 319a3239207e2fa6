"""From the tables of a scenario file to parts: kinds by name, fields by their metadata."""
