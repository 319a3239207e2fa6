"""What all rigs share: how a record drives a scenario, and what its sensors make of the motion."""
