"""From measured data to the effect a model lacks."""
