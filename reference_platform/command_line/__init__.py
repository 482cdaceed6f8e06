"""`proctor-host` starts the platform; `proctor admin account` and others change it."""
