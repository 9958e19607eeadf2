"""From the sampler's processes to one table of times: plan, samples, estimates, timings.csv."""
