module smpp_commands

go 1.25.0

require (
	github.com/fiorix/go-smpp/v2 v2.1.0
	github.com/linxGnu/gosmpp v0.3.0
)

require (
	github.com/orcaman/concurrent-map/v2 v2.0.1 // indirect
	golang.org/x/exp v0.0.0-20240604190554-fc45aab8b7f8 // indirect
	golang.org/x/text v0.36.0 // indirect
)
