-- fabric.export.card: a card as the material of another solver, with a report of what is lost.
local fabric = require "fabric"
local define = require "fabric.define"
local units = require "fabric.export.units"
local targets = require "fabric.export.targets"
local curves = require "fabric.export.curves"
local loss = require "fabric.export.loss"
local rupture = require "fabric.export.rupture"
local gather = require "fabric.export.gather"
local fail = define.fail

local export = {}

-- Removes from a line of foreign text what is not allowed in a comment or a title.
local function tame(text) return (tostring(text):gsub("[%c]+", " "):gsub("[^\32-\126]", "?")) end

-- A name that all solvers accept: letters, digits, _ and -, beginning with a letter.
function export.name(card)
  local name = tame(card.name or ""):gsub("[^%w_-]", "_"):sub(1, 40)
  return name:find "^%a" and name or "fabric_" .. name
end

local function wrapped(out, text)
  local line = ""
  for word in text:gmatch "%S+" do
    if #line + #word > 110 then
      out[#out + 1] = line
      line = "  " .. word
    else
      line = line == "" and word or line .. " " .. word
    end
  end
  out[#out + 1] = line
end

local function target_of(t)
  local kind = t.card.kind
  local target = targets.find(t.to, t.material, kind)
  if not target and t.material then
    fail(("card: field 'material': expected %s for %s, got '%s'"):format(table.concat(targets.names(t.to), " or "), t.to, t.material))
  end
  if target and target.kinds[kind] then return target end
  local fits = {}
  for _, other in ipairs(targets.list) do
    if other.kinds[kind] then fits[#fits + 1] = other.name .. " (" .. other.solver .. ")" end
  end
  fail(("card: field 'card': %s takes no card of the law '%s'; such a card goes to %s"):format(
    target and target.name or t.to, kind, #fits > 0 and table.concat(fits, ", ") or "none of the materials known here"))
end

-- Assumptions of the card that no test has shown, the weightiest first: a curve of loading first, a sentence each; and the parts whose loading is assumed.
local function assumed(card)
  local loading, others, parts = {}, {}, {}
  for field, words in pairs(card.provenance or {}) do
    if words:find "^assumed" then
      local part = field:match "^(%w+)%.loading$"
      if part then parts[#parts + 1] = part end
      table.insert(part and loading or others, ("not measured: %s, %s"):format(field, words))
    end
  end
  table.sort(loading)
  table.sort(others)
  table.sort(parts)
  return table.move(others, 1, #others, #loading + 1, loading), parts
end

-- Nothing that a deck is made of is written as a measurement if it is none.
local function report_assumed(t, parts)
  if #parts == 0 then return end
  fabric.warn(("export: card '%s': the loading of the %s was not measured, it is assumed (%s); what is written for %s is a guess"):format(tame(t.card.name),
    table.concat(parts, " and "), t.card.provenance[parts[1] .. ".loading"]:match "^assumed: *(.*)", #parts == 1 and "it" or "them"))
end

-- Returns {target, parameters, rows, sentences, header} for a card; `t`: the fields of fabric.export.card.
function export.prepare(t)
  local target = target_of(t)
  local p = target.parameters(t.card)
  p.axis = t.axis and gather.unit(t.axis, "card: field 'axis'") or { 1.0, 0.0, 0.0 }
  if p.warp and type(p.warp) == "table" then
    local part, what, where = curves.falling(p, target.elastic and { "loading" } or { "loading", "unloading" })
    if part then
      fail(("card: field 'card': %s needs curves that rise everywhere; the %s of %s falls at %.4g in its measure"):format(
        target.name, what, part, where))
    end
  end
  local rows = loss.rows(t.card, function() return target.law(p) end)
  local sentences = loss.sentences(t.card, target)
  local breaks, strains = rupture.prepare(t, target, target.fails_by_itself and target.law(p))
  table.move(breaks, 1, #breaks, #sentences + 1, sentences)
  p.failure = strains
  local guesses, parts = assumed(t.card)
  table.move(guesses, 1, #guesses, #sentences + 1, sentences)
  report_assumed(t, parts)
  return target, p, rows, sentences
end

local function header(t, target, p, u, rows, sentences)
  local out = {}
  local from = t.card.source ~= "" and t.card.source or "not said by the card"
  wrapped(out, ("Cloth '%s', from the card of fabricsh; its source: %s"):format(tame(t.card.name), tame(from)))
  out[#out + 1] = ("Units: %s (%s)"):format(u.words, u.name)
  wrapped(out, "Material as in: " .. target.source)
  wrapped(out, "Measures: " .. (p.words or target.measure) .. ". The section's thickness is " .. ("%.6g"):format(t.card.thickness * u.length))
  if t.card.kind == "woven" then
    local tested = t.card.tested
    wrapped(out, ("Tested up to E11 = %.4g, E22 = %.4g, E12 = %.4g; beyond that the curves continue as those of the card do"):format(tested.warp, tested.weft, tested.shear))
  end
  out[#out + 1] = "Losses of this law against the card's:"
  for _, l in ipairs(loss.lines(rows)) do out[#out + 1] = "  " .. l end
  for _, s in ipairs(sentences) do wrapped(out, "- " .. s) end
  return out
end

local function run(t)
  local target, p, rows, sentences = export.prepare(t)
  local u = units.of(t.units)
  local head = header(t, target, p, u, rows, sentences)
  local begins = ({ ["ls-dyna"] = "*KEYWORD\n", openradioss = "#RADIOSS STARTER\n", abaqus = "" })[t.to]
  local ends = t.to == "ls-dyna" and "\n*END\n" or "\n"
  local body = target.write(t.card, export.name(t.card), p, u, t.id)
  local text = target.comment(head) .. "\n" .. body
  local lost = {}
  for _, r in ipairs(rows) do lost[r.path] = r end
  local result = { text = begins .. text .. ends, body = text, material = target.name, solver = t.to, units = t.units, losses = rows, lost = lost,
    sentences = sentences, report = table.concat(head, "\n"), parameters = p, law = function() return target.law(p) end }
  if t.file then
    fabric.write(t.file, result.text)
    result.file = t.file
  end
  return setmetatable(result, { __tostring = function(r) return r.report end })
end
export.run = run

export.arguments = {
  { name = "units", kind = "text", choices = units.names, default = "mm-t-s", sentence = "that the deck is written in" },
}

define {
  name = "fabric.export.card",
  arguments = {
    { name = "card", of = "card", sentence = "the fabric" },
    { name = "to", kind = "text", choices = targets.solvers, sentence = "the solver" },
    { name = "material", kind = "text", optional = true,
      sentence = "ls-dyna: MAT_034 (default) or MAT_235; openradioss: LAW58 (default), LAW158 or LAW19; abaqus: FABRIC, or ELASTIC for svk cards" },
    { name = "file", kind = "text", optional = true, sentence = "where the text goes; default: it is only returned" },
    export.arguments[1],
    { name = "id", kind = "integer", low = 1, high = 9999, default = 1, sentence = "of the material; curves are 10 id + 1 and on" },
    { name = "axis", kind = "numbers", optional = true, sentence = "direction of the warp {x, y, z} where the material holds it (LS-DYNA); default {1, 0, 0}" },
    { name = "element", kind = "number", unit = "m", above = 0, optional = true,
      sentence = "size of the elements along the yarns that break: with it the card's rupture is written where the material takes one (LAW58, LAW158: /FAIL/FABRIC)" },
  },
  sentence = "A card as a material of another solver, its curves in that solver's measures of strain and stress. Returns text, material, report "
    .. "(text), losses: a row for each path {path, worst, rms, work: per cent of the card's own peak stress and work, where, peak, strain, ours, "
    .. "theirs}, lost: the same by path (warp, weft, biaxial, bias, \"cyclic warp\", \"cyclic weft\", \"cyclic shear\"), and sentences on what no row shows.",
  example = "local r = fabric.export.card{ card=fabric.card 'blend', to='abaqus' }\n"
    .. "assert(r.text:find '*FABRIC' and r.lost.warp.worst < 0.1 and r.lost.biaxial.worst > 1)",
  run = run,
}

return export
