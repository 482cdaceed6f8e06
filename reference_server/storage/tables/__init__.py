"""The tables of the database, and the migrations that lead to them."""
