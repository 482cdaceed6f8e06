"""A page for who looks on: what each worker sees, how it scores, how long it takes."""
