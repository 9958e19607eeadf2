"""`./study many-images`: batches of files, workers, dask and images larger than memory, measured."""
