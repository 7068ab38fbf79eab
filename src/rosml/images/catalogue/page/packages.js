// The packages of an image, and which of them changed. Each SBOM is a script of its own, loaded when somebody asks: from a file, a
// browser lets a page load nothing else.
"use strict";

(() => {
  const r = window.rosml;
  const { el } = r;
  const KINDS = { deb: "Debian", pypi: "Python" };
  const FIRST = 50; // rows at a time

  const there = new Set(window.packaged || []);
  const waiting = new Map(); // name of a script -> what is done with its content
  const loaded = new Map(); // name of a script -> promise of its content

  /** Called by each script. */
  r.packagesRead = (name, content) => waiting.get(name)(content);

  function load(name) {
    if (!loaded.has(name)) {
      const read = new Promise((resolve, reject) => {
        waiting.set(name, resolve);
        document.head.append(el("script", { src: `packages/${name}.js`, onerror: () => reject(new Error(name)) }));
      });
      loaded.set(name, read);
    }
    return loaded.get(name);
  }

  function scripts(platform) {
    return platform.sboms.map((position) => {
      const { part, digest } = r.catalogue.sboms[position];
      return { part: part.replace(/^part-/, ""), name: digest.replace("sha256:", "") };
    });
  }

  /** Whether the packages of all parts of an image are beside the page. */
  function known(platform) {
    return platform.sboms.length > 0 && scripts(platform).every(({ name }) => there.has(name));
  }

  /** All packages of an image: {name, version, kind, part}, by name. */
  async function packagesOf(platform) {
    const all = await Promise.all(
      scripts(platform).map(async ({ part, name }) =>
        (await load(name)).map(([title, version, kind]) => ({ name: title, version, kind: KINDS[kind] || kind, part })),
      ),
    );
    return all.flat().sort((a, b) => a.name.localeCompare(b.name));
  }

  /** What changed from one list of packages to a later one: {name, kind, before, after}, each with its versions. */
  function difference(before, after) {
    const versions = new Map();
    for (const [side, list] of [before, after].entries())
      for (const item of list) {
        const key = `${item.kind} ${item.name}`;
        if (!versions.has(key)) versions.set(key, { name: item.name, kind: item.kind, sides: [[], []] });
        versions.get(key).sides[side].push(item.version);
      }
    return [...versions.values()]
      .map(({ name, kind, sides }) => ({ name, kind, before: sides[0].sort().join(", "), after: sides[1].sort().join(", ") }))
      .filter((item) => item.before !== item.after);
  }

  /** Something folded, whose content is made when it is opened. */
  function folded(title, make) {
    const place = el("div", null, el("p", { class: "sub" }, "Loading …"));
    let made = false;
    const ontoggle = async (event) => {
      if (made || !event.target.open) return;
      made = true;
      try {
        place.replaceChildren(...(await make()));
      } catch {
        place.replaceChildren(el("p", { class: "notice" }, "A file of this page's folder could not be read."));
      }
    };
    return el("details", { ontoggle }, el("summary", null, title), place);
  }

  /** All packages for a platform, to look through. */
  function table(platform, all) {
    const body = el("div");
    const summary = el("p", { class: "sub", role: "status" });
    const more = el("button", { type: "button", onclick: () => fill(Infinity) }, "Show all");
    const search = el("input", { type: "search", autocomplete: "off", spellcheck: "false", oninput: () => fill(FIRST) });

    function fill(most) {
      const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
      const found = all.filter((item) => {
        const text = `${item.name} ${item.version} ${item.kind} ${item.part}`.toLowerCase();
        return words.every((word) => text.includes(word));
      });
      summary.textContent = `${found.length === all.length ? "" : `${found.length} of `}${r.count(all.length, "package")}`;
      more.hidden = found.length <= most;
      const rows = found.slice(0, most).map((item) =>
        el(
          "tr",
          null,
          el("th", { scope: "row" }, item.name),
          el("td", { class: "mono" }, item.version),
          el("td", null, item.kind),
          el("td", null, item.part),
        ),
      );
      body.replaceChildren(r.table(`Packages for ${platform.platform}`, ["Name", "Version", "Kind", "Part"], rows));
    }

    fill(FIRST);
    return [el("label", { class: "choose" }, "Search packages", search), summary, body, more];
  }

  /** Packages for a platform, folded; nothing where they are unknown. */
  function packages(platform) {
    return known(platform) ? folded("Packages, from the SBOMs", async () => table(platform, await packagesOf(platform))) : null;
  }

  /** Packages that changed from one build to a later one, folded; nothing where one of both is unknown. */
  function changedPackages(older, newer) {
    return newer.platforms.map((after) => {
      const before = older.platforms.find((item) => item.platform === after.platform);
      if (!before || !known(before) || !known(after)) return null;
      const title = `Packages that changed for ${after.platform}`;
      return folded(title, async () => {
        const found = difference(await packagesOf(before), await packagesOf(after));
        const rows = found.map((item) =>
          el(
            "tr",
            null,
            el("th", { scope: "row" }, item.name),
            el("td", { class: "mono" }, item.before || "none"),
            el("td", { class: "mono" }, item.after || "removed"),
            el("td", null, item.kind),
          ),
        );
        return [rows.length ? r.table(title, ["Name", "Before", "Now", "Kind"], rows) : el("p", null, "None.")];
      });
    });
  }

  Object.assign(r, { packages, changedPackages });
})();
