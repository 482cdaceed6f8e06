module proctor-server-go

go 1.24
