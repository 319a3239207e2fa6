"""Controllers: torque selectors and clutch controllers (thesis Figure 36), one file each."""
