"""`./study regress`: did variants become slower? docs/regression.md says how it decides."""
