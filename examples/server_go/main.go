// A Proctor server in Go, standard library only, written from spec/ and docs/ alone. It
// serves the benchmark `calibration` with the profiles core, msgpack, compare and events.
//
// Settings by flag or environment: PROCTOR_HOST, PROCTOR_PORT (0: any free one),
// PROCTOR_DATABASE (the journal; without it, runs live in memory) and PROCTOR_TOKENS
// (`account:scopes:token`, comma-separated). Where to read on: README.md of examples/.
package main

import (
	"cmp"
	"flag"
	"fmt"
	"log"
	"net"
	"net/http"
	"os"
	"time"

	"proctor-server-go/api"
	"proctor-server-go/runs"
)

func main() {
	environment := func(name, absent string) string { return cmp.Or(os.Getenv(name), absent) }
	host := flag.String("host", environment("PROCTOR_HOST", "127.0.0.1"), "address to listen on")
	port := flag.String("port", environment("PROCTOR_PORT", "8460"), "port; 0 for any free one")
	database := flag.String("database", os.Getenv("PROCTOR_DATABASE"), "journal; empty for none")
	public := flag.String("url", "", "URL by which clients reach this server, if not its address")
	flag.Parse()

	tokens, err := api.ReadTokens(os.Getenv("PROCTOR_TOKENS"))
	if err != nil {
		log.Fatal(err)
	}
	listener, err := net.Listen("tcp", net.JoinHostPort(*host, *port))
	if err != nil {
		log.Fatal(err)
	}
	address := cmp.Or(*public, "http://"+listener.Addr().String()) // RUN-016
	journal, records, err := runs.OpenJournal(*database)
	if err != nil {
		log.Fatal(err)
	}
	registry, err := runs.NewRegistry(journal, records, address)
	if err != nil {
		log.Fatal(err)
	}
	fmt.Println("listening on " + address)
	service := &http.Server{
		Handler: &api.Server{Registry: registry, Tokens: tokens}, ReadHeaderTimeout: 10 * time.Second,
		DisableGeneralOptionsHandler: true,
	}
	log.Fatal(service.Serve(listener))
}
