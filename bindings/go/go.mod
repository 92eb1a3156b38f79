module gamephys

go 1.18
