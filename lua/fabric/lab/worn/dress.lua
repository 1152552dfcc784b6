-- fabric.lab.dress: pieces that were placed around a body are sewn and come to rest on it, before the body moves.
--
-- The deck makes the pieces (fabric.mesh.panel, mesh:wrap), the seams (over=), contact with the body and gravity. A piece that starts through a
-- body, or inside one that is closed, is refused as the run is made. Then this call runs to the time `at`, which the motion of the body begins
-- after, and judges whether the piece rests there: over the last `window`
--   no node has moved by more than `still`, and
--   the kinetic energy is below `calm` of the energy that the cloth stores.
-- The time is given and not found, so that the body's motion, which is declared before, follows it, and the same deck makes the same bits. A run
-- with until_rest= ends earlier where it rests by that rule; then nothing is judged again.
local define = require "fabric.define"
local fabric = require "fabric"
local lists = require "fabric.lists"

local function fail(words) define.fail("dress: " .. words) end

local function places(a) return { a:field "x", a:field "y", a:field "z" } end

local function farthest(was, is)
  local most, node = 0, 1
  for i = 1, #was[1] do
    local moved = (is[1][i] - was[1][i]) ^ 2 + (is[2][i] - was[2][i]) ^ 2 + (is[3][i] - was[3][i]) ^ 2
    if moved > most then most, node = moved, i end
  end
  return math.sqrt(most), node
end

-- The reasons, as sentences, why the run is not at rest; none: it is at rest.
local function unrest(t, result)
  local why = {}
  if result.moved > t.still then
    why[#why + 1] = ("node %d has moved by %.3g mm in the last %g s (still is up to %.3g mm)"):format(result.node, 1e3 * result.moved, t.window, 1e3 * t.still)
  end
  if result.kinetic > t.calm then
    why[#why + 1] = ("the kinetic energy is %.3g of that stored (calm is up to %g)"):format(result.kinetic, t.calm)
  end
  return why
end

local function found(a)
  local joints, e = a.joints, a.energy
  local result = { time = a.time, stitches = joints.stitches, open = joints.stitches - joints.closed, stopped = a.stopped }
  result.kinetic = e.kinetic / math.max(e.stored, 1e-300)
  result.gap, result.pair = a:gap()
  return result
end

-- Ends the run at the time, or before where it rests by its own rule.
local function rests_before(a, time)
  if a.time < time * (1 - 1e-12) then a:advance(time) end
  return a.stopped == "at rest"
end

-- The state at the time, and the reasons why it is not at rest there. A run that is behind the beginning of the window already, and has
-- no places from there in `state`, is not judged: at_rest is nil.
local function judged(t, a, state)
  local begins, late = t.at - t.window, nil
  if not state.before and a.time > begins * (1 + 1e-9) then late = a.time end
  if not late then
    if rests_before(a, begins) then
      local result = found(a)
      result.at_rest = true
      return result, {}
    end
    state.before = state.before or places(a)
  end
  local rests = rests_before(a, t.at)
  local result = found(a)
  if not rests then result.time = t.at end
  if late then
    return result, { ("the run was at %g s already, behind the beginning of the window, %g s: whether it rested is not known; a state= that a:checkpoint keeps would tell"):format(
      late, begins) }
  end
  result.moved, result.node = farthest(state.before, places(a))
  local why = rests and {} or unrest(t, result)
  result.at_rest = #why == 0
  if not result.at_rest then why = { ("not at rest after %g s: %s; a later at=, or more damping would do"):format(t.at, table.concat(why, "; ")) } end
  return result, why
end

local function run(t)
  local a = t.analysis
  if t.at > a.duration * (1 + 1e-12) then fail(("field 'at': expected at most the duration of the run, %g s, got %g s"):format(a.duration, t.at)) end
  if t.window >= t.at then fail(("field 'window': expected less than at= (%g s), got %g s"):format(t.at, t.window)) end
  local touches = false
  for _, row in ipairs(a.model:list()) do touches = touches or row.kind == "contact" end
  if not touches then fail "the model has no contact: expected m:contact{ between={body, \"all\"} }" end
  local state = t.state or {}
  if state.dressed and (state.asked or state.dressed.time) == t.at then return lists.copy(state.dressed) end -- a run that was taken up behind that time
  local result, why = judged(t, a, state)
  if #why > 0 and not fabric.checking() then fabric.warn("dress: " .. table.concat(why, "; ")) end
  state.dressed, state.asked, state.before = lists.copy(result), t.at, nil -- what a checkpoint keeps is plain, and what is returned gets methods
  return result
end

define {
  name = "fabric.lab.dress",
  arguments = {
    { name = "analysis", of = "analysis", sentence = "a run in motion, of pieces around a body with seams, contact and gravity, that has not got to `at` yet" },
    { name = "at", kind = "number", unit = "s", above = 0, sentence = "the time to run to, when the seams have closed (their over= has passed) and the cloth shall rest; the body moves after it" },
    { name = "window", kind = "number", unit = "s", above = 0, default = 0.02, sentence = "before that time, over which rest is judged" },
    { name = "still", kind = "number", unit = "m", above = 0, default = 1e-3, sentence = "rest: no node has moved by more than that in the window" },
    { name = "calm", kind = "number", above = 0, default = 1e-2, sentence = "rest: the kinetic energy is below this part of the energy stored" },
    { name = "state", kind = "table", optional = true, sentence = "an empty table to keep what was found in, for `keep` of a:checkpoint, so that a restart knows it" },
  },
  sentence = "Sews pieces around a body and lets them come to rest: runs to the time `at` and judges rest there. A piece that starts through a body is refused when the run is made. "
    .. "Returns at_rest (without it a warning says why; nil: the run came from a checkpoint behind the window, and it is not known), moved (m, by `node`, in the window), kinetic (over the energy stored), stitches and how many are open (those of a seam with a stiffness of its own stay so), gap (m, the smallest above the floor of contact, of `pair`), and time. A run with until_rest= ends where it rests by that rule, before `at`: then time is earlier, and moved may be nil.",
  example = "local mesh = fabric.mesh.rectangle{ width=0.06, height=0.03, nx=6, ny=3, origin={-0.03, -0.015, 0.0002} }\n"
    .. "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend', warp=0 }\n"
    .. "local table_ = fabric.rigid.plane{ point={0, 0, 0}, normal={0, 0, 1} }\n"
    .. "m:contact{ between={table_, 'all'}, friction=0.3 }:gravity{0, 0, -9.81}\n"
    .. "local a = fabric.dynamic{ model=m, duration=0.02, damping={ mass=200 } }\n"
    .. "local dressed = fabric.lab.dress{ analysis=a, at=0.02, window=5e-3, calm=1 }\n"
    .. "assert(dressed.at_rest and dressed.gap > 0)",
  run = run,
}
