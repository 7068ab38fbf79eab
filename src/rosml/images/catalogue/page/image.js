// One image: what to write after FROM, what is inside on each platform, how large, and what changed from night to night.
"use strict";

(() => {
  const r = window.rosml;
  const { el } = r;

  /** Lines and files by a tag that one chooses, or pinned to its digest. */
  function use(image) {
    const build = r.present(image);
    const pin = el("input", { type: "checkbox", onchange: () => shown.again() });
    const tag = el(
      "select",
      { id: "tag", onchange: () => shown.again() },
      image.tags.map((item) => el("option", { value: item.name }, `${item.name} (${KINDS[item.kind]})`)),
    );
    const reference = () => {
      const found = image.tags.find((item) => item.name === tag.value);
      return `${r.reference(image, tag.value)}${pin.checked ? `@${found.digest}` : ""}`;
    };
    const { usage } = r;
    const items = [
      ["docker run", () => r.snippet(usage.run(image, reference()), "Copy the docker run line")],
      ["Dockerfile", () => r.snippet(`FROM ${reference()}`, "Copy the FROM line")],
      ["compose", () => r.snippet(usage.compose(image, reference()), "Copy compose.yaml", "compose.yaml")],
      [
        "dev container",
        () =>
          Object.entries(usage.devcontainer(image, reference())).map(([name, text]) => r.snippet(text, `Copy ${name}`, name)),
      ],
    ];
    if (build.signed.length)
      items.push(["cosign", () => usage.verify(image, build).map((line) => r.snippet(line, "Copy the cosign line"))]);
    const shown = r.tabs(
      "Ways to use it",
      items.map(([title, panel]) => ({ title, panel: () => [panel()].flat() })),
    );
    return el(
      "section",
      { "aria-labelledby": "use" },
      el("h2", { id: "use" }, "Use it"),
      shown.node,
      el(
        "div",
        { class: "choices" },
        el("span", { class: "choose" }, el("label", { for: "tag" }, "Tag"), tag),
        el("label", { class: "choice" }, pin, el("span", null, "pin to the digest")),
      ),
    );
  }

  /** What an image that is not published will be called, and how to build it. */
  function later(image) {
    return el(
      "section",
      { "aria-labelledby": "later" },
      el("h2", { id: "later" }, "Not published yet"),
      el("p", null, "Build it in a checkout:"),
      r.snippet(`./rosml image ${image.target}`, "Copy the command that builds it"),
      el("p", null, "Once a publishing run has built it, it has these tags:"),
      el(
        "ul",
        { class: "mono" },
        image.promised_tags.map((tag) => el("li", null, `${image.repository}:${tag}`)),
      ),
    );
  }

  /** The add-ons that a published image can take, and the commands for that. */
  function more(image) {
    const reference = r.reference(image, r.mainTag(image));
    const items = Object.entries(image.takes).map(([name, { addon, parts, platforms }]) => {
      const { title, restricted } = r.catalogue.addons[addon];
      const only = platforms.length < image.platforms.length ? ` for ${platforms.join(", ")}` : "";
      const braced = parts.length > 1 ? `{${parts.join(",")}}` : parts[0];
      return el(
        "details",
        null,
        el("summary", null, `${name}: ${title}${only}${restricted ? ", in private registries alone" : ""}`),
        r.snippet(
          `rosml containerize --base-image ${reference} --addons ${name}`,
          `Copy the command that takes ${name} for your packages`,
          "Onto the base image of your packages",
        ),
        r.snippet(
          `rosml join ${reference} ${r.catalogue.registry}/part:${braced} --tag NAME`,
          `Copy the command that joins ${name} and this image`,
          "Onto this image, in a registry",
        ),
      );
    });
    if (!items.length) return null;
    return el("section", { "aria-labelledby": "addons" }, el("h2", { id: "addons" }, "Add-ons that it can take"), items);
  }

  const KINDS = { main: "full name", versions: "with versions", floating: "short name", dated: "of a day, never moves" };

  /** A bar of parts, each as wide as its share of the bytes. */
  function bar(platform) {
    const parts = Object.entries(platform.parts);
    const text = parts.map(([name, size]) => `${name || "other"}: ${r.size(size.compressed)}`).join(", ");
    return el(
      "div",
      { class: "parts", role: "img", "aria-label": text },
      parts.map(([name, size]) =>
        el("span", {
          class: `part kind-${r.kind(name)}`,
          style: { "flex-grow": String(size.compressed) },
          title: `${name || "other"}: ${r.size(size.compressed)}`,
        }),
      ),
    );
  }

  function sharedBy(platform) {
    const users = new Map();
    for (const { found } of r.published(platform.platform)) {
      for (const position of found.layers) users.set(position, (users.get(position) || 0) + 1);
    }
    return users;
  }

  function partsTable(platform) {
    const users = sharedBy(platform);
    const rows = Object.entries(platform.parts).map(([name, size]) => {
      const layers = platform.layers.filter((position) => r.catalogue.layers[position].part === name);
      const images = Math.min(...layers.map((position) => users.get(position) || 1));
      return el(
        "tr",
        null,
        r.partHead(name),
        el("td", { class: "number" }, r.size(size.compressed)),
        el("td", { class: "number" }, r.size(size.unpacked)),
        el("td", { class: "number" }, String(layers.length)),
        el("td", { class: "number" }, images > 1 ? `${images}` : "this one alone"),
      );
    });
    const head = [
      "Part",
      { text: "Compressed", className: "number" },
      { text: "Unpacked", className: "number" },
      { text: "Layers", className: "number" },
      { text: "Images that have it", className: "number" },
    ];
    return r.table(`Parts for ${platform.platform}`, head, rows);
  }

  /** Known vulnerabilities, whatever the policy says of them. */
  function scanned(scan) {
    const found = Object.entries(scan.findings).map(([severity, number]) => `${number} ${severity}`);
    const known = found.length ? `${found.join(", ")} known${scan.outcome === "clean" ? ", none of which the policy stops" : ""}` : "none known";
    const day = scan.database ? `, database of ${scan.database.slice(0, 10)}` : "";
    return `${known}; ${r.count(scan.packages, "package")}${day}`;
  }

  /** A page about an advisory, by its name: no address comes out of a registry. */
  const ADVISORIES = { CVE: "https://www.cve.org/CVERecord?id=", GHSA: "https://github.com/advisories/" };

  function advisory(id) {
    const address = ADVISORIES[id.split("-")[0]];
    return address ? el("a", { href: address + id }, id) : id;
  }

  function verdict(item) {
    if (item.fails) return el("span", { class: "bad" }, "stops the image");
    if (!item.ignored) return "listed only";
    const accepted = ["", "affected"].includes(item.status) ? "accepted" : item.status.replaceAll("_", " ");
    return `${accepted}${item.until ? ` until ${item.until}` : ""}: ${item.ignored}`;
  }

  /** The worst vulnerabilities by name, folded, and how many there are beside them. */
  function vulnerabilities(platform) {
    const { scan } = platform;
    if (!scan || !scan.named.length) return null;
    const all = Object.values(scan.findings).reduce((sum, number) => sum + number, 0);
    const rest = all - scan.named.length;
    const rows = scan.named.map((item) =>
      el(
        "tr",
        { class: item.fails ? "differs" : null },
        el("th", { scope: "row" }, advisory(item.id)),
        el("td", null, item.severity),
        el("td", { class: "mono" }, item.package),
        el("td", { class: "mono" }, item.installed),
        el("td", { class: "mono" }, item.fixed || "none"),
        el("td", null, item.part.replace(/^part-/, "")),
        el("td", null, verdict(item)),
      ),
    );
    const title = rest > 0 ? `The worst ${rows.length} of ${r.count(all, "vulnerability", "vulnerabilities")}` : "Vulnerabilities by name";
    return el(
      "details",
      null,
      el("summary", null, title),
      r.table(
        `Vulnerabilities for ${platform.platform}`,
        ["Advisory", "Severity", "Package", "Installed", "Fixed in", "Part", "Policy"],
        rows,
        { class: "broad" },
      ),
      rest > 0 ? el("p", { class: "sub" }, `${r.count(rest, "other")} not shown; the reports of the scan have all of them.`) : null,
    );
  }

  function checks(platform) {
    const { tests, scan } = platform;
    return [
      r.fact(
        "Structure tests",
        tests ? `${tests.passed} passed${tests.failures.length ? `, ${tests.failures.length} failed` : ""}` : "unknown",
        tests && tests.failures.length
          ? el(
              "ul",
              null,
              tests.failures.map((text) => el("li", null, text)),
            )
          : null,
      ),
      r.fact("Vulnerabilities", scan ? r.scanOutcome(scan) : "not scanned", scan ? el("p", { class: "sub" }, scanned(scan)) : null),
      scan && scan.failing.length ? r.fact("Stopped by", scan.failing.join(", ")) : null,
    ];
  }

  function platformSection(platform) {
    const versions = r.sortedVersions(platform);
    const rows = versions.map(([name, version]) =>
      el("tr", null, el("th", { scope: "row" }, name), el("td", { class: "mono" }, version)),
    );
    return el(
      "section",
      { class: "platform", "aria-label": platform.platform },
      el("h3", null, platform.platform),
      bar(platform),
      el(
        "dl",
        { class: "facts" },
        r.fact("Compressed", r.size(platform.size.compressed)),
        r.fact("Unpacked", r.size(platform.size.unpacked)),
        r.fact("Layers", String(platform.layers.length)),
        checks(platform),
        platform.ros_sync
          ? r.fact(
              "State of ROS's packages",
              el("code", { class: "digest", title: platform.ros_sync }, platform.ros_sync.slice(0, 20)),
            )
          : null,
        r.fact(
          "Manifest",
          r.digest(platform.digest),
          r.copyButton(() => platform.digest, "Copy", `Copy the digest for ${platform.platform}`),
        ),
        platform.inputs ? r.fact("Inputs", r.digest(platform.inputs)) : null,
      ),
      partsTable(platform),
      versions.length
        ? el(
            "details",
            null,
            el(
              "summary",
              null,
              `${r.count(versions.length, "version")} ${platform.found_inside ? "found inside" : "from the labels"}`,
            ),
            r.table(`Versions for ${platform.platform}`, ["Name", "Version"], rows),
          )
        : null,
      vulnerabilities(platform),
      r.packages(platform),
    );
  }

  function grown(bytes) {
    return bytes ? `${bytes > 0 ? "grows" : "shrinks"} by ${r.size(Math.abs(bytes))}` : "keeps its size";
  }

  function describe(change) {
    const parts = change.parts.map((name) => name || "other").join(", ");
    const versions = change.versions.map((item) => `${item.name} ${item.left || "none"} → ${item.right || "none"}`);
    return el(
      "li",
      null,
      el("strong", null, change.platform),
      ": ",
      change.pulled || change.kept < change.all
        ? `${parts} changed; an update pulls ${r.size(change.pulled)} and keeps ${change.kept} of ${change.all} layers; the image ${grown(change.growth)}`
        : "the same layers; only the configuration differs",
      change.sync ? `; ROS's packages moved from ${change.sync[0].slice(0, 20)} to ${change.sync[1].slice(0, 20)}` : "",
      versions.length ? `; ${versions.join(", ")}` : "",
    );
  }

  /** Builds, newest first by date: a tag that was moved back points at an older one. */
  function byDate(image) {
    return [...image.builds].sort((a, b) => b.created.localeCompare(a.created));
  }

  /** What is new in the present build; nothing where it is the first one. */
  function news(image) {
    const builds = byDate(image);
    const now = r.present(image);
    const before = builds[builds.indexOf(now) + 1];
    if (!before) return null;
    const [date, earlier] = r.days(now.created, before.created);
    return el(
      "section",
      { "aria-labelledby": "news" },
      el("h2", { id: "news" }, "What changed"),
      el("p", null, "The build of ", date, " compared with that of ", earlier, ":"),
      el("ul", null, r.changes(before, now).map(describe)),
      r.changedPackages(before, now),
    );
  }

  function history(image) {
    const builds = byDate(image);
    const items = builds.map((build, index) => {
      const before = builds[index + 1];
      const changes = before ? r.changes(before, build) : [];
      const link =
        before &&
        `#/compare?a=${encodeURIComponent(r.buildName(image, before))}&b=${encodeURIComponent(r.buildName(image, build))}`;
      return el(
        "li",
        null,
        el(
          "p",
          { class: "when" },
          r.day(build.created),
          " ",
          build === r.present(image) ? el("span", { class: "status built" }, "now") : null,
          " ",
          r.digest(build.digest),
        ),
        build.tags.length
          ? el("p", { class: "sub mono" }, build.tags.join(" · "))
          : el("p", { class: "sub" }, "no tag points at it any more"),
        before
          ? [
              el("ul", null, changes.map(describe)),
              el(
                "a",
                { href: link, "aria-label": `Compare the build of ${build.created.slice(0, 10)} with the one before` },
                "Compare with the one before",
              ),
            ]
          : el("p", { class: "sub" }, "the oldest one that is described here"),
      );
    });
    const moves = image.moves.map((move) =>
      el(
        "li",
        null,
        r.day(move.run),
        ": ",
        move.old ? [r.digest(move.old), " → "] : "first set to ",
        r.digest(move.new),
      ),
    );
    return el(
      "section",
      { "aria-labelledby": "history" },
      el("h2", { id: "history" }, "History"),
      items.length ? el("ol", { class: "history" }, items) : el("p", null, "There is none yet."),
      moves.length
        ? el(
            "details",
            null,
            el("summary", null, `${r.count(moves.length, "run")} moved the tag ${r.mainTag(image)}`),
            el("ul", null, moves),
          )
        : null,
    );
  }

  /** The GPUs that the libraries of an image were built for, on its architectures. */
  function builtFor(image) {
    const names = image.platforms.map(r.architecture);
    return Object.entries(image.gpu)
      .map(([name, gpus]) => [...name.split("."), gpus])
      .filter(([, architecture]) => names.includes(architecture))
      .map(([release, architecture, gpus]) =>
        el("p", { class: "sub" }, `${r.CARRIED[release] || release}, ${architecture}: ${gpus}`),
      );
  }

  /** What an image is, line by line. */
  function about(image) {
    const build = r.present(image);
    const facts = r.catalogue.distributions[image.distribution];
    const end = r.endOfLife(image);
    const promised = Object.entries(image.promised)
      .map(([name, version]) => `${r.CARRIED[name] || name} ${version}`)
      .join(", ");
    return el(
      "dl",
      { class: "facts" },
      r.fact(
        "Status",
        el("span", { class: `status ${image.status.replace(" ", "-")}` }, r.STATUS[image.status]),
        image.reason ? el("p", { class: "sub" }, image.reason) : null,
      ),
      r.fact(
        "Content",
        `ROS ${facts.ros} ${image.distribution}, ${image.component}`,
        promised ? el("p", { class: "sub" }, promised) : null,
      ),
      r.fact("System", `${facts.os}, Python ${facts.python}`),
      r.fact("Platforms", r.platformNames(image, String)),
      r.fact(
        "End of life",
        el("span", { class: end.over ? "bad" : null }, end.text + (end.over ? " (over)" : "")),
        end.over && end.instead.length ? el("p", { class: "sub" }, `take ${end.instead.join(" or ")}`) : null,
        facts.experimental ? el("p", { class: "sub" }, "experimental") : null,
      ),
      image.gpu.driver ? r.fact("GPU", `NVIDIA driver ${image.gpu.driver} or newer`, builtFor(image)) : null,
      build ? r.fact("Created", r.day(build.created)) : null,
      build
        ? r.fact(
            "Index",
            r.digest(build.digest),
            r.copyButton(() => build.digest, "Copy", "Copy the digest of the index"),
          )
        : null,
    );
  }

  function view(main, query, target) {
    const image = r.byTarget.get(target);
    if (!image) {
      main.append(
        el("h1", null, "No such image"),
        el("p", null, `There is no image ${target} in this catalogue. `, el("a", { href: "#/" }, "See all")),
      );
      return;
    }
    main.append(
      el("p", { class: "crumbs" }, el("a", { href: "#/" }, "Images"), " / "),
      el("h1", null, image.target),
      el("p", { class: "badges" }, r.badgeNodes(image)),
      about(image),
    );
    const build = r.present(image);
    if (build) {
      main.append(
        ...[use(image), more(image), news(image)].filter(Boolean),
        el(
          "section",
          { "aria-labelledby": "inside" },
          el("h2", { id: "inside" }, "Inside"),
          build.platforms.map(platformSection),
        ),
        history(image),
      );
    } else main.append(later(image));
  }

  r.views.image = { title: (target) => target, view };
})();
