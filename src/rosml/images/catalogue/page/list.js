// The list of images: filters, free text, sorting.
"use strict";

(() => {
  const r = window.rosml;
  const { el } = r;

  /** The day of the newest build: what the last run changed. */
  const newest = r.catalogue.images
    .map((image) => (r.present(image) ? r.present(image).created : ""))
    .reduce((last, date) => (date > last ? date : last), "")
    .slice(0, 10);

  function isNews(image) {
    return Boolean(newest && r.present(image) && r.present(image).created.startsWith(newest));
  }

  /** What one can filter by: the values of an image under each name. */
  const GROUPS = {
    distribution: { title: "Distribution", of: (image) => [image.distribution] },
    component: { title: "Component", of: (image) => [image.component] },
    framework: { title: "Framework", of: (image) => [image.framework], name: (value) => r.TITLES[value] || value },
    stack: { title: "Stack", of: (image) => [image.stack || "none"] },
    architecture: { title: "Architecture", of: (image) => r.platforms(image).own.map(r.architecture) },
    support: {
      title: "Support",
      of: (image) => [
        r.endOfLife(image).over ? "end of life" : "maintained",
        ...(r.catalogue.distributions[image.distribution].lts ? ["LTS"] : []),
      ],
    },
    changed: {
      title: "Changed",
      of: (image) => (isNews(image) ? ["last"] : []),
      name: () => `in the last run, ${newest}`,
    },
    status: { title: "Status", of: (image) => [image.status], name: (value) => r.STATUS[value] },
  };
  const ORDER = Object.keys(r.STATUS);
  const SORTS = {
    image: { title: "Image", by: (row) => row.number },
    size: { title: "Size", by: (row) => (row.platform ? row.platform.size.compressed : -1), down: true },
    created: { title: "Created", by: (row) => (row.build ? row.build.created : ""), down: true },
    status: { title: "Status", by: (row) => ORDER.indexOf(row.image.status) },
  };

  const FIRST = 60; // rows at a time
  let rows; // one for each image, made once
  // wide: the text means no published image, so that others are shown, whatever status is chosen
  const state = { text: "", chosen: {}, sort: "status", down: false, wide: false };

  /** The status that is chosen at first: published images alone, if there are any. */
  function usual() {
    return r.catalogue.images.some((image) => image.status === "built") ? "built" : "";
  }

  function content(image) {
    const facts = r.catalogue.distributions[image.distribution];
    const carried = Object.keys(image.promised).filter((name) => !["cudnn", "nccl"].includes(name));
    return [
      `ROS ${facts.ros} ${image.component}`,
      ...carried.map((name) => `${r.CARRIED[name] || name} ${image.promised[name]}`),
    ];
  }

  function checks(platform) {
    if (!platform) return "";
    const { tests, scan } = platform;
    return [
      el(
        "span",
        { class: tests && tests.failures.length ? "bad" : null },
        tests ? `${tests.passed} passed` : "tests unknown",
      ),
      scan ? el("span", { class: `sub ${scan.outcome === "clean" ? "" : "bad"}` }, r.scanOutcome(scan)) : null,
    ];
  }

  /** What is known of an image, for sorting and filtering; its element is made when it is first seen. */
  function makeRow(image, number) {
    const build = r.present(image);
    const values = Object.fromEntries(Object.entries(GROUPS).map(([name, group]) => [name, group.of(image)]));
    return { image, build, number, values, platform: build && build.platforms[0] };
  }

  function node(row) {
    row.node = row.node || element(row);
    return row.node;
  }

  function sizes(platform) {
    if (!platform) return "";
    const { compressed, unpacked } = platform.size;
    const disk = unpacked ? `${r.size(unpacked)} unpacked` : "unpacked: not counted";
    return [r.size(compressed), el("span", { class: "sub" }, disk)];
  }

  function element({ image, build, platform }) {
    const tag = r.mainTag(image);
    const line = `FROM ${r.reference(image, tag)}`;
    return el(
      "tr",
      { class: image.status === "built" ? null : "absent", role: "row" },
      el(
        "th",
        { scope: "row", role: "rowheader" },
        el("a", { href: `#/image/${image.target}` }, image.target),
        el("span", { class: "sub mono" }, tag ? `${image.repository}:${tag}` : image.repository),
      ),
      el(
        "td",
        { class: "content", role: "cell" },
        content(image).map((text) => el("span", { class: "chip" }, text)),
        r.badgeNodes(image),
      ),
      el("td", { class: "place", role: "cell" }, r.platformNames(image, r.architecture)),
      el("td", { class: "number", role: "cell" }, sizes(platform)),
      el("td", { class: "line", role: "cell" }, checks(platform)),
      el("td", { class: "line", role: "cell" }, build ? r.day(build.created) : ""),
      el(
        "td",
        { class: "middle", role: "cell" },
        el(
          "span",
          { class: `status ${image.status.replace(" ", "-")}`, title: image.reason || null },
          r.STATUS[image.status],
        ),
      ),
      el(
        "td",
        { class: "actions", role: "cell" },
        build
          ? [
              r.copyButton(() => line, "Copy FROM", `Copy the FROM line of ${image.target}`),
              el(
                "a",
                {
                  href: `#/compare?a=${encodeURIComponent(r.buildName(image, build))}`,
                  class: "button",
                  "aria-label": `Compare ${image.target} with another one`,
                },
                "Compare",
              ),
            ]
          : "",
      ),
    );
  }

  /** Whether a row matches, leaving one group of filters out of account. */
  function matches(row, test, without) {
    for (const name of Object.keys(GROUPS)) {
      const chosen = name === "status" && state.wide ? null : state.chosen[name];
      if (name !== without && chosen && chosen.size && !row.values[name].some((value) => chosen.has(value)))
        return false;
    }
    return test(row.image);
  }

  /** How many rows each value of a group would give, with all other filters as they are. */
  function countOf(name, test) {
    const counts = new Map();
    for (const row of rows) {
      if (matches(row, test, name))
        for (const value of row.values[name]) counts.set(value, (counts.get(value) || 0) + 1);
    }
    return counts;
  }

  function remember() {
    const query = new URLSearchParams();
    if (state.text) query.set("q", state.text);
    for (const [name, chosen] of Object.entries(state.chosen)) {
      const text = [...chosen].join(",");
      if (name !== "status" && text) query.set(name, text);
      if (name === "status" && text !== usual()) query.set(name, text || "any");
    }
    if (state.sort !== "status" || state.down) query.set("sort", `${state.down ? "-" : ""}${state.sort}`);
    const text = query.toString();
    history.replaceState(null, "", text ? `#/?${text}` : "#/");
  }

  function read(query) {
    state.text = query.get("q") || "";
    state.chosen = {};
    for (const name of Object.keys(GROUPS)) {
      const text = query.get(name) || (name === "status" ? usual() : "");
      state.chosen[name] = new Set(text.split(",").filter((value) => value && value !== "any"));
    }
    const sort = query.get("sort") || "status";
    state.down = sort.startsWith("-");
    state.sort = sort.replace("-", "") in SORTS ? sort.replace("-", "") : "status";
  }

  /** Shows so many more of the rows that were found. */
  function more(ui, number) {
    const there = ui.body.children.length;
    ui.body.append(...ui.shown.slice(there, there + number).map(node));
    ui.rest.hidden = ui.body.children.length === ui.shown.length;
    ui.all.textContent = `Show all ${r.count(ui.shown.length, "image")}`;
  }

  /** The rows that match, in the order that was chosen. */
  function find(test) {
    const { by } = SORTS[state.sort];
    const direction = state.down ? -1 : 1;
    const found = rows.filter((row) => matches(row, test));
    return found.sort((a, b) => {
      const [left, right] = [by(a), by(b)];
      return left < right ? -direction : left > right ? direction : a.number - b.number;
    });
  }

  const NONE =
    "No image matches. Take a filter away, or ask why one does not exist: rosml explain <name>.";

  /** That what is looked for is an add-on, which images take that have no tag with it. */
  function hint(name) {
    const { title, stacks, restricted } = r.catalogue.addons[name];
    const image = r.taker(name);
    return el(
      "p",
      null,
      title === name ? `${name} is an add-on. ` : `${title} is the add-on ${name}. `,
      `Images of ${stacks.join(", ")} can take it, and images of ROS alone`,
      restricted ? ", in private registries. " : ". ",
      image ? ["For example ", el("a", { href: `#/image/${image.target}` }, image.target), ": its page has the commands."] : "",
    );
  }

  function usualStatus() {
    return [...state.chosen.status].join(",") === usual();
  }

  /** How many images are shown, of which. */
  function summary(shown) {
    const [found, all] = [shown.length, rows.length];
    const built = rows.filter((row) => row.build).length;
    if (state.wide) return `None of the ${r.count(built, "published image")} matches. Not built yet: ${r.count(found, "image")}`;
    if (usual() && usualStatus()) return `${found === built ? "All" : `${found} of`} ${r.count(built, "published image")}`;
    const here = shown.filter((row) => row.build).length;
    return `${found === all ? "All" : `${found} of`} ${r.count(all, "image")}, ${here} published here`;
  }

  /** Shows what the state says: rows, how many each choice would leave, which order it is. */
  function update(ui) {
    const test = r.search(state.text);
    const meant = state.text.trim() ? rows.filter((row) => test(row.image)) : [];
    state.wide = usualStatus() && Boolean(usual()) && meant.length > 0 && !meant.some((row) => row.build);
    ui.shown = find(test);
    ui.hints.replaceChildren(...r.addonsMeant(state.text).map(hint));
    ui.body.replaceChildren();
    more(ui, FIRST);
    const counts = Object.fromEntries(Object.keys(GROUPS).map((name) => [name, countOf(name, test)]));
    for (const { name, value, number } of ui.boxes) {
      const others = counts[name].get(value) || 0;
      number.textContent = others;
      number.parentElement.classList.toggle("empty", others === 0);
    }
    ui.summary.textContent = summary(ui.shown);
    const unseen = state.wide || !usual() || !usualStatus() ? 0 : counts.status.get("not built") || 0;
    ui.every.hidden = !usual() || (usualStatus() && !unseen);
    ui.every.textContent = usualStatus() ? `Show ${unseen} more that are not built yet` : "Show published ones alone";
    ui.none.hidden = ui.shown.length > 0;
    ui.none.textContent = unseen ? "No published image matches." : NONE;
    ui.clear.hidden = !state.text && Object.entries(state.chosen).every(([name, chosen]) => (name === "status" ? usualStatus() : !chosen.size));
    for (const [name, button] of Object.entries(ui.heads)) {
      const on = name === state.sort;
      button.parentElement.setAttribute("aria-sort", on ? (state.down ? "descending" : "ascending") : "none");
    }
  }

  function changed(ui) {
    remember();
    update(ui);
  }

  function searchField(ui) {
    const search = el("input", {
      type: "search",
      id: "search",
      placeholder: "jazzy gpu, ubuntu 24.04, ros-torch:jazzy, sha256:…",
      autocomplete: "off",
      spellcheck: "false",
      "aria-keyshortcuts": "/",
      "aria-describedby": "enter",
      oninput: (event) => {
        state.text = event.target.value;
        changed(ui);
      },
      onkeydown: (event) => {
        if (event.key === "Enter" && !event.isComposing && ui.shown.length) window.location.hash = `#/image/${ui.shown[0].image.target}`;
      },
    });
    search.value = state.text;
    return search;
  }

  /** A value of a group, to be ticked. */
  function choice(ui, name, value) {
    const box = el("input", {
      type: "checkbox",
      value,
      onchange: (event) => {
        if (event.target.checked) state.chosen[name].add(value);
        else state.chosen[name].delete(value);
        changed(ui);
      },
    });
    box.checked = state.chosen[name].has(value);
    const number = el("span", { class: "number" });
    ui.boxes.push({ name, value, number, box });
    const group = GROUPS[name];
    return el("label", { class: "choice" }, box, el("span", null, group.name ? group.name(value) : value), number);
  }

  function filters(ui) {
    const groups = Object.entries(GROUPS).map(([name, group]) => {
      const values = [...new Set(rows.flatMap((row) => row.values[name]))];
      if (!values.length) return null;
      if (name === "status") values.sort((a, b) => ORDER.indexOf(a) - ORDER.indexOf(b));
      return el(
        "fieldset",
        { "data-group": name },
        el("legend", null, group.title),
        el(
          "div",
          { class: "values" },
          values.map((value) => choice(ui, name, value)),
        ),
      );
    });
    return el(
      "details",
      { class: "filters", open: window.matchMedia("(min-width: 60rem)").matches },
      el("summary", null, "Filters"),
      el("form", { onsubmit: (event) => event.preventDefault() }, groups),
    );
  }

  /** Ticks the boxes of what is chosen. */
  function tick(ui) {
    for (const { name, value, box } of ui.boxes) box.checked = state.chosen[name].has(value);
  }

  /** Shows all images, or published ones alone. */
  function everyButton(ui) {
    const onclick = () => {
      state.chosen.status = new Set(usualStatus() ? [] : [usual()]);
      tick(ui);
      changed(ui);
      ui.summary.focus();
    };
    return el("button", { type: "button", class: "every", onclick }, "");
  }

  function clearButton(ui) {
    const onclick = () => {
      const { sort, down } = state;
      read(new URLSearchParams());
      Object.assign(state, { sort, down });
      ui.search.value = "";
      tick(ui);
      changed(ui);
      ui.search.focus();
    };
    return el("button", { type: "button", class: "clear", onclick }, "Clear all filters");
  }

  /** The head of a column that the table can be sorted by. */
  function head(ui, name, className) {
    const sort = SORTS[name];
    const onclick = () => {
      state.down = state.sort === name ? !state.down : Boolean(sort.down);
      state.sort = name;
      changed(ui);
    };
    ui.heads[name] = el("button", { type: "button", onclick }, sort.title);
    return el("th", { scope: "col", role: "columnheader", class: className || null, "aria-sort": "none" }, ui.heads[name]);
  }

  function table(ui) {
    return el(
      "table",
      { class: "list", role: "table" },
      el("caption", { class: "hidden" }, "Images"),
      el(
        "thead",
        { role: "rowgroup" },
        el(
          "tr",
          { role: "row" },
          head(ui, "image"),
          el("th", { scope: "col", role: "columnheader", class: "content" }, "Content"),
          el("th", { scope: "col", role: "columnheader" }, "Platforms"),
          head(ui, "size", "number"),
          el("th", { scope: "col", role: "columnheader" }, "Checks"),
          head(ui, "created"),
          head(ui, "status", "middle"),
          el("th", { scope: "col", role: "columnheader" }, "Use"),
        ),
      ),
      ui.body,
    );
  }

  function view(main, query) {
    read(query);
    rows = rows || r.catalogue.images.map(makeRow);
    const ui = { body: el("tbody", { role: "rowgroup" }), shown: [], boxes: [], heads: {} };
    ui.all = el("button", { type: "button", onclick: () => more(ui, Infinity) });
    ui.rest = el("p", { class: "rest" }, ui.all);
    ui.summary = el("p", { class: "summary", role: "status", "aria-live": "polite", tabindex: "-1" });
    ui.search = searchField(ui);
    ui.clear = clearButton(ui);
    ui.every = everyButton(ui);
    ui.none = el("p", { class: "notice", hidden: true });
    ui.hints = el("div", { class: "hints", role: "status", "aria-live": "polite" });
    // A browser lays a long table out slowly: the next rows come when the end of those that are there is near.
    new IntersectionObserver(
      (entries) => {
        if (entries.some((entry) => entry.isIntersecting)) more(ui, FIRST);
      },
      { rootMargin: "100%" },
    ).observe(ui.rest);
    main.append(
      el("h1", null, "Images"),
      el(
        "p",
        { class: "lead" },
        "Find a tag, copy its line, or ",
        el("a", { href: "#/start" }, "answer four questions"),
        ". Every published image was tested from the inside before its tag pointed at it.",
      ),
      el(
        "div",
        { class: "search" },
        el("label", { for: "search" }, "Search names, versions and digests"),
        ui.search,
        el("p", { class: "sub", id: "enter" }, "Enter opens the first image."),
      ),
      filters(ui),
      el("div", { class: "bar" }, ui.summary, ui.every, ui.clear),
      ui.hints,
      table(ui),
      ui.rest,
      ui.none,
    );
    update(ui);
  }

  r.views = { list: { title: "Images", view } };
})();
