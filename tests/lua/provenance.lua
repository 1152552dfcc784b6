-- Where the numbers of a card come from: fitted, copied, typed, assumed. Each says what it is, in the card, its text, its check and after
-- a change; nothing that was typed or copied is said to be fitted.
local fabric = require "fabric"
local lab = fabric.lab

-- A pull of a cloth S = scale (8 MPa E + 400 MPa E^2), back where wanted.
local function test(scale, back)
  local E, S, n = {}, {}, 60
  for i = 0, n do
    E[i + 1] = i / 300
    S[i + 1] = scale * (8e6 * E[i + 1] + 4e8 * E[i + 1] ^ 2)
  end
  local branches = { { kind = "loading", first = 1, last = n + 1 } }
  if back then
    for i = 1, 10 do E[n + 1 + i], S[n + 1 + i] = E[n + 1] - i * 1e-4, S[n + 1] - scale * 900e6 * i * 1e-4 end
    branches[2] = { kind = "unloading", first = n + 2, last = n + 11 }
  end
  return { E = E, S = S, branches = branches }
end
local function fit(back) return lab.fit { tests = { test(1, back), test(1.02, back), test(0.97, back) }, degree = 2 } end
local denim = fabric.card "denim"
local function card(t)
  local all = { name = "mine", density = 600, thickness = 4e-4, warp = fit(true), weft = fit(true), shear = denim.shear, poisson = { warp = 0.2, weft = 0.3 } }
  for name, value in pairs(t or {}) do all[name] = value end
  for name, value in pairs(all) do all[name] = value ~= "none" and value or nil end
  return lab.card(all)
end
local function says(of, field, words)
  local got = (of.provenance or {})[field] or "nothing"
  assert(got:find(words, 1, true) == 1, ("%s: %s, expected %s"):format(field, got, words))
end

-- a copied shear is no specimen's, and has no band; typed ratios are typed
local mine = card()
says(mine, "warp.loading", "fitted to 3 specimens, polynomial of degree 2")
says(mine, "warp.unloading", "fitted to 3 specimens, rule 'first'")
says(mine, "warp.poisson", "typed")
says(mine, "shear.loading", "copied from the card 'denim'")
says(mine, "shear.unloading", "copied from the card 'denim'")
assert(mine.source == "warp: 3 specimens, polynomial of degree 2; weft: 3 specimens, polynomial of degree 2; shear: copied from the card 'denim'", mine.source)
assert(mine.bands.warp and not mine.bands.shear)
assert(tostring(mine):find("of 95 % confidence on warp, weft, none on shear", 1, true), tostring(mine))
assert(tostring(mine):find "shear.loading +copied from the card 'denim'")

-- a list taken out of a card is copied, a number beside it typed; one that was changed since is typed
local part = denim.shear
part.unloading = part.unloading * 1.1
local changed = card { shear = part }
says(changed, "shear.loading", "copied from the card 'denim'")
says(changed, "shear.unloading", "typed")
says(card { shear = { loading = denim.weft.loading, unloading = 2e6 } }, "shear.loading", "copied from the card 'denim', its weft")
says(card { warp = { loading = { 8e6 }, unloading = 9e7 } }, "warp.loading", "typed")
local forged = fit(true)
forged.loading = { 8e6, 8e8 }
local typed = card { warp = forged }
says(typed, "warp.loading", "typed")
assert(not typed.bands.warp)
local completed = fit(false)
completed.unloading = 9e8
local half = card { warp = completed }
says(half, "warp.loading", "fitted to 3 specimens")
says(half, "warp.unloading", "typed")
assert(half.bands.warp.low[1] < half.warp.loading[1] and half.bands.warp.low[3] == 9e8)

-- a missing part is an error, or assumed and told everywhere
local ok, message = pcall(card, { warp = fit(false) })
assert(not ok and tostring(message):find("field 'warp': expected a fit with an unloading modulus (a cyclic test), got one of loading alone", 1, true))
local bare = card { warp = fit(false), weft = "none", shear = "none", poisson = "none", assume = true }
says(bare, "warp.unloading", "assumed: 4 times the steepest tangent of the loading")
assert(math.abs(bare.warp.unloading / (4 * (bare.warp.loading[1] + bare.warp.loading[2] * 0.2)) - 1) < 1e-12)
says(bare, "weft.loading", "assumed: as the warp's")
says(bare, "weft.poisson", "assumed: 0.4")
says(bare, "shear.loading", "assumed: straight, 0.09 of the yarns' initial modulus")
assert(math.abs(bare.shear.loading[1] / (0.09 * bare.warp.loading[1]) - 1) < 1e-12)
local report = bare:check()
assert(report.ok and tostring(report):find("assumed.weft.poisson +weft.poisson is assumed: 0.4"), tostring(report))
local own = card { warp = fit(false), assume = { ["warp.unloading"] = 7e8, thickness = true } }
assert(own.warp.unloading == 7e8)
says(own, "warp.unloading", "assumed: given by the deck")
says(own, "thickness", "assumed: given by the deck")

-- kept in the file, by card:with, and changed where a value is
local path = os.tmpname() .. ".lua"
bare:write(path)
local again = fabric.card(path)
os.remove(path)
assert(again == bare and again.source == bare.source)
for field, words in pairs(bare.provenance) do assert(again.provenance[field] == words) end
local other = bare:with { weft = { poisson = 0.25 }, name = "other" }
says(other, "weft.poisson", "typed: changed by card:with")
says(other, "warp.unloading", "assumed: 4 times")
-- a part that is gone has no origin
local bent = fabric.card("denim", { bending = "estimated" })
assert(bent.bending and bent.provenance.bending:find "estimated")
says(bent:with { bending = { twist = 1e-6 } }, "bending", "typed: changed by card:with")
says(bent:with { bending = false }, "bending", "nothing")
assert(not bent:with({ bending = false }).source:find("bending typed", 1, true))
says(bare:with { warp = { unloading = 1e9 }, provenance = { ["warp.unloading"] = "measured by hand" } }, "warp.unloading", "measured by hand")
says(card { warp = bare.warp }, "warp.unloading", "copied from the card 'mine' (there assumed: 4 times")
assert(next(fabric.card "denim".provenance) == "bending" and next(fabric.card "denim".provenance, "bending") == nil)

-- Origins are data of the card, not lines of its source: words that look like one stay words; what is stated is kept by a change, a copy and a file.
local own = denim:with { source = "our cloth\nbending: assumed to be that of denim, says the mill", provenance = { thickness = "measured: FAST-1, 20 samples", ["warp.loading"] = "copied: a \"table\"\nof two lines" } }
assert(own.source == "our cloth\nbending: assumed to be that of denim, says the mill")
assert(own.provenance.bending == denim.provenance.bending and own.provenance.thickness == "measured: FAST-1, 20 samples")
local file = os.tmpname() .. ".lua"
own:write(file)
local back = dofile(file)
os.remove(file)
assert(back.source == own.source and tostring(back) == tostring(own))
for field, words in pairs(own.provenance) do assert(back.provenance[field] == words, field) end
for field in pairs(back.provenance) do assert(own.provenance[field], field) end
local plain = fabric.svk { young = 1e7, poisson = 0.3, density = 500, thickness = 3e-4, through_thickness = true, source = "a\nthickness: assumed: 0.3 mm" }
assert(not plain.provenance and plain.source == "a\nthickness: assumed: 0.3 mm")
local words = "the source has the line 'thickness: assumed: 0.3 mm', which is words alone"
assert(tostring(plain:check()):find(words, 1, true), tostring(plain:check()))
assert(not tostring(own:check()):find("which is words alone", 1, true), "a card that states its origins")

-- Ranges of what is assumed are data: written, read, kept by card:with as long as the number is assumed, and what fabric.budget varies; words are words.
do
  local assumed = require "fabric.assumed"
  local function range_of(card, name)
    for _, input in ipairs(assumed.of(card)) do if input.name == name then return input[1], input[2], input.why end end
  end
  local guessed = fabric.card("denim"):with {
    provenance = { ["warp.poisson"] = "assumed: 0.3 (0.25 to 0.35), says a friend", ["shear.loading"] = "assumed: by eye", bending = "measured", ["bending.twist"] = "assumed: a third" },
    bending = { warp = 3e-5, weft = 2e-5, twist = 8e-6 }, ranges = { ["warp.poisson"] = { 0.22, 0.41 }, ["shear.loading"] = { 0.7, 1.6 }, ["bending.twist"] = { 0.3, 2.5 } } }
  for _, card in ipairs { guessed, guessed:with { name = "renamed" } } do
    fabric.expect {
      { "lowest ratio", (range_of(card, "warp.poisson")), 0.22, absolute = 0 }, { "highest", select(2, range_of(card, "warp.poisson")), 0.41, absolute = 0 },
      { "shear", select(2, range_of(card, "shear.loading")), 1.6, absolute = 0 }, { "twist", (range_of(card, "bending.twist")), 0.3, absolute = 0 },
    }
    assert(select(3, range_of(card, "shear.loading")) == "the card" and not range_of(card, "bending"))
  end
  local words = guessed:with { ranges = {} }
  assert(range_of(guessed:with { shear = { loading = { 2e5 } } }, "shear.loading") == nil, "a number that was typed is not assumed")
  assert(guessed:with { shear = { loading = { 2e5 } } }.ranges["shear.loading"] == nil)
  assert(words.ranges["warp.poisson"][1] == 0.22, "an empty table changes nothing")
  local plain = fabric.card("denim"):with { provenance = { ["warp.poisson"] = "assumed: 0.3 (0.25 to 0.35), says a friend" } }
  assert(range_of(plain, "warp.poisson") == 0.1 and plain.ranges == nil, "words are not read")
  local file = os.tmpname() .. ".lua"
  guessed:write(file)
  local back = fabric.card(file)
  os.remove(file)
  fabric.expect { { "read back", back.ranges["bending.twist"][2], 2.5, absolute = 0 }, { "and the shear", back.ranges["shear.loading"][1], 0.7, absolute = 0 } }
  assert(tostring(guessed):find("says a friend; 0.22 to 0.41", 1, true) and tostring(guessed):find("by eye; 0.7 to 1.6 times", 1, true), tostring(guessed))
  local fit = { loading = { 8e6, 8e8 }, unloading = 9e8, tested = 0.2 }
  local ruled = fabric.lab.card { name = "a", density = 600, thickness = 4e-4, warp = fit, assume = true }
  assert(ruled.ranges["weft.loading"][2] == 10 and ruled.ranges["shear.loading"][1] == 0.55)
end
