"""The robot: positions, the force on its tip and the commands of its clutches."""
