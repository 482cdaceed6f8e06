"""The workers of an evaluation, in threads or in processes of their own."""
