module go_world

go 1.24
