"""Parameter sweeps: how times depend on one property of the input, or on threads and ISA."""
