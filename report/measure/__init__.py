"""From processes of thinbench_benchmarks to one table of times: samples, estimates, timings.csv."""
