-- The sleeve of scripts/garment is ended (SIGTERM) while its arm bends and goes on from its checkpoint on another number of threads: what it writes
-- is the same to the byte.
local check = dofile((arg[0]:gsub("[^/]*$", "common/check.lua")))
local shell, contents = check.shell, check.contents
local deck = arg[0]:gsub("[^/]*$", "") .. "../../scripts/garment/sleeve.lua"

local function program(threads, folder, more)
  return ("'%s' --quiet --threads %d %s '%s' blend 20 20 0.01 %s >%s.log 2>&1"):format(arg[-1], threads, more or "", deck, folder, folder)
end

os.execute "rm -rf whole ended; mkdir whole ended"
local function says(log) return select(2, shell("cat " .. log)) end
local code = shell(program(1, "whole"))
assert(code == 0, "the whole run: " .. says "whole.log")
local wanted, count = contents "whole"
assert(count > 15 and wanted["worn.txt"] and wanted["pressure.csv"], count)

-- Ended when it has written some frames of the motion, of which there are about a hundred.
local ended = shell(program(2, "ended") .. [[ &
pid=$!
while kill -0 $pid 2>/dev/null && [ $(ls ended | wc -l) -lt 12 ]; do sleep 0.02; done
kill -TERM $pid
wait $pid]])
assert(ended ~= 0, "it was to be ended in the middle: " .. says "ended.log")
local _, before = contents "ended"
assert(before < count, before)
code = shell(program(1, "ended", "--restart ended/run.ckpt"))
assert(code == 0, "the restarted run: " .. says "ended.log")
local got = contents "ended"
for name, bytes in pairs(wanted) do assert(got[name] == bytes, name .. " differs") end
print(("ended after %d of %d files; all are the same to the byte"):format(before, count))
