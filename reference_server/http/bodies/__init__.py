"""Bodies of requests: read within a size, parsed in steps that block no other one."""
