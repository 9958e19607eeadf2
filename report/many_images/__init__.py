"""`./study many-images`: batches of files, workers, calls from Python, dask and large images."""
