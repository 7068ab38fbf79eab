// Writes a small database for trivy, with trivy's own library and in the way of its own builder: advisories that a test
// gives as JSON on standard input, into the folder that is the only argument.
package main

import (
	"encoding/json"
	"log"
	"os"
	"time"

	"github.com/aquasecurity/trivy-db/pkg/db"
	"github.com/aquasecurity/trivy-db/pkg/metadata"
	"github.com/aquasecurity/trivy-db/pkg/types"
	bolt "go.etcd.io/bbolt"
)

// Known is one advisory about one package.
type Known struct {
	Source      string // bucket: "debian 12", "pip::GitHub Security Advisory Pip"
	Package     string // Debian: of the source package
	ID          string
	Severity    string // LOW to CRITICAL
	Title       string
	Fixed       string   // Debian: version that mends it; empty where none does
	Vulnerable  []string // Python: ranges
	Patched     []string // Python: versions
	PublishedBy string   // name of the data source
}

type request struct {
	Updated    time.Time
	Advisories []Known
}

func main() {
	log.SetFlags(0)
	folder := os.Args[1]
	var asked request
	if err := json.NewDecoder(os.Stdin).Decode(&asked); err != nil {
		log.Fatalf("standard input: %v", err)
	}
	if err := db.Init(folder); err != nil {
		log.Fatal(err)
	}
	store := db.Config{}
	if err := store.BatchUpdate(func(tx *bolt.Tx) error { return put(store, tx, asked.Advisories) }); err != nil {
		log.Fatal(err)
	}
	if err := store.DeleteAdvisoryDetailBucket(); err != nil && len(asked.Advisories) > 0 {
		log.Fatal(err)
	}
	if err := db.Close(); err != nil {
		log.Fatal(err)
	}
	facts := metadata.Metadata{
		Version:    db.SchemaVersion,
		UpdatedAt:  asked.Updated,
		NextUpdate: asked.Updated.Add(24 * time.Hour),
	}
	if err := metadata.NewClient(folder).Update(facts); err != nil {
		log.Fatal(err)
	}
}

func put(store db.Config, tx *bolt.Tx, advisories []Known) error {
	for _, known := range advisories {
		severity, err := types.NewSeverity(known.Severity)
		if err != nil {
			return err
		}
		source := types.DataSource{ID: types.SourceID(known.PublishedBy), Name: known.PublishedBy}
		if err := store.PutDataSource(tx, known.Source, source); err != nil {
			return err
		}
		advisory := types.Advisory{
			FixedVersion:       known.Fixed,
			VulnerableVersions: known.Vulnerable,
			PatchedVersions:    known.Patched,
		}
		if err := store.PutAdvisoryDetail(tx, known.ID, known.Package, []string{known.Source}, advisory); err != nil {
			return err
		}
		if err := store.SaveAdvisoryDetails(tx, known.ID); err != nil {
			return err
		}
		detail := types.Vulnerability{Title: known.Title, Severity: severity.String()}
		if err := store.PutVulnerability(tx, known.ID, detail); err != nil {
			return err
		}
	}
	return nil
}
