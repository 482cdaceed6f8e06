module proctor

go 1.23
