"""What a run tells: its quantities at chosen instants, its measures, its energy, its readings."""
