-- The words by which fabric.lab.read recognises columns, units, and the words that a user adds.
local words = {}

local inch, pound = 0.0254, 4.4482216152605

-- SI sizes of units, by quantity. A force per width of the specimen is composed of a force and a length (words.per_width); the list has what a user adds.
words.units = {
  displacement = { m = 1, mm = 1e-3, cm = 1e-2, um = 1e-6, ["in"] = inch },
  force = { N = 1, kN = 1e3, daN = 10, mN = 1e-3, cN = 1e-2, gf = 9.80665e-3, kgf = 9.80665, lbf = pound, ozf = pound / 16 },
  ["force per width"] = {},
  time = { s = 1, ms = 1e-3, min = 60, h = 3600 },
  strain = { ["-"] = 1, ["%"] = 1e-2, ["mm/mm"] = 1, ["1"] = 1, ["m/m"] = 1, ["in/in"] = 1, ["mm/m"] = 1e-3, ["um/m"] = 1e-6, ["\u{2030}"] = 1e-3 },
}

words.aliases = { MM = "mm", CM = "cm", inch = "in", inches = "in", ["in."] = "in", ['"'] = "in", KN = "kN", kp = "kgf", lb = "lbf", lbs = "lbf", S = "s",
  sec = "s", Sec = "s", sek = "s", Sek = "s", n = "N", DaN = "daN", dan = "daN", DAN = "daN", CN = "cN", oz = "ozf", ["\u{79d2}"] = "s",
  ["\u{b5}m"] = "um", ["\u{3bc}m"] = "um", ["\xb5m"] = "um", ["\u{b5}m/m"] = "um/m", ["\u{3bc}m/m"] = "um/m", ["\xb5m/m"] = "um/m",
  percent = "%", Percent = "%", pct = "%", Prozent = "%", prozent = "%", ["per cent"] = "%" }

-- Words of a mass that frames write for the force of its weight.
words.masses = { lb = true, lbs = true, oz = true }

-- Units of mass that are refused for a force, and the force to name where the weight was meant.
words.weights = { kg = "kgf", Kg = "kgf", KG = "kgf", g = "gf" }

-- SI size of a force over a width, as N/mm, kgf/5 cm, lbf/in; nil for anything else. Second: the force as written.
function words.per_width(vocabulary, unit)
  local force, count, length = unit:match "^%s*([^/]-)%s*/%s*([%d.,]*)%s*([^/]-)%s*$"
  if not force then return end
  local function size(quantity, word) return vocabulary.units[quantity][word] or vocabulary.units[quantity][vocabulary.aliases[word] or word] end
  local top, below = size("force", force), size("displacement", length)
  local times = count == "" and 1 or tonumber((count:gsub(",", ".")))
  if top and below and times and times > 0 then return top / (times * below), force end
end

-- Parts of names, in lower case without accents: English, German, French, Italian, Polish, Japanese (UTF-8 and Shift-JIS, whose second bytes
-- may be letters, here in lower case; frames also write Katakana of half width). The unit decides between a displacement and a strain.
words.names = {
  displacement = { "displacement", "extension", "elongation", "crosshead", "stroke", "position", "travel", "weg", "verlangerung", "verlaengerung",
    "verformung", "auszug", "deplacement", "allongement", "deformation", "course", "elongazione", "spostamento", "allungamento", "estensione", "corsa", "przemieszczenie", "wydluzenie", "droga", "skok",
    "\u{ff7d}\u{ff84}\u{ff9b}\u{ff70}\u{ff78}", "\u{4f38}\u{5ea6}",
    "\u{5909}\u{4f4d}", "\u{30b9}\u{30c8}\u{30ed}\u{30fc}\u{30af}", "\u{4f38}\u{3073}", "\x95\xcf\x88\xca", "\x83x\x83g\x83\x8d\x81[\x83n" },
  force = { "force", "load", "kraft", "effort", "charge", "forza", "carico", "sila", "obciazenie", "\u{8377}\u{91cd}", "\u{8a66}\u{9a13}\u{529b}", "\x89\xd7\x8fd",
    "\x8e\x8e\x8c\xb1\x97\xcd" },
  time = { "time", "zeit", "temps", "tempo", "czas", "\u{6642}\u{9593}", "\x8e\x9e\x8a\xd4" },
  strain = { "strain", "dehnung", "deformazione", "odksztalcenie", "\u{3072}\u{305a}\u{307f}", "\u{6b6a}" },
}
-- Names that consist of one of these only.
words.letters = { u = "displacement", ext = "displacement", disp = "displacement", elong = "displacement", dl = "displacement", p = "force", f = "force", t = "time" }

words.quantities = { "displacement", "force", "time", "strain" }

local plain_letters = {}
for letters, plain in pairs {
  ["\u{e9}\u{c9}\u{e8}\u{c8}\u{ea}\u{eb}\u{119}\u{118}"] = "e", ["\u{e0}\u{e1}\u{e2}\u{e4}\u{c4}\u{105}\u{104}"] = "a", ["\u{fc}\u{dc}\u{f9}\u{fa}"] = "u",
  ["\u{f6}\u{d6}\u{f2}\u{f3}\u{d3}\u{f4}"] = "o", ["\u{142}\u{141}"] = "l", ["\u{107}\u{106}\u{e7}"] = "c", ["\u{15b}\u{15a}"] = "s",
  ["\u{17c}\u{17b}\u{17a}\u{179}"] = "z", ["\u{144}\u{143}"] = "n", ["\u{ec}\u{ed}"] = "i", ["\u{df}"] = "ss",
} do
  for _, code in utf8.codes(letters) do plain_letters[utf8.char(code)] = plain end
end
-- Accented letters in Latin 1, and Polish ones in Windows-1250 and Latin 2, which are not valid UTF-8. (Bytes with two meanings: n with acute is n
-- with tilde in Latin 1, c with acute is ae.)
local latin = { ["\xe9"] = "e", ["\xc9"] = "e", ["\xe8"] = "e", ["\xe4"] = "a", ["\xc4"] = "a", ["\xfc"] = "u", ["\xdc"] = "u", ["\xf6"] = "o", ["\xd6"] = "o",
  ["\xe0"] = "a", ["\xf2"] = "o", ["\xdf"] = "ss", ["\xb3"] = "l", ["\xa3"] = "l", ["\xbf"] = "z", ["\xaf"] = "z", ["\xb9"] = "a", ["\xb1"] = "a",
  ["\xea"] = "e", ["\xf3"] = "o", ["\xd3"] = "o", ["\xf1"] = "n", ["\xe6"] = "c", ["\xb6"] = "s" }

-- A name in lower case without accents.
function words.plain(name)
  if utf8.len(name) then
    name = name:gsub("[\xc2-\xf4][\x80-\xbf]+", plain_letters)
  elseif not name:find "[\x81-\x9f]" then -- bytes that Latin 1 does not use are those of Shift-JIS
    name = name:gsub("[\xa3-\xff]", latin)
  end
  return (name:gsub("%u", string.lower))
end

local function copy(t)
  local out = {}
  for k, v in pairs(t) do out[k] = type(v) == "table" and copy(v) or v end
  return out
end

-- The vocabulary with a user's words before the built-in ones: {force={"siua"}, displacement={...}, time=, strain=, units={force={dyn=1e-5}}}.
-- fail(message) raises the error for an invalid one.
function words.with(more, from, fail)
  local out = { units = copy(words.units), aliases = words.aliases, names = copy(words.names), letters = words.letters, quantities = words.quantities,
    own = {} }
  for key, list in pairs(more) do
    if key ~= "units" and not out.names[key] then
      fail(("%s: expected displacement, force, time, strain or units, got '%s'"):format(from, tostring(key)))
    end
    if type(list) ~= "table" then fail(("%s: field '%s': expected a table, got %s"):format(from, key, tostring(list))) end
    if key == "units" then
      for quantity, own in pairs(list) do
        if not out.units[quantity] or type(own) ~= "table" then
          fail(("%s: field 'units': expected displacement, force, 'force per width', time or strain with { unit=SI per unit }, got '%s'"):format(from,
            tostring(quantity)))
        end
        for unit, factor in pairs(own) do
          if type(factor) ~= "number" or not (factor > 0) or type(unit) ~= "string" then
            fail(("%s: field 'units.%s': expected a positive number for each unit, got %s = %s"):format(from, quantity, tostring(unit), tostring(factor)))
          end
          out.units[quantity][unit] = factor
        end
      end
    else
      for i, word in ipairs(list) do
        if type(word) ~= "string" or word == "" then fail(("%s: field '%s': expected words, got %s at place %d"):format(from, key, tostring(word), i)) end
        table.insert(out.names[key], 1, words.plain(word))
        out.own[#out.own + 1] = { words.plain(word), key }
      end
    end
  end
  return out
end

return words
