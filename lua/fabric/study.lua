-- fabric.study: the same run for many parameters, in parallel processes; finished cases are kept.
local fabric = require "fabric"
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local fail = define.fail
local case_file = require "fabric.study_case"
local lists = require "fabric.lists"

local function check_value(path, value)
  local kind = type(value)
  if kind ~= "number" and kind ~= "string" and kind ~= "boolean" then
    fail(("study: field '%s': expected a number, a string or true or false, got %s"):format(path, kind == "nil" and "nil" or "a " .. kind))
  end
end

-- A name that every file format can hold, or the complaint.
local function wrong_name(name)
  if utf8.len(name) and not name:find "%c" then return nil end
  return ("expected a name in UTF-8 without control characters, got '%s'"):format((name:gsub("[^ -~]", "?")))
end

-- The list of cases as given: {{a=1, b=2}, ...}.
local function listed(list)
  for i, case in ipairs(list) do
    if type(case) ~= "table" then fail(("study: field 'parameters[%d]': expected a table of named values, got %s"):format(i, tostring(case))) end
    for name, value in pairs(case) do
      if type(name) ~= "string" then fail(("study: field 'parameters[%d]': expected names, got '%s'"):format(i, tostring(name))) end
      check_value(("parameters[%d].%s"):format(i, name), value)
    end
  end
  return list
end

-- All combinations of {a={1,2}, b={...}}: names in alphabetical order, the last one varies fastest.
local most_cases = 1000000
local function grid(values_of)
  local cases = { {} }
  for _, name in ipairs(lists.keys(values_of)) do
    local values, more = values_of[name], {}
    if type(values) == "table" and #cases * #values > most_cases then
      fail(("study: field 'parameters': expected lists whose combinations are at most %d cases, got %.3g and more with '%s'"):format(most_cases, #cases * #values, tostring(name)))
    end
    if type(name) ~= "string" or type(values) ~= "table" or #values == 0 then
      fail(("study: field 'parameters.%s': expected a list of values, got %s"):format(name, type(values) == "table" and "an empty table" or tostring(values)))
    end
    for i, value in ipairs(values) do check_value(("parameters.%s[%d]"):format(name, i), value) end
    for _, case in ipairs(cases) do
      for _, value in ipairs(values) do
        local longer = { [name] = value }
        for k, v in pairs(case) do longer[k] = v end
        more[#more + 1] = longer
      end
    end
    cases = more
  end
  return cases
end

local function cases_of(t)
  if (t.parameters == nil) == (t.sample == nil) then fail "study: expected either 'parameters' or 'sample'" end
  local parameters = t.parameters or t.sample
  if next(parameters) == nil then fail "study: field 'parameters': expected lists of values by name, or a list of cases, got an empty table" end
  local cases = #parameters > 0 and listed(parameters) or grid(parameters)
  local seen = {}
  for i, case in ipairs(cases) do
    local key = case_file.key(case)
    if seen[key] then fail(("study: field 'parameters': cases %d and %d are the same (%s)"):format(seen[key], i, case_file.words(case))) end
    seen[key] = i
  end
  return cases
end

-- Reads which cases this process computes: all, or those of a task in an array job.
local most_tasks = 1e9 -- far above what Slurm permits
local function whole_number(name, default, low)
  local text = os.getenv(name)
  if text == nil or text == "" then return default end
  local n = math.tointeger(tonumber(text))
  if not n or n < low or n > most_tasks then
    fail(("study: the variable %s: expected a whole number of at least %d and at most %d, got '%s'"):format(name, low, most_tasks, text))
  end
  return n
end

-- The case of --case, of the deck's only study.
local asked_before = false
local function asked(count)
  local k = kernels.asked_case()
  if k == nil then return nil end
  if asked_before then fail "study: --cases and --case are for decks with one study; this is the second one" end
  asked_before = true
  if k ~= "list" and k > count then fail(("study: --case %d: the study has %d cases"):format(k, count)) end
  return k
end

local function share(only)
  if only then return function(i) return i == only end end
  local id = whole_number("SLURM_ARRAY_TASK_ID", nil, 0)
  if not id then return function() return true end end
  local count, first, step = whole_number("SLURM_ARRAY_TASK_COUNT", 1, 1), whole_number("SLURM_ARRAY_TASK_MIN", 0, 0), whole_number("SLURM_ARRAY_TASK_STEP", 1, 1)
  local place = (id - first) // step
  if place < 0 or place >= count then
    fail(("study: task %d is outside the array of %d tasks that begins at %d: give the array as a plain range, --array=1-%d"):format(id, count, first, count))
  end
  return function(i) return (i - 1) % count == place end
end

-- A folder belongs to one version of a deck, so that different results are not mixed. Lines behind the end of run() in the deck cannot
-- change its results.
local function claim(folder, deck)
  local path = folder .. "/study.txt"
  local f = io.open(path)
  if f then
    local owner = f:read "a"
    f:close()
    if owner ~= deck then
      fail(("study: the folder '%s' holds results of another deck, or of this one before it was changed: remove it, or give another folder"):format(folder))
    end
    return
  end
  fabric.write(path, deck)
end

-- A folder is computed by one program at a time; tasks of an array job and single cases share it by their numbers.
local function alone(t)
  if t.only or os.getenv "SLURM_ARRAY_TASK_ID" then return nil end
  local held, why = define.lock(t.folder .. "/study.csv")
  if not held then
    fail(("study: the folder '%s' is being computed by another program (%s): wait for it, give another folder, or share the cases by an array job or --case"):format(t.folder, why))
  end
  return held
end

-- The text by which a folder belongs to a deck: a hash of the deck up to the end of run().
local function identity(run)
  local f = arg and arg[0] and io.open(arg[0], "rb")
  local text = f and f:read "a" or ""
  if f then f:close() end
  local info = debug and debug.getinfo(run, "S")
  if info and arg and info.source == "@" .. tostring(arg[0]) then
    local lines, place = 0, 1
    while lines < info.lastlinedefined and place do
      lines, place = lines + 1, text:find("\n", place, true)
      place = place and place + 1
    end
    text = place and text:sub(1, place - 1) or text
  end
  return "fabricsh study 1\ndeck " .. case_file.hash(text) .. "\n"
end

-- An error in words: a table without a text of its own is described by its plain fields, not by its address.
local function words_of(trouble)
  local kind = type(trouble)
  local own = kind == "table" and getmetatable(trouble)
  if kind ~= "table" and kind ~= "function" and kind ~= "thread" or kind == "table" and own == false or type(own) == "table" and own.__tostring then return tostring(trouble) end
  if kind ~= "table" then return "an error that is a " .. kind end
  local fields = {}
  for key, value in next, trouble do
    if type(key) ~= "table" and type(value) ~= "table" and pcall(check_value, "", key) and pcall(check_value, "", value) then
      fields[#fields + 1] = tostring(key) .. "=" .. tostring(value)
    end
  end
  table.sort(fields)
  return "an error that is a table" .. (#fields > 0 and ": " .. table.concat(fields, ", ") or "")
end

-- Column names of study.csv that a result must not have: the fixed ones, and those of parameters with another value.
local function taken_names(cases)
  local taken = {}
  for _, name in ipairs { "case", "warnings", "trouble" } do taken[name] = "study.csv has a column of that name" end
  for _, case in ipairs(cases) do
    for name in pairs(case) do
      if name == "case" or name == "warnings" or name == "trouble" then fail(("study: field 'parameters': no parameter can be named '%s': %s"):format(name, taken[name])) end
      if wrong_name(name) then fail("study: field 'parameters': " .. wrong_name(name)) end
      taken[name] = "a parameter has that name"
    end
  end
  return taken
end

local function checked_values(values, taken, case)
  if type(values) ~= "table" then error("study: expected run(p) to return a table of named values, got " .. (values == nil and "nil" or "a " .. type(values)), 0) end
  for name, value in pairs(values) do
    if type(name) ~= "string" then error("study: expected run(p) to return named values, got an entry without a name", 0) end
    if wrong_name(name) then error("study: results: " .. wrong_name(name), 0) end
    if taken[name] and value ~= case[name] then error(("study: no result can be named '%s': %s"):format(name, taken[name]), 0) end
    check_value(name, value)
  end
  return values
end

local no_memory = "not enough memory" -- raised by Lua itself

local function work(t, case)
  local place, before = define.log_end(), define.refusals()
  local good, values = pcall(function() return checked_values(t.run(case), t.taken, case) end)
  collectgarbage()  -- closes files that a run has left open
  local trouble = not good and words_of(values) or nil
  -- A case that ended for want of disk or memory has no result: nothing is kept, and the case runs again next time.
  if trouble and (define.refusals() > before or values == no_memory) then error(trouble, 0) end
  case_file.save(t.folder, case, good and values or nil, trouble, define.warnings(place))
  if trouble then error(trouble, 0) end
  return { 1 }  -- the values are in the file
end

local function kept(t, cases)
  return lists.sum(cases, function(case) return (case_file.load(t.folder, case) and 1 or 0) end)
end

-- Computes the missing cases of this share; returns the errors of processes that left no file, by case.
local function compute(t, cases)
  local mine, missing, troubles = share(t.only), {}, {}
  for i, case in ipairs(cases) do
    local known = mine(i) and case_file.load(t.folder, case)
    if mine(i) and (not known or (t.again and known.trouble)) then missing[#missing + 1] = i end
  end
  if #missing == 0 then return troubles end
  local good, answers = pcall(fabric.lab.parallel, { count = #missing, processes = t.workers, isolated = true, progress = "study",
    work = function(k) return work(t, cases[missing[k]]) end })
  if not good then
    local why = tostring(answers):match "parallel: (.*)" or tostring(answers)
    fail(("study: %s; %d of %d cases are kept in '%s', run the same deck again to continue"):format(why, kept(t, cases), #cases, t.folder))
  end
  for k, answer in ipairs(answers) do troubles[missing[k]] = answer.trouble end
  return troubles
end

local function collect(t, cases, troubles)
  local study = { folder = t.folder, file = t.folder .. "/study.csv", missing = 0, failed = 0 }
  local names, results = {}, {}
  for i, case in ipairs(cases) do
    local known = case_file.load(t.folder, case)
    local row = { parameters = case, values = known and known.values, trouble = known and known.trouble, warnings = known and known.warnings or {} }
    if not known then  -- a process that ended without a message: the case is run again next time
      study.missing, row.trouble = study.missing + 1, troubles[i]
    elseif known.trouble then
      study.failed = study.failed + 1
    end
    for name in pairs(case) do names[name] = true end
    for name in pairs(row.values or {}) do results[name] = true end
    study[i] = row
  end
  study.parameters, study.results = lists.keys(names), lists.keys(results)
  study.complete = study.missing == 0
  return study
end

-- The codes of the warnings, each once, in order.
local function codes(warnings)
  local list = {}
  for _, w in ipairs(warnings) do
    if not list[w.code] then list[#list + 1], list[w.code] = w.code, true end
  end
  return table.concat(list, " ")
end

local function csv(study)
  local header, results, parameters = { "case" }, {}, {}
  for _, name in ipairs(study.parameters) do parameters[name] = true end
  for _, name in ipairs(study.results) do
    if not parameters[name] then results[#results + 1] = name end
  end
  for _, list in ipairs { study.parameters, results, { "warnings", "trouble" } } do
    for _, name in ipairs(list) do header[#header + 1] = case_file.cell(name) end
  end
  local lines = { table.concat(header, ",") }
  for i, row in ipairs(study) do
    local cells = { tostring(i) }
    for _, name in ipairs(study.parameters) do cells[#cells + 1] = case_file.cell(row.parameters[name]) end
    for _, name in ipairs(results) do cells[#cells + 1] = case_file.cell(row.values and row.values[name]) end
    cells[#cells + 1] = case_file.cell(codes(row.warnings))
    cells[#cells + 1] = case_file.cell(row.trouble)
    lines[#lines + 1] = table.concat(cells, ",")
  end
  return table.concat(lines, "\n") .. "\n"
end

local function run(t)
  local cases = cases_of(t)
  t.taken = taken_names(cases)
  t.only = asked(#cases)
  if fabric.checking() or t.only == "list" then
    if t.only == "list" then
      for i, case in ipairs(cases) do print(("%d\t%s"):format(i, case_file.words(case))) end
    else
      t.run(cases[1])
    end
    return { folder = t.folder, missing = #cases, failed = 0, complete = false, parameters = {}, results = {} }
  end
  claim(t.folder, identity(t.run))
  local _ <close> = alone(t)
  local study = collect(t, cases, compute(t, cases))
  if study.complete then fabric.write(study.file, csv(study)) end
  return study
end

define {
  name = "fabric.study",
  arguments = {
    { name = "parameters", kind = "table", optional = true, sentence = "{ name={values}, ... }: every combination; or { {name=value, ...}, ... }: these cases" },
    { name = "sample", kind = "table", optional = true, sentence = "instead: the cases of fabric.sobol or fabric.latin_hypercube" },
    { name = "run", kind = "function", sentence = "run(p), p.name being the values of a case, returns a table of named numbers, strings, true or false" },
    { name = "folder", kind = "text", default = "out/study", sentence = "where each finished case is kept, and study.csv when all are" },
    { name = "workers", kind = "integer", low = 1, high = 4096, optional = true,
      sentence = "cases side by side, each in a process with one thread; default: the threads that the program may use" },
    { name = "again", kind = "boolean", default = false, sentence = "runs cases again that failed before" },
  },
  sentence = "Runs a function for many sets of parameters in parallel processes. Finished cases are kept and not run again when the deck is run again; a case that fails leaves its message and does not stop the others. As a task of a Slurm array job it runs its share; fabricsh --cases deck.lua lists the cases, --case K runs one of them. Returns the cases in order, each "
    .. "{parameters, values, warnings, trouble} (warnings as analysis.warnings has them, of all runs of the case), with complete, missing, failed, file (the table as CSV), parameters and results (names).",
  example = "local folder = os.tmpname()\nos.remove(folder)\n"
    .. "local s = require 'fabric'.study{ parameters={ a={1, 2}, b={10, 20} }, folder=folder, run=function(p) return { sum=p.a + p.b } end }\n"
    .. "assert(s.complete and #s == 4 and s[2].values.sum == 21)\n"
    .. "for _, name in ipairs(require 'fabric'.folder(folder)) do os.remove(folder..'/'..name) end\nos.remove(folder)",
  run = run,
}
