"""`./study many-images`: batches of files, workers, dask and large images, measured and plotted."""
