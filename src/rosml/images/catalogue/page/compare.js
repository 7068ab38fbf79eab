// Two tags side by side: what differs in versions and size, which layers they share, and what the second costs whoever has the first.
"use strict";

(() => {
  const r = window.rosml;
  const { el } = r;
  const DIFFERENCE = { text: "Difference", unseen: true };

  /** A row of two values, marked where they differ. */
  function row(name, left, right, same) {
    return el(
      "tr",
      { class: same ? "same" : "differs" },
      el("th", { scope: "row" }, name),
      el("td", null, left === undefined || left === "" ? "none" : left),
      el("td", null, right === undefined || right === "" ? "none" : right),
      el("td", { class: "mark" }, same ? el("span", { class: "sub" }, "same") : el("strong", null, "differs")),
    );
  }

  function facts(side, platform) {
    const { image, build } = side;
    const distribution = r.catalogue.distributions[image.distribution];
    return {
      Image: image.target,
      Created: build.created.slice(0, 10) || "unknown",
      System: `${distribution.os}, Python ${distribution.python}`,
      "State of ROS's packages": platform.ros_sync.slice(0, 20) || "unknown",
      "End of life": r.endOfLife(image).text,
      Compressed: r.size(platform.size.compressed),
      Unpacked: r.size(platform.size.unpacked),
      "Structure tests": platform.tests ? `${platform.tests.passed} passed` : "unknown",
      Scan: platform.scan ? r.scanOutcome(platform.scan) : "unknown",
    };
  }

  function layerRows(platforms) {
    const { shared, left, right } = r.compareLayers(...platforms);
    const line = (layer, where) =>
      el(
        "tr",
        null,
        r.partHead(layer.part),
        el("td", null, r.digest(layer.digest)),
        el("td", { class: "number" }, r.size(layer.compressed)),
        el("td", null, where),
      );
    return [
      ...shared.map((layer) => line(layer, "both")),
      ...left.map((layer) => line(layer, "first alone")),
      ...right.map((layer) => line(layer, "second alone")),
    ];
  }

  /** Two bars over one another, on one scale: what both have is where they overlap. */
  function bars(left, shared, right) {
    const [a, both, b] = [r.bytes(left), r.bytes(shared), r.bytes(right)];
    const piece = (bytes, kind, text) =>
      bytes
        ? el("span", {
            class: `part ${kind}`,
            style: { "flex-grow": String(bytes) },
            title: `${text}: ${r.size(bytes)}`,
          })
        : null;
    return el(
      "div",
      {
        class: "parts tall",
        role: "img",
        "aria-label": `first alone ${r.size(a)}, in both ${r.size(both)}, second alone ${r.size(b)}`,
      },
      piece(a, "only-left", "first alone"),
      piece(both, "both", "in both"),
      piece(b, "only-right", "second alone"),
    );
  }

  /** The versions of both, those that differ first; all of them once somebody asks. */
  function versionTable(platforms) {
    const versions = r.compareVersions(...platforms);
    const different = versions.filter((item) => !item.same);
    const body = el("div");

    function fill(all) {
      const shown = all ? versions : different;
      body.replaceChildren(
        shown.length
          ? r.table(
              "Versions",
              ["Name", "First", "Second", DIFFERENCE],
              shown.map((item) => row(item.name, item.left, item.right, item.same)),
            )
          : el("p", null, versions.length ? "No version differs." : "No versions are known of both."),
      );
    }

    fill(false);
    const known = platforms.every((item) => item.found_inside)
      ? ""
      : " Of one of them only the labels are known: versions that both name are compared.";
    return [
      el(
        "p",
        null,
        `${different.length} of ${versions.length} differ.${known} `,
        versions.length > different.length
          ? el(
              "label",
              { class: "choice" },
              el("input", { type: "checkbox", onchange: (event) => fill(event.target.checked) }),
              el("span", null, "show those that are the same"),
            )
          : null,
      ),
      body,
    ];
  }

  function result(first, second, chosen) {
    const common = first.build.platforms
      .map((item) => item.platform)
      .filter((name) => second.build.platforms.some((item) => item.platform === name));
    if (!common.length) return [el("p", { class: "notice" }, "They have no platform in common.")];
    const name = common.includes(chosen) ? chosen : common[0];
    const platforms = [first, second].map((side) => side.build.platforms.find((item) => item.platform === name));
    const { shared, left, right } = r.compareLayers(...platforms);
    const [a, b] = [facts(first, platforms[0]), facts(second, platforms[1])];
    const choose = el(
      "select",
      { id: "platform", onchange: (event) => go(first, second, event.target.value) },
      common.map((item) => el("option", { value: item, selected: item === name }, item)),
    );
    return [
      el("p", { class: "choose" }, el("label", { for: "platform" }, "Platform"), choose),
      el(
        "p",
        { class: "lead", id: "verdict" },
        shared.length
          ? `They share ${shared.length} of ${platforms[1].layers.length} layers, ${r.size(r.bytes(shared))}. Whoever has the first pulls ${r.size(r.bytes(right))} for the second.`
          : `They share no layer. The second is ${r.size(r.bytes(right))} to pull.`,
      ),
      bars(left, shared, right),
      el(
        "p",
        { class: "keys" },
        [
          ["only-left", "first alone"],
          ["both", "in both"],
          ["only-right", "second alone"],
        ].map(([kind, text]) => el("span", null, el("span", { class: `key ${kind}` }), text)),
      ),
      el("h2", null, "Facts"),
      r.table(
        "Facts",
        ["Fact", "First", "Second", DIFFERENCE],
        Object.keys(a).map((key) => row(key, a[key], b[key], a[key] === b[key])),
      ),
      el("h2", null, "Versions"),
      ...versionTable(platforms),
      el("h2", null, "Layers"),
      r.table("Layers", ["Part", "Digest", { text: "Compressed", className: "number" }, "In"], layerRows(platforms)),
    ];
  }

  function go(first, second, platform) {
    const query = new URLSearchParams({
      a: r.buildName(first.image, first.build),
      b: r.buildName(second.image, second.build),
    });
    if (platform) query.set("platform", platform);
    window.location.hash = `#/compare?${query}`;
  }

  function field(id, text, value) {
    const input = el("input", {
      id,
      list: "names",
      autocomplete: "off",
      spellcheck: "false",
      placeholder: "ros-torch:ros1-bookworm-base-cu128",
    });
    input.value = value;
    return { input, label: el("label", { for: id }, text, input) };
  }

  function swapButton(onclick) {
    return el("button", { type: "button", class: "swap", "aria-label": "Swap first and second", onclick }, "⇄");
  }

  function view(main, query) {
    const [a, b] = [query.get("a") || "", query.get("b") || ""];
    const [one, other] = [field("first", "First", a), field("second", "Second", b)];
    const trouble = el("p", { class: "notice", role: "alert", hidden: true });

    function submit(event) {
      if (event) event.preventDefault();
      const sides = [one, other].map(({ input }) => r.find(input.value));
      const missing = [one, other].find((_, index) => !sides[index]);
      trouble.hidden = !missing;
      if (missing) {
        trouble.textContent = missing.input.value ? r.whyNot(missing.input.value) : "Name two tags or images.";
        missing.input.focus();
        return;
      }
      go(...sides);
    }

    const names = [...r.catalogue.images].flatMap((image) => image.builds.map((build) => r.buildName(image, build)));
    main.append(
      el("h1", null, "Compare two tags"),
      el(
        "form",
        { class: "compare", onsubmit: submit },
        one.label,
        swapButton(() => {
          [one.input.value, other.input.value] = [other.input.value, one.input.value];
          if (a && b) submit();
        }),
        other.label,
        el("button", { type: "submit" }, "Compare"),
        el(
          "datalist",
          { id: "names" },
          names.map((name) => el("option", { value: name })),
        ),
      ),
      trouble,
    );
    const sides = [r.find(a), r.find(b)];
    if (sides[0] && sides[1]) main.append(...result(...sides, query.get("platform")));
    else if (a && b) {
      trouble.hidden = false;
      trouble.textContent = r.whyNot(sides[0] ? b : a);
    } else
      main.append(
        el(
          "p",
          null,
          "Choose two: a tag, a dated tag, or an image by its target. An image's page has the comparison of each build with the one before.",
        ),
      );
  }

  r.views.compare = { title: "Compare", view };
})();
