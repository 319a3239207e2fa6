"""A rotor with a clutch: servo or torque drives it, as the testbed of the thesis."""
