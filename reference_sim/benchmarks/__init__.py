"""The benchmarks that come with Proctor."""
