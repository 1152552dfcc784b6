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
  ["мм"] = "mm", ["см"] = "cm", ["м"] = "m", ["Н"] = "N", ["кН"] = "kN", ["даН"] = "daN", ["гс"] = "gf", ["кгс"] = "kgf", ["с"] = "s", ["сек"] = "s", ["мин"] = "min", ["мс"] = "ms",
  ["毫米"] = "mm", ["厘米"] = "cm", ["牛"] = "N", ["牛顿"] = "N", ["千牛"] = "kN", ["分"] = "min", ["초"] = "s", ["\xec\xec"] = "mm", ["\xf1\xec"] = "cm", ["\xcd"] = "N", ["\xea\xcd"] = "kN", ["\xe4\xe0\xcd"] = "daN", ["\xf1"] = "s", seconds = "s", second = "s", Sekunden = "s", secondes = "s", segundos = "s", secondi = "s",
  ["sn"] = "s", ["seg"] = "s", millimeters = "mm", newtons = "N", Newton = "N",
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

-- Parts of names, in lower case without accents: English, German, French, Italian, Spanish, Portuguese, Dutch, Swedish, Turkish, Polish, Czech, Russian, Chinese,
-- Japanese (UTF-8 and Shift-JIS, whose second bytes may be letters, here in lower case; frames also write Katakana of half width), Korean. The unit
-- decides between a displacement and a strain.
words.names = {
  displacement = { "displacement", "extension", "elongation", "crosshead", "stroke", "position", "travel", "weg", "verlangerung", "verlaengerung",
    "verformung", "auszug", "deplacement", "allongement", "deformation", "course", "elongazione", "spostamento", "allungamento", "estensione", "corsa", "przemieszczenie", "wydluzenie", "droga", "skok",
    "desplazamiento", "alargamiento", "elongacion", "recorrido", "carrera", "deslocamento", "alongamento", "extensao", "verplaatsing", "uitrekking", "verlenging",
    "draha", "posuv", "protazeni", "prodlouzeni", "forlangning", "forskjutning", "stracka", "extensie", "erweiterung", "grip separation", "tool separation", "jaw separation", "separation", "traverse", "traversa", "traverso", "travesano", "travessa", "trawers", "pricnik", "траверс",
    "werkzeugabstand", "backenabstand", "klemmenabstand", "klemmabstand", "einspannabstand", "langenanderung", "laengenaenderung", "actuator", "change in length", "length change", "ecartement", "distanza", "afstand", "rozstaw", "vzdalenost", "avstand",
    "拉伸距离", "夹具间距", "夹头间距", "夾具間距", "夹距", "移动距离", "移動距離", "移動量", "つかみ具間", "チャック間", "クロスヘッド", "크로스헤드", "이동거리", "이동량", "зажим", "standart yol", "kontrol yolu", "uzama", "yer degistirme", "deplasman", "przesuniecie", "rozciagniecie", "перемещение", "удлинение", "растяжение", "путь",
    "位移", "伸长", "伸長", "变形", "變形", "行程", "변위", "신장", "연신", "스트로크",
    "\u{ff7d}\u{ff84}\u{ff9b}\u{ff70}\u{ff78}", "\u{4f38}\u{5ea6}",
    "\x90l\x82\xd1", "\u{5909}\u{4f4d}", "\u{30b9}\u{30c8}\u{30ed}\u{30fc}\u{30af}", "\u{4f38}\u{3073}", "\x95\xcf\x88\xca", "\x83x\x83g\x83\x8d\x81[\x83n" },
  force = { "force", "load", "kraft", "belastung", "effort", "charge", "forza", "carico", "sila", "obciazenie", "fuerza", "carga", "forca", "kracht", "belasting", "kuvvet", "zatizeni", "pruflast", "prueflast", "zuglast", "traccion", "tracao", "dragkraft", "dinamometro", "loadcell", "kraftaufnehmer",
    "сила", "усилие", "нагрузка", "载荷", "載荷", "负荷", "負荷", "拉力", "力值", "试验力", "試驗力", "标准力", "標準力", "负载", "負載", "拉伸力", "引張力", "인장력", "하중", "시험력", "\u{8377}\u{91cd}", "\u{8a66}\u{9a13}\u{529b}", "\x89\xd7\x8fd",
    "\x8e\x8e\x8c\xb1\x97\xcd" },
  time = { "time", "zeit", "temps", "duree", "tempo", "czas", "tiempo", "tijd", "zaman", "время", "时间", "時間", "시간", "\x8e\x9e\x8a\xd4" },
  strain = { "strain", "dehnung", "deformazione", "odksztalcenie", "deformacion", "deformacao", "gerinim", "деформация", "应变", "應變", "변형률", "변형", "신율", "\u{3072}\u{305a}\u{307f}", "\u{6b6a}" },
}
-- Of the displacement's words those of the part of a machine that moves.
words.parts = { "traverse", "traversa", "traverso", "travesano", "travessa", "trawers", "pricnik", "траверс", "actuator" }
-- Names that consist of one of these only.
words.letters = { u = "displacement", ext = "displacement", disp = "displacement", elong = "displacement", dl = "displacement", p = "force", f = "force", t = "time",
  last = "force", yuk = "force", ["力"] = "force", ["힘"] = "force", hub = "displacement", slag = "displacement", curso = "displacement", ["ход"] = "displacement", rek = "strain",
  sure = "time", cas = "time", tid = "time", ["\xc1\xa6"] = "force", ["\x97\xcd"] = "force" } -- the last: one sign of Chinese in GBK, of Shift-JIS
-- Chinese in GBK, Russian in Windows-1251 and Korean in its code page 949, as frames write them that know no UTF-8.
words.bytes = {
  { "\xce\xbb\xd2\xc6", "displacement" }, { "\xb1\xe4\xd0\xce", "displacement" }, { "\xc9\xec\xb3\xa4", "displacement" }, { "\xca\xb1\xbc\xe4", "time" },
  { "\xd4\xd8\xba\xc9", "force" }, { "\xb8\xba\xba\xc9", "force" }, { "\xca\xd4\xd1\xe9\xc1\xa6", "force" }, { "\xc0\xad\xc1\xa6", "force" }, { "\xd3\xa6\xb1\xe4", "strain" },
  { "\xe5\xf0\xe5\xec\xe5\xf9\xe5\xed\xe8\xe5", "displacement" }, { "\xe4\xeb\xe8\xed\xe5\xed\xe8\xe5", "displacement" }, { "\xe8\xeb\xe0", "force" },
  { "\xba\xaf\xc0\xa7", "displacement" }, { "\xbd\xc5\xc0\xe5", "displacement" }, { "\xbf\xac\xbd\xc5", "displacement" }, { "\xc7\xcf\xc1\xdf", "force" },
  { "\xbd\xc3\xc7\xe8\xb7\xc2", "force" }, { "\xbd\xc3\xb0\xa3", "time" },
  { "\xf1\xe8\xeb\xe8\xe5", "force" }, { "\xe0\xe3\xf0\xf3\xe7\xea\xe0", "force" }, { "\xf0\xe5\xec\xff", "time" },
}

-- Names of specimens in columns and lines; and the words that may stand beside it in the name of such a column.
words.specimens = { "specimen", "sample", "probe", "prufling", "pruefling", "eprouvette", "echantillon", "probeta", "muestra", "provino", "campione", "provete", "amostra", "proefstuk",
  "numune", "probka", "vzorek", "provkropp", "prov", "образец", "试样", "試樣", "試験片", "시편", "replicate",
  "\x8e\x8e\x8c\xb1\x95\xd0", "\xca\xd4\xd1\xf9", "\xce\xe1\xf0a\xe7\xe5o", "\xee\xe1\xf0a\xe7\xe5o" } -- the last four in Shift-JIS, GBK and (as words.plain leaves them) Windows-1251
-- Words of a test, which name the specimen in a column, but not in a line above a heading ("Test method").
words.tests = { "test", "versuch", "prufung", "pruefung", "essai", "ensayo", "prova", "ensaio", "badanie", "zkouska", "испытание", "试验", "試驗", "試験", "시험" }
words.beside_specimen = { no = true, nr = true, number = true, nummer = true, id = true, name = true, label = true, ["#"] = true, numero = true, ["n\u{b0}"] = true, ["\u{2116}"] = true }

words.quantities = { "displacement", "force", "time", "strain" }

local plain_letters = { ["\u{df}"] = "ss", ["\u{a0}"] = " ", ["\u{202f}"] = " ", ["\u{3000}"] = " ", ["\u{307}"] = "", ["\u{301}"] = "", ["\u{308}"] = "" }
for plain, letters in pairs {
  e = "éÉèÈêÊëËęĘěĚ", a = "àÀáÁâÂäÄãÃąĄåÅ", u = "üÜùÙúÚûÛůŮ", o = "öÖòÒóÓôÔõÕ", l = "łŁ", c = "ćĆçÇčČ", s = "śŚşŞšŠ", z = "żŻźŹžŽ", n = "ńŃñÑňŇ", r = "řŘ", y = "ýÝ", i = "ìÌíÍîÎïÏıİ", g = "ğĞ",
} do
  for _, code in utf8.codes(letters) do plain_letters[utf8.char(code)] = plain end
end
for code = 0x410, 0x42f do plain_letters[utf8.char(code)] = utf8.char(code + 0x20) end -- Cyrillic capitals
plain_letters["Ё"], plain_letters["ё"] = "е", "е"
-- Accented letters in Latin 1, Polish and Czech ones in Windows-1250 and Latin 2, and Turkish ones in Windows-1254, which are not valid UTF-8. (Bytes with two meanings: n with acute is n
-- with tilde in Latin 1, c with acute is ae.)
local latin = { ["\xe9"] = "e", ["\xc9"] = "e", ["\xe8"] = "e", ["\xe4"] = "a", ["\xc4"] = "a", ["\xfc"] = "u", ["\xdc"] = "u", ["\xf6"] = "o", ["\xd6"] = "o",
  ["\xe0"] = "a", ["\xf2"] = "o", ["\xdf"] = "ss", ["\xb3"] = "l", ["\xa3"] = "l", ["\xbf"] = "z", ["\xaf"] = "z", ["\xb9"] = "a", ["\xb1"] = "a",
  ["\xea"] = "e", ["\xe3"] = "a", ["\xe1"] = "a", ["\xe2"] = "a", ["\xe7"] = "c", ["\xc7"] = "c", ["\xf5"] = "o", ["\xf4"] = "o", ["\xed"] = "i", ["\xee"] = "i", ["\xfd"] = "i",
  ["\xdd"] = "i", ["\xfa"] = "u", ["\xfb"] = "u", ["\xf0"] = "g", ["\xd0"] = "g", ["\xfe"] = "s", ["\xde"] = "s", ["\xc8"] = "c", ["\xf3"] = "o", ["\xd3"] = "o", ["\xf1"] = "n", ["\xe6"] = "c", ["\xb6"] = "s" }

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
