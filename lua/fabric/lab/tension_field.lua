-- fabric.lab.tension_field: a card for meshes whose elements are larger than the folds of the cloth.
--
-- Cloth that is shortened along a yarn folds at a force that is next to nothing. Elements larger than its folds cannot; they are compressed
-- instead, and carry what the cloth would not. In a tension field [steigmann1990] such a sheet gives way without a force: what an element
-- then is shorter stands for the folds in it.
local define = require "fabric.define"
local stress = require("fabric.lab.loading").stress

local soft = 1e-3   -- modulus of a yarn that is shortened, over that at the beginning of its loading curve
local places = 40   -- of a curve that is given by moduli
local growth = 1.5  -- of the steps between points behind the slack

-- The curve with next to no stress up to the strain `slack`. Cards go on into compression with the slope at zero.
local function slackened(name, loading, upto, slack)
  local given = type(loading[1]) == "table"
  local last = given and loading[#loading][1] or upto
  if slack > last / 10 then
    define.fail(("tension_field: field 'slack': expected at most a tenth of the %s curve, %.3g, got %.3g"):format(name, last / 10, slack))
  end
  local out, E, step = { { 0, 0 }, { slack, soft * stress(loading, slack) } }, slack, 4 * slack -- so that it steepens by no more than a quarter on its way back
  local function add(at) out[#out + 1] = { at, stress(loading, at) } end
  while E + growth * step < last and step < last / places do
    E, step = E + step, growth * step
    add(E)
  end
  if given then
    for _, p in ipairs(loading) do
      if p[1] > E + step / growth then out[#out + 1] = { p[1], p[2] } end
    end
  else
    local n = math.ceil((last - E) / (last / places))
    for k = 1, n do add(E + (last - E) * k / n) end
  end
  return out
end

define {
  name = "fabric.lab.tension_field",
  arguments = {
    { name = "card", of = "card", sentence = "a woven card" },
    { name = "slack", kind = "number", above = 0, high = 0.05, default = 1e-3, sentence = "strain up to which a yarn carries next to nothing; at five times that it carries what it did" },
  },
  sentence = "A card whose yarns carry next to nothing where they are shortened, as cloth that folds: for garments and drapes on elements larger than the folds. In tension nothing changes from five times `slack` on.",
  example = "local fabric = require 'fabric'\nlocal card = fabric.lab.tension_field{ card=fabric.card 'blend' }\n"
    .. "local before, after = fabric.point(fabric.card 'blend'), fabric.point(card)\n"
    .. "assert(math.abs(after:uniaxial('warp', 0.1).S / before:uniaxial('warp', 0.1).S - 1) < 1e-3)\n"
    .. "assert(fabric.point(card):uniaxial('warp', -0.05).S > -1e3)",
  run = function(t)
    if t.card.kind ~= "woven" then define.fail(("tension_field: field 'card': expected a woven card, got one of kind '%s'"):format(t.card.kind)) end
    local tested, changes = t.card.tested or {}, { provenance = {} }
    for field, words in pairs(t.card.provenance or {}) do changes.provenance[field] = words end
    for _, name in ipairs { "warp", "weft" } do
      changes[name] = { loading = slackened(name, t.card[name].loading, tested[name] or 0.3, t.slack) }
      local of = changes.provenance[name .. ".loading"]
      changes.provenance[name .. ".loading"] = ("assumed: a tension field, nothing is carried up to E = %g%s"):format(t.slack, of and "; before: " .. of or "")
    end
    return t.card:with(changes)
  end,
}
