// The local registry: distribution's own program with one storage driver, the file system. Its stock program links the drivers of
// three clouds, which double the time of the build. Two of its three ways to ask for a password are for tests alone.
package main

import (
	"crypto/subtle"
	"errors"
	"net/http"
	"os"
	"strings"

	"github.com/distribution/distribution/v3/registry"
	"github.com/distribution/distribution/v3/registry/auth"
	_ "github.com/distribution/distribution/v3/registry/auth/htpasswd"
	_ "github.com/distribution/distribution/v3/registry/auth/token"
	_ "github.com/distribution/distribution/v3/registry/storage/driver/filesystem"
)

// writers lets everybody read. Who writes or deletes has to know a password: steps of a build, which run code of strangers, share
// the network of the machine with this registry, and have none.
type writers struct{ password string }

func (w writers) Authorized(request *http.Request, records ...auth.Access) (*auth.Grant, error) {
	reads := true
	for _, record := range records {
		// The list of repositories has a type and an action of its own.
		reads = reads && (record.Action == "pull" || record.Type == "registry" && request.Method == http.MethodGet)
	}
	_, password, _ := request.BasicAuth()
	if !reads && subtle.ConstantTimeCompare([]byte(password), []byte(w.password)) != 1 {
		return nil, challenge{}
	}
	return &auth.Grant{User: auth.UserInfo{Name: "rosml"}}, nil
}

type challenge struct{}

func (challenge) Error() string { return "who writes to this registry needs its password" }

func (challenge) SetHeaders(_ *http.Request, answer http.ResponseWriter) {
	answer.Header().Set("WWW-Authenticate", `Basic realm="rosml"`)
}

func newWriters(options map[string]any) (auth.AccessController, error) {
	path, _ := options["path"].(string)
	content, err := os.ReadFile(path)
	if err != nil {
		return nil, err
	}
	password := strings.TrimSpace(string(content))
	if password == "" {
		return nil, errors.New("the file with the password is empty")
	}
	return writers{password}, nil
}

func main() {
	if auth.Register("writers", newWriters) != nil || registry.RootCmd.Execute() != nil {
		os.Exit(1)
	}
}
