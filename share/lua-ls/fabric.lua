---@meta fabric
-- Stubs for the Lua language server, made by fabricsh scripts/reference.lua write.

---The material of a cloth. It cannot be changed; every field of its constructor reads back in SI: `card.warp.poisson`.
---@class card
---@field name string of the fabric (default "")
---@field source string where the numbers come from (default "")
---@field density number kg/m^3: mass over volume
---@field thickness number m: of the sheet
---@field bending fabric_woven_fields.bending own bending rigidity instead of integration through the thickness
---@field provenance table where values come from: {['warp.loading']='fitted to 4 specimens', ['shear.unloading']='assumed: ...'}; words begin with fitted, measured, copied, typed or assumed
---@field ranges table where assumed numbers may lie, for fabric.budget: {['warp.poisson']={0.1, 0.6}, ['warp.loading']={0.5, 2}}; Poisson's ratios as they are, others as factors
---@field through_thickness boolean bending by integration through the thickness is intended where the card has no bending of its own: no warning, even if that is far stiffer than cloth (default false)
---@field estimate fabric_woven_fields.estimate estimates of what was not measured, used by fabric.card(name, { bending='estimated' })
---@field compression table one sheet pressed between two plates, {{gap, pressure}, ...}: gap, m, is its thickness then, which is also how far apart the middles of two such sheets are, pressure in Pa; what contact presses with
---@field fibre_density number kg/m^3: of what the yarns are made of; areal mass over it is how thin the sheet can be pressed at most; default 1500 (cotton 1540, polyester 1380)
---@field folds "resolved"|"within elements"|"free" where compressed cloth folds: resolved, in the shape of the mesh alone; within elements too, which then carry no more than folds of their size would; or free, the same without any force (default "resolved")
---@field rupture fabric_woven_fields.rupture where yarns break: in tearable zones of a model, see model:tearable
---@field warp fabric_woven_fields.warp along the warp
---@field weft fabric_woven_fields.weft along the weft
---@field shear fabric_woven_fields.shear in-plane shear
---@field tested fabric_woven_fields.tested strains up to which it was measured
---@field law "potential"|"incremental"|"thesis" the law that is compiled from the card (default "potential")
---@field transverse "elastic"|"follow" transverse shear of the comparison laws (default "elastic")
---@field shear_hysteresis boolean of the comparison laws (default true)
---@field biaxial fabric_woven_fields.biaxial a fourth spring that acts when both yarns are stretched
---@field damage fabric_woven_fields.damage yarns that soften and break wherever they reach their strength, law potential only; where a tear runs along a line that is known, rupture and tearable zones are sharper
---@field viscous fabric_woven_fields.viscous stress that relaxes with time, law potential only
---@field bands fabric_woven_fields.bands confidence bands of the measured parameters
local card = {}

---Nodes, elements and named sets of nodes.
---@class mesh
---@field elements integer[][] Node numbers of each element, counter-clockwise.
---@field nodes number[][] Reference positions {x, y, z}, m, by node number. Each is a copy: mesh:map() moves nodes.
---@field sets string[] Names of the node sets. In the mesh of a model of several bodies also those of each, as body.left.
local mesh = {}

---A mesh of a cloth with its supports and loads. Its methods return it.
---@class model
---@field card card The card it was made of; of several bodies the first one's.
---@field mesh any The mesh it was made of.
---@field thickness number Thickness of the sheet, m; of several bodies the first one's.
local model = {}

---A number that depends on time.
---@class history
local history = {}

---A run, static or in motion.
---@class analysis
---@field beyond any The largest strain beyond what the card was tested to, or nil: share (1.2 is 20 % beyond), yarn (warp, weft or shear), element and time of this largest strain, strain (E11, E22 or E12), tested (the strain tested), first (time at which the run first went beyond) and elements (fraction of the elements beyond).
---@field duration number Where it ends, s.
---@field energy table<string, number> Energies in J: kinetic, stored, dissipated, damping, external, internal, initial, created. Parts of stored: contact, guard (the barrier that keeps surfaces from passing), stick (elastic slip of friction that holds), directors (what keeps the directors by the normal where the elements' shear does not). Parts of dissipated: dissipated_warp, _weft, _shear, _damage (yarns that softened, see damage of a card), _bending, friction (of contact), impact (of surfaces that meet), joints (motion lost as joints closed, see analysis:join, and what directors had stored where they opened), fracture (broken yarns of tearable zones). Parts of kinetic: rigid (free rigid bodies), scaled (rotary inertia that is scaled up). error: the imbalance over the largest external work; with contact at least over the cloth's weight times its thickness.
---@field joints any Of the tearable zones: open, the number of places whose joint is open; places, of all places with several nodes. Of seams: stitches, and how many of them are closed.
---@field mesh any The mesh of its model, as it was before the run.
---@field model any The model that it computes.
---@field stable_step number A step that no frequency of the reference configuration forbids central differences, s.
---@field step_size number Usual step of a dynamic run, s; steps that end at a prescribed time are shorter.
---@field steps table[] Of each committed step: time, step, iterations, cuts, residuals, negative_pivots (none on a stable path), stable: true, false, or "unchecked" in motion and where loads have no potential.
---@field stopped string|false The reason it was stopped for, or false.
---@field time number Where the run is, s.
---@field warnings any Warnings of the run about how far its results can be trusted, in order: a list of {code, text, time (s), element (nil: no particular one), serious}. Also in run.json. Under --strict the serious ones raise a numerical failure. The codes: ledger (energy appears or is lost beyond what the steps explain), inverted (an element is turned inside out), director (a director has turned over to the other side of the sheet), beyond (the strain is beyond what the card was tested to; serious with limit="stop"), path (steps of a static run are long for laws that remember their path), unstable (a step has ended in a shape that is not stable), compressed (elements carry compression under which the cloth within them would fold), pivots (a static run has passed a limit or bifurcation point, or left an unstable shape), branches (a static run has left an unstable shape more than once, and its steps decide for which), relaxed (relaxation took a noticeable part of a static run's work, or its first step), stabilise (stabilisation has taken a noticeable part of the work), jump (a load or motion is at full value at once, not ramped), step (the explicit step is near the stable one, or is split because stretch has shortened that; or an implicit one is shortened, since the cloth turns far in it), inertia (much of the kinetic energy is in rotary inertia that is scaled up for the step), guard (contact is pressed so far that a barrier keeps the surfaces apart), nip (held or driven bodies press cloth between them from the start; serious if it cannot fit between them), crossing (surfaces that may touch pass through each other at the end), pressed (contact of an assumed stiffness has a noticeable part of the stored energy), rim (the rim of a volume of gas has left the rigid body that closes it), nodes (the force of a ball or a rod on flat cloth depends on where the nodes lie), facets (facets of a rigid surface lie so near to each other that places of it press more than once), fold (cloth turns sharply between two elements where contact presses on it), seam (edges that are sewn had not met when their time was over, or are drawn against a body faster than contact stops them), damped (the time scheme has taken much of the energy that went through a run in motion), rest (a run that was to end at rest has not come to rest in its time), held (the cloth pulls on yarns beyond their strength where a support holds them, and none breaks there), dropped (an initial velocity is dropped along supports), oblique (yarns cross elements so obliquely, and are so stiff, that these lock), shear (transverse shear that is derived from other numbers of the card shows in bending), lean (the guard of the directors has a noticeable part of the stored energy), splay (elements are so long across stiff fibres that they lose stability where cloth does not), idle (supports take up the whole of a load, or nothing loads or moves the cloth at all), bending (the bending rigidity of the card is far from that of cloth), card (the check of the card has a warning), units (a value of the deck is far outside the usual), mesh (the file of a mesh was cut short or holds what is left out, or a sheet is in parts that are not connected), restart (the run was continued from the checkpoint of another deck), lost (an output of the restarted run is gone), retired (an argument of an earlier release has no effect any more), deck (the deck or a virtual test has said it with fabric.warn).
local analysis = {}

---The whole state of a run.
---@class snapshot
local snapshot = {}

---How the nodes of a model move in a mode.
---@class shape
---@field x any Displacements along x, m, one for each node; the longest is 1 m.
---@field y any Displacements along y, m, one for each node; the longest is 1 m.
---@field z any Displacements along z, m, one for each node; the longest is 1 m.
local shape = {}

---One material point.
---@class point
local point = {}

---A rigid body, made by `fabric.rigid`.
---@class body
local body = {}

---The result of a virtual test; some have more.
---@class test
---@field curve table[] its rows
---@field analysis analysis
---@field model model
---@field mesh mesh
---@field peak table the row of the largest displacement
---@field mesh_error fun(self: test, options?: table): table what the numbers owe to the mesh

---@class fabric
---@field version string
---@field units table<string, number> multipliers to SI
local fabric = { mesh = {}, rigid = {}, lab = {}, export = {}, import = {} }

---Runs to an absolute time and lands on it; returns the analysis.
---@param time number s: absolute time to run to and land on
---@return analysis
function analysis:advance(time) end

---Where a rigid body is and how it moves: nine numbers, x y z of its centre (m), its velocity (m/s), its spin (degrees/s); a moved body's by differences of its histories.
---@param body body that touches something in the model
---@return number ...
function analysis:body(body) end

---@class analysis_checkpoint_fields.options
---@field every? number|"step" s: simulated time between two of them, or 'step'; no step is made shorter for it
---@field minutes? number min: time on the clock between two of them; 10 where neither it nor 'every' is given
---@field keep? table a table of the deck (numbers, texts, booleans, tables), saved with the run and filled again on restart

---Writes the whole state of the run to one file as it goes, and when it ends, fails or is interrupted; --restart and analysis:restart continue from there bit for bit.
---@param path string of the file, which is replaced each time; its folder is made
---@param options? analysis_checkpoint_fields.options how often, and what besides the run
---@return analysis
function analysis:checkpoint(path, options) end

---@class analysis_cut_fields
---@field set? string the edges between nodes of this set
---@field line? table a list of points {x, y, z}: the edges that lie on the line through them, m in the reference

---Opens joints of tearable zones and stitches of seams, between two steps: in a hook, an event's action, or between calls. Along the edges named the elements come apart; the tip of a cut stays whole. Returns how many joints there are more.
---@param fields analysis_cut_fields
---@return any
function analysis:cut(fields) end

---Averages over the element's reference volume, material axes: a table of rupture_warp (warp force over strength at the joints of the element, the largest; 1 where it has broken), rupture_weft (weft force over strength at the joints of the element, the largest; 1 where it has broken), E11 E22 E23 E13 E12 (Green-Lagrange strain, tensor components), S11 S22 S23 S13 S12 (2nd Piola-Kirchhoff stress; Pa), residual1 residual2 (strain that a yarn keeps when it is unloaded), slack1 slack2 (strain by which a slack yarn is below its residual strain), folded (part of the compression that folds within the element have taken, 0 to 1; 0 in a model whose folds are resolved), stored dissipated (per reference volume: stored, and dissipated so far; J/m^3), dissipated_warp (per reference volume: dissipated so far in warp; J/m^3), dissipated_weft (per reference volume: dissipated so far in weft; J/m^3), dissipated_shear (per reference volume: dissipated so far in shear; J/m^3), dissipated_damage (per reference volume: dissipated so far in damage; J/m^3), shear_angle (90 degrees less the angle between warp and weft; has the sign of E12; degrees), tension_warp (force along the warp yarns per reference width; N/m), tension_weft (force along the weft yarns per reference width; N/m), nominal_strain_warp (change of length along the warp over the reference length), nominal_strain_weft (change of length along the weft over the reference length), nominal_stress_warp (force along the warp yarns over the reference area; Pa), nominal_stress_weft (force along the weft yarns over the reference area; Pa), cauchy_11 (Cauchy stress along the deformed warp (current width, reference thickness); Pa), cauchy_22 (Cauchy stress across the deformed warp, in the surface; Pa), cauchy_12 (Cauchy shear stress, along and across the deformed warp; Pa), beyond (largest strain so far over the tested strain of the card: 1.2 is 20 % beyond; 0 where the card states none), region (number of the body or region that the element belongs to, in their order).
---@param number integer of the element
---@return table<string, any>
function analysis:element(number) end

---@class analysis_event_fields
---@field value function function(a) whose zero is sought
---@field tolerance? number of the value, over the largest it has had (default 1e-06)
---@field action? function function(a), called there

---Finds where a value crosses zero inside a step, lands there, commits, and calls the action.
---@param fields analysis_event_fields
---@return analysis
function analysis:event(fields) end

---Calls a function at the start and then at an interval, or after each step.
---@param interval number|"step" s: time between calls, which steps land on, or 'step'
---@param action function function(a)
---@return analysis
function analysis:every(interval, action) end

---@class analysis_field_fields.options
---@field at? "nodes" fields of elements at all nodes: fitted to the elements around each node, by superconvergent patch recovery, apart in each region
---@field region? integer with at: the values of this region alone, its number as in the field region; nan at nodes outside. Default: on the border of regions their mean, by the areas of their elements there

---Values of all elements or nodes, in their order: a list of numbers; for a whole field a list of lists. Units are SI: stresses in Pa, energies in J/m^3.
---@param name "rupture_warp"|"rupture_weft"|"E11"|"E22"|"E23"|"E13"|"E12"|"S11"|"S22"|"S23"|"S13"|"S12"|"residual1"|"residual2"|"slack1"|"slack2"|"folded"|"stored"|"dissipated"|"dissipated_warp"|"dissipated_weft"|"dissipated_shear"|"dissipated_damage"|"shear_angle"|"tension_warp"|"tension_weft"|"nominal_strain_warp"|"nominal_strain_weft"|"nominal_stress_warp"|"nominal_stress_weft"|"cauchy_11"|"cauchy_22"|"cauchy_12"|"beyond"|"region"|"ux"|"uy"|"uz"|"vx"|"vy"|"vz"|"nx"|"ny"|"nz"|"x"|"y"|"z"|"X"|"Y"|"Z"|"reaction_x"|"reaction_y"|"reaction_z"|"gap"|"contact_pressure"|"crease_angle"|"joint_open"|"displacement"|"velocity"|"director"|"position"|"reference"|"reaction"|"E"|"S"|"residual"|"slack"|"energy"|"warp"|"weft"|"error" of a number, or of a field: see the table of fields of a run; of a ply ply2.E11, or by the ply's name
---@param options? analysis_field_fields.options where
---@return number[]
function analysis:field(name, options) end

---Smallest distance of surfaces that may touch, less the smallest distance that contact allows, m, and which surfaces these are; where none are near: the reach of contact, and nil.
---@return number, string?
function analysis:gap() end

---The gas of a volume as it is: four numbers, the pressure above that outside (Pa), the volume (m3), the mass (kg), and the temperature (K).
---@param gas gas a volume of the model, what m:gas returned
---@return any
function analysis:gas(gas) end

---@class analysis_join_fields
---@field set? string the edges between nodes of this set
---@field line? table a list of points {x, y, z}: the edges that lie on the line through them, m in the reference
---@field within? number m: how far apart nodes that become one may be; default a millionth of the mean edge

---Closes joints of tearable zones and stitches of seams, between two steps, where their nodes have met again. They take the mean of their velocities weighted by their masses; the kinetic energy lost is a.energy.joints. Returns how many joints there are less.
---@param fields analysis_join_fields
---@return any
function analysis:join(fields) end

---The mean of a value over elements, or over nodes, each with the same weight. Stresses in Pa, energies in J/m^3.
---@param name "rupture_warp"|"rupture_weft"|"E11"|"E22"|"E23"|"E13"|"E12"|"S11"|"S22"|"S23"|"S13"|"S12"|"residual1"|"residual2"|"slack1"|"slack2"|"folded"|"stored"|"dissipated"|"dissipated_warp"|"dissipated_weft"|"dissipated_shear"|"dissipated_damage"|"shear_angle"|"tension_warp"|"tension_weft"|"nominal_strain_warp"|"nominal_strain_weft"|"nominal_stress_warp"|"nominal_stress_weft"|"cauchy_11"|"cauchy_22"|"cauchy_12"|"beyond"|"region"|"ux"|"uy"|"uz"|"vx"|"vy"|"vz"|"nx"|"ny"|"nz"|"x"|"y"|"z"|"X"|"Y"|"Z"|"reaction_x"|"reaction_y"|"reaction_z"|"gap"|"contact_pressure"|"crease_angle"|"joint_open" of a number that elements or nodes have, see a:element and a:node; of a ply ply2.E11, or by the ply's name
---@param set? string elements all of whose nodes are in it; or its nodes (default "all")
---@return number
function analysis:mean(name, set) end

---Where a node is and how it moves, global: a table of ux uy uz (from the reference position; m), vx vy vz (of a run in motion; zero in statics; m/s), nx ny nz (unit vector across the sheet), x y z (where the node is now; m), X Y Z (where the node was in the reference; m), reaction_x reaction_y reaction_z (force of the supports on the node, which a:reaction sums over a set; N), gap (distance to the nearest surface that it may touch, less the smallest distance that contact allows; at most the reach of contact; m), contact_pressure (normal pressure of contact, without friction; that on the front and that on the back of a sheet added; Pa), crease_angle (angle at creases with a stiffness, the largest at the node; 0 elsewhere; degrees), joint_open (1 where a joint of a tearable zone is open, or a seam has been opened or has burst; 0 elsewhere).
---@param number integer of the node
---@return table<string, any>
function analysis:node(number) end

---The load of the cloth on a rigid surface: of each vertex x, y, z (m, where it is), area (m2, a third of the facets around it, as they are) and pressure (Pa, without friction); and touch, whose lists node, x, y, z are the nodes of the cloth that touch the surface, and where on it, m, in its shape at time 0.
---@param body body of facets (surface, motion, limb, torso), that touches cloth in the model
---@return any
function analysis:on_body(body) end

---Runs until a value reaches a target and ends a step exactly there; an error if the run ends before. Returns the analysis; solve() continues it.
---@param value string|function function(a) that returns a number, or a field's name for its mean
---@param target number value to reach
---@param set? string of the field's mean (default "all")
---@param tolerance? number of the value, over the largest distance from the target (default 1e-06)
---@return any
function analysis:reach(value, target, set, tolerance) end

---@class analysis_reaction_fields.options
---@field window? number s: the mean over the last seconds, straight between the ends of the run's steps, for a body in implicit motion as the scheme takes its force; to be asked for once before the first step
---@field support? boolean of a body: the force on it of m:fix, in the directions that are held (default false)

---Force that the supports, or a rigid body, exert on the cloth, summed over the set: three numbers x, y, z in N, global; zero before the first step.
---@param set string|body name of a node set, or a rigid body
---@param options? analysis_reaction_fields.options window = seconds for a mean, or support = true
---@return number x, number y, number z
function analysis:reaction(set, options) end

---@class analysis_record_fields.options
---@field every? number|"step" s: time between rows or frames, or 'step'
---@field columns table name = function(a) that returns a number; or a field's name, for its mean over all elements or nodes, or {field, set}; {function or field, set, window=seconds} is the mean over the last seconds of the run's own steps, in which a:reaction(body) counts as in its own window (the function is then called twice a step)
---@field window? number s: the same for all columns that have none of their own
---@field order? table names in the order of the columns
---@field units? table name = unit of what the function returns, '' for none; put behind the name in the heading. Default: that of the field; N for a column called force (or force_x, force_y, force_z), m for displacement

---Writes a table as the run goes: time, then the columns, with their units in the heading, so that fabric.lab.tensile reads it.
---@param path string of the CSV file
---@param options analysis_record_fields.options columns, and how often
---@return analysis
function analysis:record(path, options) end

---Returns to the state of a checkpoint; 'record', 'vtk' and 'checkpoint' called after it continue their files.
---@param path string of a checkpoint of the same problem
---@return analysis
function analysis:restart(path) end

---Goes back to a snapshot; the run goes on from there bit for bit. Returns the analysis.
---@param snapshot snapshot taken of this analysis
---@return analysis
function analysis:restore(snapshot) end

---@class analysis_set_fields
---@field step? number s: largest step
---@field tolerance? number residual over the largest nodal force
---@field max_iterations? integer of one step, before it is cut
---@field max_cuts? integer halvings of one step, before the run gives up

---Changes settings of a run, also one that is under way or has failed.
---@param fields analysis_set_fields
---@return analysis
function analysis:set(fields) end

---A copy of the whole state, to go back to with a:restore.
---@return snapshot
function analysis:snapshot() end

---Runs to the duration, or to where a hook stopped it; returns the analysis.
---@return analysis
function analysis:solve() end

---Makes one step and commits it; returns the analysis.
---@return analysis
function analysis:step() end

---Ends the run after the current step; to be called from a hook.
---@param reason? string why, for a.stopped and run.json (default "asked for")
function analysis:stop(reason) end

---@class analysis_vtk_fields.options
---@field every? number|"step" s: time between rows or frames, or 'step'
---@field fields? table names of fields, or of single numbers: see the table of fields of a run; default: displacement velocity director reference reaction E S residual slack energy warp weft. Displacement and reference are always there
---@field points? "deformed"|"reference" where the nodes are now, or where they were: with reference, ParaView's Warp By Vector by displacement shows the sheet as it is (default "deformed")
---@field averaged? boolean fields of elements also on the nodes, under the same names, as a:field finds them with at='nodes' (default false)

---Writes a series for ParaView as the run goes; the .pvd is valid at any moment. Node sets are arrays of 0 and 1 on the points, E and S symmetric tensors in material axes (11 22 33 12 23 13; those of 33 are 0), units stand with the arrays.
---@param stem string out/drape writes out/drape.pvd and numbered .vtu files
---@param options? analysis_vtk_fields.options how often, and what
---@return analysis
function analysis:vtk(stem, options) end

---Why the run last failed: the steps tried with their residuals, the node, the element with its strain and the branches of its yarns, and what to try; as text. The error has it as e.why.
---@return string
function analysis:why() end

---@class analysis_write_fields.options
---@field fields? table names of fields, or of single numbers: see the table of fields of a run; default: displacement velocity director reference reaction E S residual slack energy warp weft. Displacement and reference are always there
---@field points? "deformed"|"reference" where the nodes are now, or where they were: with reference, ParaView's Warp By Vector by displacement shows the sheet as it is (default "deformed")
---@field averaged? boolean fields of elements also on the nodes, under the same names, as a:field finds them with at='nodes' (default false)

---Writes the sheet as it is now, or as it was in the reference, for another program: with fields as a frame of a:vtk into a .vtu, else as mesh:write does.
---@param file string ends in .msh, .vtu, .obj, .stl, .ply, .inp, .k or .rad
---@param options? analysis_write_fields.options what; fields go into a .vtu alone
---@return any
function analysis:write(file, options) end

---@class card_check_fields.element_size
---@field element_size? number m: smallest in the plane, for the explicit step (default 0.1)

---Errors of the card and remarks on it: a table {ok, card, text, items, criterion}, which prints as its text. An item has key, severity (note, warning, error), text, numbers; a row of criterion has path, warp, weft (branches), first (strain of violation or nil), last.
---@param element_size? number|card_check_fields.element_size m: smallest in the plane, for the explicit step; default 0.1
---@return table[]
function card:check(element_size) end

---Cards drawn from the card's confidence bands, for the uncertainty of any answer, a list; a value at the end of its band is drawn on the band's side. Points of a yarn that fall are made to rise, and an unloading flatter than the loading is raised to it; other values that make no card are drawn again; `refused` says how often, and from one in fifty on there is a warning.
---@param n integer of cards
---@param seed? integer of the draw (default 1)
---@return card[]
function card:sample(n, seed) end

---A copy of the card with some fields changed.
---@param changes table fields of the constructor that differ; tables merge deeply, and false drops what a card can do without, as friction_warp=false, whether it has it or not
---@return card
function card:with(changes) end

---Writes the card as a Lua file that reads back equal; the old file stays until the new one is whole.
---@param path string of the Lua file
function card:write(path) end

---@class fabric_buckling_fields
---@field from analysis a state under the loads, well below the critical ones or near them
---@field load? model the loads and motions that are multiplied, beyond those of the state, which stay as they are: model:copy() with more of them, as they are at the time of the state; without it all of the state's
---@field count? integer how many, from the lowest on (default 1)

---Factors of the loads of a state at which cloth buckles, ascending: a list of { factor=, shape= }.
---@param fields fabric_buckling_fields
---@return any
function fabric.buckling(fields) end

---@class fabric_budget_fields
---@field run function run(p) returns numbers by name; p.card, p.mesh, p.step, p.specimen (a seed) and p.assumed.NAME are those of this run; where it puts its run into p.analysis, mesh_errors is the error of the stresses on each mesh: with one mesh its part, with more the least where these do not converge
---@field card? card its measured bands and what it assumes are varied
---@field mesh? table for p.mesh, rising, e.g. {4, 8, 16} elements along a side
---@field steps? table for p.step, falling
---@field assumed? table { name={low, high} }: other ranges of what the card assumes, and more numbers, for p.assumed.name
---@field samples? integer draws of all inputs; the runs are this times the inputs and 2 (default 64)
---@field shares? boolean false: the band alone, at two runs a sample, without the share of each input (default true)
---@field seed? integer of the draws (default 1)
---@field processes? integer runs side by side; default: the threads that the program may use
---@field print? boolean the table (default true)
---@field figure? string a file for a picture of the shares

---The uncertainty of what a deck computes, after the GUM: the errors of the mesh (Richardson's extrapolation, whose limit is the value) and of the steps, the card's measured bands, what it assumes, and the specimen. Returns by the name of each number value, band {low, high} (95 %) and contributions { {source, deviation, share, first, total, first_band, total_band, range, why}, ... }, the largest first; text, runs, failed, warnings, sample_warnings (what the samples warned of, once each: code, text, runs), not_varied, untold (lines on numbers of which the meshes or steps do not tell where they go), contradictions (lines on parts of the card whose records contradict the model), narrower (what tests would narrow an interval, { name, field, test, width }: the width left over the present one).
---@param fields fabric_budget_fields
---@return any
function fabric.budget(fields) end

---@class fabric_card_fields.options
---@field bending? "estimated"|"thickness" estimated: the card's own estimate of what was not measured, or that for its areal mass (a card with a rigidity of its own keeps it); thickness: integration through the thickness, without a warning

---A shipped card by name, or the card that a Lua file returns, or a card of the deck's own; with options.
---@param name string|card of a shipped card, or a path (with / or ending in .lua), or a card
---@param options? fabric_card_fields.options changes to the card
---@return card
function fabric.card(name, options) end

---Names of the shipped cards.
---@return string[]
function fabric.cards() end

---True under --check, where analyses run nothing and no file is written.
---@return boolean
function fabric.checking() end

---Rows as columns that can be calculated with, as the curves of virtual tests are: curve.S / MPa, curve.S:max(), :min(), :mean(), :sum(), :map(f), of which all but map skip gaps (nan); curve:max('S') gives the row too, curve:interpolate('S', 'E', 0.1) is S where E first passes 0.1 (nil and the reason where it never does), curve:map(f) a column of f(row), curve:window('S', 0.01) the means of S over the 0.01 s about each row, by the column time: for what chatters from step to step.
---@param rows table of a test, a record, or a fabric.table; or lists of equal length with names
---@return any
function fabric.columns(rows) end

---@class fabric_dynamic_fields.damping
---@field mass? number 1/s: a of the damping matrix a M + b K_M
---@field stiffness? number s: b of the damping matrix a M + b K_M

---@class fabric_dynamic_fields.until_rest
---@field calm? number kinetic energy over the energy stored (default 0.01)
---@field window? number s: how long it has to be that calm, at least (default 0.02)
---@field still? number m: how far a node may move meanwhile; default 1/1000 of the size of the cloth

---@class fabric_dynamic_fields
---@field model? model what is computed; with from= that of the other run unless given
---@field duration number s: time to run, from 0 or from the other run's time
---@field step? number|"auto" s: of time; auto: explicit 0.7 of the stable step or less, implicit duration/200
---@field scheme? "explicit"|"implicit" explicit (central differences) or implicit (Newmark with Newton) (default "explicit")
---@field gamma? number of Newmark; above 1/2 it damps; default 1/2
---@field beta? number of Newmark; default 0 explicit, (1/2 + gamma)^2/4 implicit
---@field hht? number alpha of Hilbert, Hughes and Taylor: damps high frequencies; beside contact as spectral_radius = (1 + hht) / (1 - hht); default 0, and -0.2 from the step on in which implicit steps have made energy
---@field spectral_radius? number implicit: share of an amplitude that is left after a step much longer than its period; what is lost is in energy.damping. By the generalised trapezoidal rule, which never makes energy of contact; without contact from 1/2 on by alpha, of second order; default 1, beside contact 0.9 unless another field chooses the scheme, or error= the steps
---@field slow? boolean implicit: motion that passes through near-equilibria, as spectral_radius=0 (Euler's backward rule): what is faster than the steps dies within them (default false)
---@field error? number implicit: steps are so short that none errs by more in the place of a node or body, over the size of the model; step= is then the largest, a twentieth of the duration unless given; default steps as step= says
---@field linear? "auto"|"symmetric"|"unsymmetric" implicit: direct solver: auto (symmetric where law and loads are), symmetric, unsymmetric (default "auto")
---@field damping? fabric_dynamic_fields.damping Rayleigh's damping {mass=a, stiffness=b}; none unless given
---@field until_rest? fabric_dynamic_fields.until_rest end where all rests: every seam that is drawn has closed, and for window= and for a third of the time since seams, loads or motions changed, the kinetic energy has been at most calm= of that stored and no node has moved by more than still=; a.stopped is then 'at rest', and solve() goes on to the duration, which it may take at most
---@field inertia? "scaled"|"true" inertia of the cloth: true; or scaled for the explicit step, with more against rotations and mass that thin elements take from those about them
---@field force? boolean take the step even above the stable one (default false)
---@field ledger_limit? number the run stops when the error of the energy ledger exceeds this part of the external work (default 0.05)
---@field tolerance? number implicit: residual over the largest nodal force (default 1e-08)
---@field max_iterations? integer implicit: of one step, before it is cut (default 30)
---@field max_cuts? integer implicit: halvings of one step (default 12)
---@field line_search? boolean implicit: iterations that overshoot are shortened (default true)
---@field limit? "tell"|"stop" tell: warns once when the cloth is strained beyond what the card was tested to (2 % are let pass); stop: ends the run there, on the strain, however long the steps (default "tell")
---@field from? analysis a run of the same cloth, whose state and time this one begins with
---@field release? number s: with from=: over which the forces of what no longer holds the cloth are taken away; default at once

---A dynamic run by Newmark's method, explicit or implicit, with a balance (ledger) of its energies.
---@param fields fabric_dynamic_fields
---@return analysis
function fabric.dynamic(fields) end

---Checks results of a deck: prints computed and expected values; an error (exit code 1) if one is outside its tolerance.
---@param rows table { {label, got, want, relative= or absolute=}, ... }
function fabric.expect(rows) end

---@class fabric_export_card_fields
---@field card card the fabric
---@field to "ls-dyna"|"openradioss"|"abaqus" the solver
---@field material? string ls-dyna: MAT_034 (default) or MAT_235; openradioss: LAW58 (default), LAW158 or LAW19; abaqus: FABRIC, or ELASTIC for svk cards
---@field file? string where the text goes; default: it is only returned
---@field units? "mm-t-s"|"mm-kg-ms"|"SI" that the deck is written in (default "mm-t-s")
---@field id? integer of the material; curves are 10 id + 1 and on (default 1)
---@field axis? number[] direction of the warp {x, y, z} where the material holds it (LS-DYNA); default {1, 0, 0}
---@field element? number m: size of the elements along the yarns that break: with it the card's rupture is written where the material takes one (LAW58, LAW158: /FAIL/FABRIC)

---A card as a material of another solver, its curves in that solver's measures of strain and stress. Returns text, material, report (text), losses: a row for each path {path, worst, rms, work: per cent of the card's own peak stress and work, where, peak, strain, ours, theirs}, lost: the same by path (warp, weft, biaxial, bias, "cyclic warp", "cyclic weft", "cyclic shear"), and sentences on what no row shows.
---@param fields fabric_export_card_fields
---@return any
function fabric.export.card(fields) end

---@class fabric_export_gltf_fields
---@field file string to write; ends in .glb
---@field series? string a .pvd that a:vtk wrote: every frame of it
---@field run? analysis in place of a series: the run as it stands
---@field field? "none"|"displacement"|"ux"|"uy"|"uz"|"velocity"|"vx"|"vy"|"vz"|"director"|"nx"|"ny"|"nz"|"position"|"x"|"y"|"z"|"reference"|"X"|"Y"|"Z"|"reaction"|"reaction_x"|"reaction_y"|"reaction_z"|"gap"|"contact_pressure"|"crease_angle"|"joint_open"|"rupture_warp"|"rupture_weft"|"E11"|"E22"|"E23"|"E13"|"E12"|"S11"|"S22"|"S23"|"S13"|"S12"|"residual1"|"residual2"|"slack1"|"slack2"|"folded"|"stored"|"dissipated"|"dissipated_warp"|"dissipated_weft"|"dissipated_shear"|"dissipated_damage"|"warp"|"weft"|"shear_angle"|"tension_warp"|"tension_weft"|"nominal_strain_warp"|"nominal_strain_weft"|"nominal_stress_warp"|"nominal_stress_weft"|"cauchy_11"|"cauchy_22"|"cauchy_12"|"beyond"|"region" what the colours show, on the nodes: a number of a field, or a vector's length (default "none")
---@field range? number[] {low, high} of the colours; default: those of all frames
---@field every? number s: at least between two frames; default: all that there are
---@field duration? number s: of the animation; default: that of the series
---@field shapes? "morph"|"frames" frames: a mesh for each frame, shown by turns, as every program can; morph: one mesh that moves straight from frame to frame, with colours that few programs move. Default: frames where there is a field, else morph
---@field up? "z"|"y" the axis that points up (default "z")

---Writes a series as a binary glTF file for the web: the cloth, and what stands beside it, with an animation. Returns {file, frames, duration, bytes, low, high}; low and high are those of the colours, which are as in pictures.
---@param fields fabric_export_gltf_fields
---@return any
function fabric.export.gltf(fields) end

---@class fabric_export_mesh_fields
---@field mesh mesh the mesh
---@field file string ends in .vtu, .msh, .obj, .ply, .stl, .inp, .k or .rad; lengths in m
---@field run? analysis of that mesh: nodes where they are now; default: the reference shape

---Writes a mesh as mesh:write does, or its deformed shape as analysis:write does. Returns the file's name.
---@param fields fabric_export_mesh_fields
---@return any
function fabric.export.mesh(fields) end

---@class fabric_export_model_fields
---@field model model one sheet of one card, with fix, move, force and gravity
---@field warp? number|number[] degrees: the model's warp: its angle from x, or its direction {x, y, z}; needed only where it differs from place to place in the model
---@field file? string that ends in .inp, .k or .rad (name it NAME_0000.rad for the starter); default: the text is only returned
---@field to? "ls-dyna"|"openradioss"|"abaqus" the solver; default: by the file's name
---@field material? string as for fabric.export.card
---@field units? "mm-t-s"|"mm-kg-ms"|"SI" that the deck is written in (default "mm-t-s")
---@field element? number m: as for fabric.export.card
---@field histories? table { ['top.y']={{t, v}, ...} }: points {t, v}, in s and SI, to be written for a motion or force of a set along an axis, in place of the model's own
---@field error? number of functions of time, which are written as points: largest difference over their range (default 1e-04)
---@field duration? number s: of the run; default: the last corner of a history, at least 1 s

---A model as a deck of another solver: nodes, elements, sets, supports, loads, section and material. Returns text, material, card (what fabric.export.card returns, with the losses), and notes on what the deck states differently (functions of time, with the difference). Histories are written with all their points and digits (LS-DYNA, OpenRadioss: those that 20 columns hold). Abaqus and CalculiX: shells S4 and *STATIC with NLGEOM for *ELASTIC, membranes and *DYNAMIC, EXPLICIT for *FABRIC.
---@param fields fabric_export_model_fields
---@return any
function fabric.export.model(fields) end

---Names in a folder, sorted.
---@param path string of a folder
---@return string[]
function fabric.folder(path) end

---Makes the fields of fabric and fabric.units global, except where a global of that name exists.
function fabric.globals() end

---Prints the arguments of a function, the contents and methods of an object, or all entries and pages that contain the given words.
---@param topic? any a function, an object, a name, or words to look for; nothing: an overview
function fabric.help(topic) end

---A history through points; before the first and after the last it holds their values.
---@param points table { {t, v}, ... } with increasing times, s
---@return history
function fabric.history(points) end

---@class fabric_import_card_fields.tested
---@field warp? number largest E11; 0: not known, as in a card
---@field weft? number largest E22; 0: not known, as in a card
---@field shear? number largest E12 (tensor); 0: not known

---@class fabric_import_card_fields.unloading
---@field warp? number Pa: of the warp
---@field weft? number Pa: of the weft
---@field shear? number Pa: of S12 over E12 (tensor)

---@class fabric_import_card_fields
---@field file string a starter deck with LAW58 or LAW19, an LS-DYNA deck with *MAT_034, or an Abaqus deck with *FABRIC test data
---@field from? "openradioss"|"ls-dyna"|"abaqus" default: by the file's ending, .rad, .k (.key) or .inp
---@field units? "mm-t-s"|"mm-kg-ms"|"SI" that the file is written in; default: those that it states in a comment 'Units: ... (mm-t-s)', in /BEGIN or in the /UNIT/n that the material names, else mm-t-s
---@field name? string of the card; default: the material's
---@field thickness? number m: default: that of a section in the file
---@field density? number kg/m^3: default: the file's
---@field poisson? number[] {nu12, nu21}, which such files do not hold; default {0, 0}, of crimped yarns of LAW58 those that fit its law best
---@field misfit? number %: largest difference from the deck's law on any path but cycles, per cent of the peak stress (default 25)
---@field tested? fabric_import_card_fields.tested strains up to which the curves count as measured; default: LAW58 where loading and unloading cross, else those that the file states in a comment 'Tested up to E11 = ...', else the curves' ends
---@field unloading? fabric_import_card_fields.unloading unloading moduli, Pa, instead of those of the file's curves

---A woven card out of another solver's material: its curves as measured points, its unloading as a modulus. Returns card, report (text), losses and lost (as fabric.export.card, the file's law beside the card's), notes. A material that no card follows within `misfit` is refused.
---@param fields fabric_import_card_fields
---@return any
function fabric.import.card(fields) end

---@class fabric_lab_backbone_fields
---@field curves table { {E=, S=}, ... }, one per specimen
---@field degrees? number[] of the stress polynomials to try; default {2, 4}
---@field find_slack? boolean the stretch at first contact is fitted too (default false)

---Stress polynomials through zero, one per specimen and degree: a list of {degree, criterion, initial, least, admissible, specimens={ {loading, slack, reach, residual}, ... }}; chosen is the place of the best, nil if none has a positive tangent.
---@param fields fabric_lab_backbone_fields
---@return table[]
function fabric.lab.backbone(fields) end

---@class fabric_lab_ball_burst_fields
---@field card card the fabric, with rupture of warp and weft
---@field ball? number m: diameter (default 0.0254)
---@field ring? number m: inner diameter (default 0.04445)
---@field h? number m: size of the elements (default 0.002)
---@field stiffness? number Pa/m: of contact, as for model:contact
---@field friction? number of ball and cloth (default 0.2)
---@field ledger_limit? number as for fabric.dynamic (default 0.05)
---@field speed? number m/s: of the grips apart; default: kinetic energy stays a small share of the work
---@field damping? number 1/s: of the masses
---@field coarse? "lower"|"refuse"|"keep" as for model:tearable
---@field seed? integer of the scatter of strengths (default 1)
---@field rows? integer of the curve, at equal times
---@field out? string folder for curve.csv and the VTK series
---@field prepare? function function(analysis), called before the run: for hooks, records and checkpoints of your own
---@field state? table an empty table to gather the curve in, for `keep` of a:checkpoint in prepare, so that a restart has the rows from before it; without it peaks and means are nil then

---A ball is pushed through cloth that is held in a ring, as in ASTM D3787 [astm_d3787], with contact and friction. Returns peak (N, the bursting strength), elongation (m, the ball's way there), curve (a list of time, displacement, force: N, work over way from row to row, open: joints, and the energies of analysis.energy), energy (J), fracture (J), kinetic (kinetic energy over work at the peak), series (VTK), analysis, model, mesh and ball.
---@param fields fabric_lab_ball_burst_fields
---@return table<string, any>
function fabric.lab.ball_burst(fields) end

---@class fabric_lab_ball_drop_fields
---@field card card the fabric
---@field side? number m: of the clamped square (default 0.2)
---@field radius? number m: of the ball (default 0.03)
---@field mass? number kg: of the ball (default 0.1)
---@field height? number m: that it falls from, of its lowest point above the sheet (default 0.1)
---@field friction? number of ball and cloth (default 0.2)
---@field stiffness? number Pa/m: of contact, as for model:contact
---@field cells? integer along an edge (default 20)
---@field duration? number s: of the run (default 0.03)
---@field step? number s: as for fabric.dynamic; default: "auto"
---@field scheme? "explicit"|"implicit" as for fabric.dynamic (default "explicit")
---@field points? integer through the thickness, where the card has no bending of its own (default 3)
---@field damping? number 1/s: of the masses (default 0)
---@field every? number s: time between rows and frames (default 5e-04)
---@field out? string folder for curve.csv and the VTK series, cloth and ball

---A rigid ball falls onto the middle of a clamped square. Returns curve (a list of time, depth of the ball's lowest point and deflection of the middle, m below the sheet at rest, force on the ball, N, its speed downwards, m/s, the smallest gap above the floor of contact, m, and the energies of analysis.energy), depth, deflection and force (the largest of all rows), gap (the smallest), analysis, model, mesh and ball.
---@param fields fabric_lab_ball_drop_fields
---@return test
function fabric.lab.ball_drop(fields) end

---@class fabric_lab_band_fields
---@field specimens table one list of parameters per specimen
---@field level? number of confidence (default 0.95)
---@field draws? integer of the bootstrap (default 2000)
---@field seed? integer of the bootstrap (default 1)
---@field common? number[] relative standard uncertainties that all specimens share, one per parameter

---Mean parameters and their confidence band by the bootstrap over specimens: value, low, high, covariance (row by row). The last three are nil for one specimen.
---@param fields fabric_lab_band_fields
---@return table<string, any>
function fabric.lab.band(fields) end

---@class fabric_lab_bias_fields.grips
---@field lateral number N/m^2: stiffness across, per metre of edge

---@class fabric_lab_bias_fields
---@field card card the fabric
---@field angle? number degrees: of the pull from the warp (default 45)
---@field displacement? number m: largest displacement (default 0.02)
---@field grips? "clamped"|"free"|fabric_lab_bias_fields.grips clamped ends keep their width, free ends contract, {lateral=k}: springs across, k in N/m per metre of edge (default "free")
---@field path? number[] displacements visited in turn, as parts of the largest; default {1, 0}
---@field unload? boolean without a path: back again (default true)
---@field unilateral? boolean the grip lets go where the pull is zero; false: it pushes beyond that (default true)
---@field out_of_plane? "held"|"free" free: the strip, bowed by a tenth of its thickness, may buckle (default "held")
---@field stabilise? number|boolean as for fabric.static: a buckling strip needs it (default false)
---@field cells? number[] {across, along}; default {3, 9}
---@field steps? integer for the whole history (default 80)
---@field rows? integer of the curve, at equal times, besides the first; default: one for each step
---@field tolerance? number as for fabric.static (default 1e-10)
---@field max_iterations? integer as for fabric.static (default 200)
---@field max_cuts? integer as for fabric.static (default 12)
---@field method? "newton"|"relaxation"|"either" as for fabric.static (default "newton")
---@field width? number m: of the strip (default 0.0254)
---@field length? number m: between the grips (default 0.0762)
---@field thickness? number m: default: the card's
---@field yarns? "eased"|"full" as for fabric.model (default "eased")
---@field out? string folder for curve.csv and the VTK series strip.pvd

---A strip pulled off the yarns' axes and let go. Returns curve (a list of time, displacement, force, E, S = force over area, E_lateral, and E and S along the pull as _average over the elements and at the _centre, E12_average, E12_centre, S12_centre), peak (its row of largest displacement), zones (element numbers of the bias test's three zones), analysis, model, mesh, displacement, volume, and the method mesh_error(). And zone_mean(name): the means of a field in zones 1, 2, 3 at the present time.
---@param fields fabric_lab_bias_fields
---@return test
function fabric.lab.bias(fields) end

---@class fabric_lab_bias_extension_fields
---@field card card the fabric
---@field width number m: of the specimen
---@field length number m: between the grips
---@field displacement number m: largest displacement
---@field cells? integer squares across the width (default 10)
---@field steps? integer of the displacement, at each of which the curve has a row (default 60)
---@field tolerance? number as for fabric.static (default 1e-08)
---@field thickness? number m: default: the card's

---A strip at 45 degrees, clamped and pulled, on a mesh along its yarns: for yarns that hardly stretch. Returns curve (a list of time, displacement, force, E, S), analysis, model, mesh.
---@param fields fabric_lab_bias_extension_fields
---@return test
function fabric.lab.bias_extension(fields) end

---@class fabric_lab_bias_shear_fields
---@field displacement number[] m: of the crosshead, rising, from 0 (less by 1 % of the largest at most, as noise); rows that do not pass the largest so far are left out, a way back by more than 1 % of the largest is an error
---@field force? number[] N: of one length with it
---@field card? card instead of the force: what the pull would show by the same kinematics
---@field width number m: of the specimen
---@field length number m: between the grips, at least twice the width
---@field thickness? number m: of the cloth; default: the card's
---@field warp? table {loading=, poisson?, tested?} of yarns that stretch, a result of fabric.lab.fit or of a card: their stretch is taken out; with weft
---@field weft? table likewise
---@field limit? number degrees: angle up to which yarns are believed not to slip or stretch (default 30)
---@field cut? boolean the record ends at the limit and at a reversal (default false)

---Bias extension without markers, for yarns that do not stretch, or whose stretch warp and weft take out (by simulated pulls; `taken_out`: the share by which the last S12 rises): angle (degrees) of the middle zone, normal_force (N/m), E12, S12, valid (true up to the limit), rows (places in the record); or the force that a card gives. An error where the shear force turns negative.
---@param fields fabric_lab_bias_shear_fields
---@return table<string, any>
function fabric.lab.bias_shear(fields) end

---@class fabric_lab_bias_sizes_fields
---@field specimens table bias pulls: { {displacement=, force=, width=, length=, name=, laboratory=, direction=}, ... }, m and N, of one size or several; laboratory and direction: names, of all or of none
---@field thickness number m: of the cloth
---@field limit? number degrees: angle up to which rows count (default 30)
---@field knots? integer of the curve, at equal angles, straight between them (default 10)
---@field edges? boolean the free edges are accounted for, if the sizes determine them (default true)
---@field scatter? number relative deviation of one specimen, known from elsewhere: the least that bands hold; default: only what the records show (0.04 for the deviation of the edge)

---One shear curve from bias pulls of several sizes, and the width of the free edges that bear no load (slip of edge yarns, pull-out): edge (m), edge_deviation, edges (true if it exceeds twice its deviation and is below its bound, a fifth of the width; else the edges are taken as none), curve {angle, normal_force (N/m), deviation, E12, S12}, shear (for fabric.lab.card), specimens {name, rms, at_end, without = {rms, at_end}, predicted}, left_out (each size from the others: rms, at_end, points, inside), left_out_by (the same by laboratory and direction), predict(self, {displacement, width, length, laboratory, direction, edges=false}) -> {force, angle, band, low, high}: the 95 % band of a specimen, band 'learned' from how sizes, laboratories, directions and specimens differ, 'given' where only `scatter` is known, nil with a reason where it cannot be determined; text.
---@param fields fabric_lab_bias_sizes_fields
---@return table<string, any>
function fabric.lab.bias_sizes(fields) end

---@class fabric_lab_biaxial_fields
---@field card card the fabric
---@field displacement? number m: by which left and right edges move apart (default 0.03)
---@field ratio? number displacement of bottom and top over that of left and right (default 1)
---@field path? number[] displacements visited in turn, as parts of the largest; default {1, 0}
---@field release? number the test ends at this force, over the largest (default 1e-06)
---@field cells? integer along an edge (default 3)
---@field steps? integer for the whole history (default 80)
---@field size? number m: of the square (default 0.254)
---@field thickness? number m: default: the card's
---@field out? string folder for curve.csv and the VTK series square.pvd

---A square pulled along both yarns and let go until one has no pull left. Returns curve (a list of time, displacement, E11, E22, S11, S22 from the forces, and both as _average and _centre, force_x, force_y), peak (its row of largest displacement), analysis, model, mesh, volume, and the method mesh_error().
---@param fields fabric_lab_biaxial_fields
---@return test
function fabric.lab.biaxial(fields) end

---@class fabric_lab_branches_fields
---@field displacement number[] m: of a cyclic test
---@field tolerance number m: smallest way back that is a reversal

---Parts of a record between reversals: a list of {kind, first, last}; kind is loading, unloading, reloading (up to the largest displacement so far) or hold (five rows and more at a reversal).
---@param fields fabric_lab_branches_fields
---@return table[]
function fabric.lab.branches(fields) end

---@class fabric_lab_breaking_strength_fields
---@field folder string of records of pulls to rupture; specimens whose names differ by the number at the end (warp-1.csv, warp-2.csv) are a group, and so are those in one file
---@field standard? "ISO 13934-1"|"ASTM D5035" which says what counts (default "ISO 13934-1")
---@field gauge_length number m: between the jaws
---@field width number m: of the strips
---@field pretension? number N: elongations count from where the force first reaches it, and slack up to there lengthens the specimen; default: from the first row
---@field breaks? string|table { ['warp-2']=3e-3, ['warp-4']='jaw' }: distance of the break from the nearer jaw, m; or a table in a file: specimen, distance (mm). Within 5 mm it is a break at the jaw
---@field faulty? table { ['warp-3']='slipped' }: specimens to leave out, and why
---@field cut_at_break? boolean the machine ends its record at the break: one that ends near its largest force is of a specimen that broke (default false)
---@field kept? number broken: the force falls below this part of the largest and stays there (default 0.8)
---@field level? number of confidence of the interval of the mean (default 0.95)
---@field zero? boolean the displacement of the first row is taken off, and its force unless there is a pretension (default false)
---@field outliers? "tell"|"drop"|"keep" as in fabric.lab.tensile (default "tell")
---@field columns? table as in fabric.lab.read
---@field units? table as in fabric.lab.read
---@field default_units? table as in fabric.lab.read
---@field vocabulary? string|table as in fabric.lab.read
---@field thousands? "auto"|"."|","|"none" as in fabric.lab.read (default "auto")
---@field reverse? "none"|"both"|"displacement"|"force" as in fabric.lab.read (default "none")
---@field restarts? "tell"|"specimens"|"cycles" as in fabric.lab.read (default "tell")
---@field file? string the table as CSV

---The table of a folder of pulls to rupture after ISO 13934-1 or ASTM D5035. Returns names (of the groups), groups { name={ specimens={ {name, force, elongation, elongation_at_break, from_jaw, jaw, counted, remark, warnings}, ... }, counted, force, elongation and elongation_at_break (each n, mean, deviation, cv, low, high: the interval of the mean), per_width (N/m), notes } }, text (the table), warnings {code, text, specimen}, file. Elongations are numbers, not per cent.
---@param fields fabric_lab_breaking_strength_fields
---@return table<string, any>
function fabric.lab.breaking_strength(fields) end

---@class fabric_lab_cantilever_fields
---@field card card the fabric
---@field direction? number|"warp"|"weft" degrees: of the strip: warp, weft or an angle from the warp (default "warp")
---@field width? number m: of the strip (default 0.025)
---@field angle? number degrees: of the plane that the tip is to touch (default 41.5)
---@field overhang? number m: one overhang, in place of the one whose tip touches the plane
---@field cells? integer along the strip; default: 40, of a loop 80
---@field steps? integer steps in which the weight is applied, at least (default 5)

---Cantilever test [astm_d1388]: a strip is pushed over an edge until its tip touches a plane below. Returns overhang and bending_length (half of it), m, rigidity (weight times its cube, N.m), angle (of the chord, degrees), shape (the middle line, {x, z}), analysis.
---@param fields fabric_lab_cantilever_fields
---@return table<string, any>
function fabric.lab.cantilever(fields) end

---@class fabric_lab_capstan_fields
---@field card card the fabric; its warp lies along the strip
---@field radius? number m: of the cylinder (default 0.03)
---@field wrap? number degrees: of the strip about it (default 90)
---@field friction? number of strip and cylinder (default 0.3)
---@field tension? number N/m: T1, that the strip is held by (default 10)
---@field width? number m: of the strip (default 0.01)
---@field around? integer elements of the wrap (default 16)
---@field lead? integer elements of the straight part on either side; default: 2, or as many as are drawn onto the cylinder
---@field draw? number of the strip's length: how far it is drawn (default 0.05)
---@field step? number s: largest step: 1 s is the tension, 1 s more the drawing (default 0.05)
---@field stiffness? number Pa/m: of contact, as for model:contact

---A strip over a rigid cylinder is held by a tension T1 on one side and drawn over it on the other. Returns ratio (T2 / T1 at the end), curve (a list of time, drawn, m, and ratio), analysis, model, mesh and drum.
---@param fields fabric_lab_capstan_fields
---@return test
function fabric.lab.capstan(fields) end

---@class fabric_lab_card_fields
---@field name string of the fabric
---@field source? string who measured, when; what was fitted is put behind it (default "")
---@field density number kg/m^3: as of fabric.lab.density
---@field thickness number m: of the cloth
---@field warp? table result of fabric.lab.fit, the warp of a card, or {loading=, unloading=}
---@field weft? table likewise
---@field shear? table result of fabric.lab.fit of shear tests (tensor measure), or likewise
---@field poisson? table {warp=, weft=}: numbers, or results of fabric.lab.poisson
---@field assume? boolean|table true: values without a test follow a rule and are marked assumed in card.provenance; a table gives values, {['warp.unloading']=..., ['weft.poisson']=...}, and {thickness=true} marks an argument; false: an error (default false)
---@field bending? table as in fabric.woven, or a result of fabric.lab.twist, with its band
---@field viscous? table result of fabric.lab.viscous (which may find none), or { shear={ modulus=, time= } } in S12 over E12; default: nothing relaxes

---A woven card from fits, with bands, tested ranges and, in provenance, where each number comes from: fitted, copied off a card, typed, or assumed; card:write keeps them.
---@param fields fabric_lab_card_fields
---@return card
function fabric.lab.card(fields) end

---@class fabric_lab_chain_fields
---@field model model the cloth with what holds it in all steps, without loads
---@field steps table { {name=, duration=, scheme=?, loads=?, release=?, options=?}, ... }: duration and release in s; scheme 'static', 'explicit' or 'implicit'; loads=function(model, begins, before) adds to a copy of the model what holds, moves and loads it in this step, which begins at the time `begins` from the analysis `before`; options are further fields of fabric.static or fabric.dynamic
---@field cycles? integer how often the list of steps is gone through (default 1)
---@field columns? table { name=function(analysis) ... end, ... }: numbers that are read at the end of each step
---@field watch? function function(analysis, name, cycle) before a step is solved: its outputs and hooks
---@field checkpoint? string file of checkpoints, eight in each step, from which --restart goes on with the step under way

---Steps of a test that follow each other, such as loading, relaxation, unloading, and cycles of them: each begins from the state of the one before. Returns rows (one a step: cycle, name, time (s), stored, dissipated, work (J), and the columns), the last analysis, and its model.
---@param fields fabric_lab_chain_fields
---@return table<string, any>
function fabric.lab.chain(fields) end

---@class fabric_lab_compare_fields.options
---@field x? string column of both; default E, else displacement
---@field y? string column of both; default S, else force
---@field slack? number|"find" of first contact: a stretch as in fit.specimens[i].slack where x is E, else of the unit of x; default 0; find: where a polynomial through the measured curve meets zero
---@field spread? table result of fabric.lab.spread: the band of the next specimen is drawn, and `inside` says what part of the points lies in it
---@field all? boolean unloading too; default: virgin loading up to failure
---@field file? string of the figure with both curves: .svg, .pdf, .eps or .png
---@field label? string of what was measured, in the key; default: the name of its file
---@field title? string of the figure
---@field window? number s: each point of the test is the mean over so long a time about it: where friction or contact chatters from step to step

---A measured curve beside a test's: x, measured, simulated (between the test's points in virgin loading), residual = measured less simulated; rms and worst as parts of the measured peak, largest {x, residual}, outside (points beyond the test), slack, inside, text. For a result of fabric.lab.tear also tear = { measured=, simulated= }, each with mean (N, after the first quarter of the record), mean_of_peaks (N, as the test's standard takes it) and peaks (their number).
---@param measured table result of fabric.lab.tensile or shear_from_bias, or a record with lists of the columns
---@param test table result of a virtual test (fabric.lab.uniaxial and so on), its curve, or lists likewise
---@param options? fabric_lab_compare_fields.options what is compared, and the file of the figure
---@return table<string, any>
function fabric.lab.compare(measured, test, options) end

---@class fabric_lab_correlate_fields.region
---@field left? integer first column, from 0 at the left
---@field top? integer first row, from 0 at the top
---@field right? integer column behind the last
---@field bottom? integer row below the last

---@class fabric_lab_correlate_fields
---@field files table photographs in order, all of one size: PNG, JPEG, TIFF or BMP
---@field region? fabric_lab_correlate_fields.region pixels of the photograph, as picture viewers count them; default: all
---@field subset? integer pixels of a subset's side, odd: three speckles and more (default 25)
---@field step? integer pixels between subsets; default: half of a side
---@field search? integer pixels that a subset may have moved since the photograph before, to be found without a neighbour's help (default 20)
---@field gauge? integer subsets in a row, odd, whose displacements make a strain (default 5)
---@field scale? number m: of a pixel

---Follows a speckled surface through photographs by digital image correlation: rows, columns (of subsets in the region of the first), frames, x, y (of their middles on each photograph; m, or pixels without a scale; y upwards; nan: lost, or without texture), E11, E22, E12 (Green-Lagrange), correlation, deviation (of a displacement, from what differs between the photographs), all frames x subsets; found (part of the subsets, by frame). rows, columns, x, y are a grid of markers for poisson and shear_from_bias. Needs the part photographs.
---@param fields fabric_lab_correlate_fields
---@return table<string, any>
function fabric.lab.correlate(fields) end

---@class fabric_lab_cusick_fields
---@field card card the fabric
---@field disc? number m: diameter of the cloth: 0.24, 0.30, 0.36; JIS 0.254 (default 0.3)
---@field support? number m: diameter of the pedestal; JIS 0.127 (default 0.18)
---@field seeds? integer how many discs, each with an irregularity and an orientation of its own (default 1)
---@field seed? integer of the first; the next ones follow (default 1)
---@field orientation? number degrees: of the warp in the mesh; default: drawn from the seed
---@field cells? integer elements from the pedestal's edge to the rim (default 8)
---@field around? integer elements around; default: so that they are square in the middle of the overhang
---@field offset? number m: how uneven the cloth lies: deviation of the rim from the level (default 0.002)
---@field edge? number m: radius of the pedestal's rounded edge; a smaller one lies near the held rim of a coarse mesh, and costs time (default 0.008)
---@field held? number m: diameter of the plate on top; default: that of the pedestal
---@field side? number m: height of the pedestal's side, 0: a plate on a thin post; default: half of the disc
---@field friction? number of cloth on pedestal and on cloth (default 0.3)
---@field contact? boolean false: the cloth touches nothing, it is held at the pedestal's rounded edge (default true)
---@field self? boolean the cloth may touch itself (default true)
---@field by? "motion"|"relaxation" how it comes to rest: relaxation goes through equilibria under growing fractions of the weight, in a fraction of the time where yarns are stiff; limp cloth comes to fewer and deeper folds so, and to a coefficient that is 3 to 7 points lower (default "motion")
---@field steps? integer load steps of the weight, of relaxation (default 10)
---@field lowering? number s: over which the weight comes (default 1.5)
---@field damping? number 1/s: of the masses (default 5)
---@field still? number rest: no place of the rim moves by more than this part of the overhang in a window (default 0.005)
---@field window? number s: of that rule (default 0.1)
---@field duration? number s: to wait for rest, at most; default: 4 s after the lowering
---@field processes? integer seeds side by side; default: the threads that the program may use
---@field every? number s: time between frames of the VTK series (default 0.1)
---@field out? string folder for a VTK series of each seed
---@field file? string the outlines as a figure; ends in .svg

---Drape test: a disc of cloth is let down over a pedestal, in motion or by relaxation, until it rests; once for each seed, side by side. Returns coefficient (shadow of the overhang over that of the level cloth, 0 to 1), nodes (folds) and amplitude (half of their height in the outline, m), means over the seeds; scatter (their deviations from disc to disc, nan of one), contour (points {x, y} of the first disc's outline), at_rest, runs (each disc's own, with seed, orientation, time and the ledger's error), and of one disc alone analysis, model and mesh.
---@param fields fabric_lab_cusick_fields
---@return table<string, any>
function fabric.lab.cusick(fields) end

---@class fabric_lab_density_fields
---@field mass number[] kg: of each weighed piece
---@field area number m^2: of a piece
---@field thickness number[] m: measured

---Mass per area, thickness (means) and density = mass per area over thickness [williams2010, section 3.3.1].
---@param fields fabric_lab_density_fields
---@return table<string, any>
function fabric.lab.density(fields) end

---@class fabric_lab_drape_fields
---@field card card the fabric
---@field cells? integer along an edge; 20 are those of the thesis, 1 to 2 for each fold of a square of 2 m by its weight (model:check()) (default 20)
---@field size? number m: of the square (default 2)
---@field duration? number s: of the run (default 0.5)
---@field step? number s: as for fabric.dynamic; default: "auto"
---@field scheme? "explicit"|"implicit" as for fabric.dynamic (default "explicit")
---@field points? integer through the thickness, where the card has no bending of its own (default 3)
---@field damping? number 1/s: of the masses (default 0)
---@field every? number s: time between rows and frames (default 0.005)
---@field force? boolean as for fabric.dynamic (default false)
---@field strict? boolean a run that fails is an error; false: its rows so far are returned, with `trouble` (default true)
---@field ledger_limit? number as for fabric.dynamic (default 0.05)
---@field out? string folder for curve.csv and the VTK series

---A square sheet, held at its corners, falls under its weight. Returns curve (a list of time, centre and lowest: how far the middle and the lowest node hang down, m; the energies of analysis.energy), analysis, model, mesh, and trouble where the run stopped.
---@param fields fabric_lab_drape_fields
---@return test
function fabric.lab.drape(fields) end

---@class fabric_lab_dress_fields
---@field analysis analysis a run in motion, of pieces around a body with seams, contact and gravity, that has not got to `at` yet
---@field at number s: the time to run to, when the seams have closed (their over= has passed) and the cloth shall rest; the body moves after it
---@field window? number s: before that time, over which rest is judged (default 0.02)
---@field still? number m: rest: no node has moved by more than that in the window (default 0.001)
---@field calm? number rest: the kinetic energy is below this part of the energy stored (default 0.01)
---@field state? table an empty table to keep what was found in, for `keep` of a:checkpoint, so that a restart knows it

---Sews pieces around a body and lets them come to rest: runs to the time `at` and judges rest there. A piece that starts through a body is refused when the run is made. Returns at_rest (without it a warning says why; nil: the run came from a checkpoint behind the window, and it is not known), moved (m, by `node`, in the window), kinetic (over the energy stored), stitches and how many are open (those of a seam with a stiffness of its own stay so), gap (m, the smallest above the floor of contact, of `pair`), and time. A run with until_rest= ends where it rests by that rule, before `at`: then time is earlier, and moved may be nil.
---@param fields fabric_lab_dress_fields
---@return table<string, any>
function fabric.lab.dress(fields) end

---@class fabric_lab_ensemble_fields
---@field parameters table { {name=, start=, low=, high=}, ... } as of fabric.lab.identify; any value between the bounds is as likely before the data
---@field tests? table as of fabric.lab.identify: the same likelihood, exp(-chi^2/2)
---@field log? function instead: function(p) that returns the logarithm of a density, up to a constant
---@field found? table result of fabric.lab.identify: the walkers begin around it
---@field walkers? integer even; default: four a parameter, 20 at least
---@field steps? integer that are kept, of every walker; each costs a simulation (default 1000)
---@field level? number of the band from low to high (default 0.95)
---@field processes? integer side by side (default 1)
---@field seed? integer of all that is random (default 1)

---Samples of the parameters' probability density given the data, for bands that are wide, skew or curved, by the ensemble sampler of Goodman and Weare: samples (lists by name), mean, median, low, high (by name), deviation, correlation, best (the likeliest draw, by name), log (of the density there), taken, time (autocorrelation, steps), independent (number of independent draws they are worth), failed, text.
---@param fields fabric_lab_ensemble_fields
---@return table<string, any>
function fabric.lab.ensemble(fields) end

---@class fabric_lab_fast_fields.along
---@field stretch number[] elongation over length
---@field force number[] N/m: per width

---@class fabric_lab_fast_fields.bias
---@field stretch number[] elongation over length
---@field force number[] N/m: per width

---@class fabric_lab_fast_fields
---@field along fabric_lab_fast_fields.along pull along a yarn
---@field bias? fabric_lab_fast_fields.bias pull at 45 degrees
---@field bending_length? number m: C, by the cantilever
---@field mass_per_area? number kg/m^2: W

---E5, E20, E100 (per cent at 5, 20, 100 gf/cm: 4.90, 19.6, 98.1 N/m), EB5, G = 123/EB5 (N/m; FAST counts what the yarns stretch as shear), B = W g C^3 (uN.m), F = (E20 - E5) B / 14.7 (mm^2).
---@param fields fabric_lab_fast_fields
---@return table<string, any>
function fabric.lab.fast(fields) end

---@class fabric_lab_fast_card_fields.warp
---@field E20 number per cent: extension at 20 gf/cm
---@field E100 number per cent: extension at 100 gf/cm
---@field B number uN.m: bending rigidity

---@class fabric_lab_fast_card_fields.weft
---@field E20 number per cent: extension at 20 gf/cm
---@field E100 number per cent: extension at 100 gf/cm
---@field B number uN.m: bending rigidity

---@class fabric_lab_fast_card_fields.poisson
---@field warp number as in fabric.woven
---@field weft number as in fabric.woven

---@class fabric_lab_fast_card_fields
---@field name string of the fabric
---@field thickness number m: T2, of the cloth
---@field density number kg/m^3: mass over volume
---@field warp fabric_lab_fast_card_fields.warp FAST's numbers along the warp
---@field weft fabric_lab_fast_card_fields.weft along the weft
---@field EB5 number per cent: bias extension
---@field poisson fabric_lab_fast_card_fields.poisson FAST does not measure them
---@field unloading_ratio? number unloading modulus over the largest tangent: FAST does not measure it (default 2)

---A card that reproduces the given FAST numbers; the part of EB5 that comes from the yarns is not taken for shear. Unloading is assumed by its ratio; twist is half of the mean bending rigidity.
---@param fields fabric_lab_fast_card_fields
---@return card
function fabric.lab.fast_card(fields) end

---@class fabric_lab_fit_fields
---@field tests table replicates: results of fabric.lab.tensile or shear_from_bias
---@field degree? integer|"auto"|"monotone" of the stress polynomial; auto: 2 or 4 by the criterion; monotone: points of a rising curve (default "auto")
---@field find_slack? "either"|boolean first contact is uncertain: curve and band are averaged over where it may be and over laws; true: there was slack; either: slack or none. The loading (auto) is the polynomial of degree 2, 4 or 6 that describes the average, else points (default false)
---@field upto? "failure"|"yield" rows used (default "failure")
---@field rule? "first"|"robust" of the unloading modulus (default "first")
---@field count? integer first points of the unloading (default 3)
---@field kept? number robust: part of the stress (default 0.7)
---@field level? number of confidence (default 0.95)
---@field draws? integer of the bootstrap (default 2000)
---@field seed? integer of the bootstrap (default 1)
---@field common? number relative standard uncertainty of all moduli together: load cell, thickness, width (default 0)

---A backbone from replicate specimens: loading (tangent coefficients in Pa, or points), unloading, tested (reach of all), band {value, low, high, covariance} of {loading..., unloading} (without unloading where not every specimen unloads: then unloading_band is that of those that do), text (the criterion's table), specimens, tests (how many), warnings (specimens unlike the others, as fabric.lab.spread finds them).
---@param fields fabric_lab_fit_fields
---@return table<string, any>
function fabric.lab.fit(fields) end

---@class fabric_lab_form_fields.punch
---@field shape? "hemisphere"|"box"|"double dome"|"L"|"Z" of the punch or of the opening: hemisphere (round), box, double dome; L and Z: profiles along y, whose face ends at x = 0 in a wall (default "hemisphere")
---@field radius? number m: of a hemisphere, a dome or a round opening
---@field size? number[] m: {along x, along y} of a box; of L and Z the width of the lower face and the length of the profile
---@field corner? number m: radius of a box's corners, seen from above
---@field length? number m: from centre to centre of a double dome, along x
---@field waist? number m: radius of the arcs that join both domes
---@field angle? number degrees: of the wall of L and Z from the horizontal, default 90
---@field edge? number m: radius of the lower edge of a box, of the edges of L and Z
---@field height? number m: of a box; of the shaft of a hemisphere; of the wall of L and Z; default the shorter side, the radius, the width of an L
---@field around? integer facets around (default 64)
---@field file? string an STL or other mesh file in the place of lengths; x and y are kept, along z it is moved to the plies
---@field units? "m"|"cm"|"mm"|"inch" of that file, which says none

---@class fabric_lab_form_fields.die
---@field shape? "hemisphere"|"box"|"double dome"|"L"|"Z" of the opening; default that of the punch
---@field radius? number m: of a hemisphere, a dome or a round opening
---@field size? number[] m: {along x, along y} of a box; of L and Z the width of the lower face and the length of the profile
---@field corner? number m: radius of a box's corners, seen from above
---@field length? number m: from centre to centre of a double dome, along x
---@field waist? number m: radius of the arcs that join both domes
---@field angle? number degrees: of the wall of L and Z from the horizontal, default 90
---@field edge? number m: radius of the rounded edge of the opening; default the larger of a sixth of the punch's radius (of a box: a sixth of the shorter side; of L and Z the edge of the punch) and ten times the thickness of a ply; where contact= is given, at least five times that
---@field height? number m: of the wall of L and Z, which is the depth of the floor of Z; default four times the edge of an L
---@field gap? number m: from the wall of the punch of L and Z to that of the die, at the end of the stroke; default 1.1 times the thickness of the stack in contact
---@field outer? number m: radius of the round outside of die and holder; default 0.75 times the diagonal of the blank
---@field around? integer facets around (default 64)
---@field file? string an STL or other mesh file in the place of lengths; x and y are kept, along z it is moved to the plies
---@field units? "m"|"cm"|"mm"|"inch" of that file, which says none

---@class fabric_lab_form_fields.holder
---@field force? number N: that presses it on the plies
---@field springs? number N/m: stiffness of all springs that hold it down
---@field gap? number m: from die to holder, which stands
---@field mass? number kg: of the plate; default four times that of the plies
---@field file? string an STL or other mesh file in the place of lengths; x and y are kept, along z it is moved to the plies
---@field units? "m"|"cm"|"mm"|"inch" of that file, which says none

---@class fabric_lab_form_fields.film
---@field viscosity number Pa s: of what is between plies, and between them and the tools: a hot matrix
---@field thickness number m: of it
---@field speed? number m/s: of sliding from which the viscosity falls; default: it stays
---@field exponent? number of the speed in the traction far above that

---@class fabric_lab_form_fields
---@field card card the fabric of all plies
---@field stack? number[] degrees: {lowest, ..., upmost}: warp of each ply from x, default {0}
---@field blank number|number[] m: side of a square, or {along x, along y}
---@field punch fabric_lab_form_fields.punch the arguments of fabric.rigid.punch: { radius= }, { shape='box', size=, corner=, edge= }, { shape='double dome', radius=, length=, waist= }, { shape='L', size=, edge= }, { shape='Z', size=, edge=, height= }; or { file=, units= }
---@field die? fabric_lab_form_fields.die of fabric.rigid.die: { radius=, edge= }, ...; lengths of the opening that are left out: those of a punch of the same shape, wider on each side by 1.1 times the thickness of the stack in contact, at least a twenty-fifth of the punch's radius; of L and Z { edge=, gap= }; or { file=, units=, edge= }, edge being the least radius of its rim
---@field holder? fabric_lab_form_fields.holder { force=N }, { springs=N/m } or { gap=m }, with file= and units= where the die is a file; without it none
---@field friction? number of tools and plies (default 0.2)
---@field ply_friction? number of plies on each other; default that of the tools
---@field weft_friction? number friction across the warp, that along it being friction and ply_friction; of two plies the warp is that of the lower one
---@field film? fabric_lab_form_fields.film resists sliding beside friction, as film of model:contact: give the viscosity times the real speed of the punch over that of the run, and the speed over that
---@field stroke number m: way of the punch from first contact
---@field cells? integer elements along the longer side (of a quarter: of its own) (default 32)
---@field triangles? boolean elements of three nodes, cells of the blank cut along the diagonal that goes around the punch (default false)
---@field quarter? boolean only x > 0, y > 0, between planes of symmetry; forces and energies are those of the whole (default false)
---@field speed? number m/s: largest speed of the punch, default 2
---@field contact? number m: thickness of a ply in contact; default a fifth of the die's edge, or that of the card
---@field stiffness? number Pa/m: of contact; default what carries 6 MPa, which tight yarns press on the die's edge
---@field points? integer through the thickness of a single ply (default 1)
---@field damping? number 1/s: of motion, as damping.mass of fabric.dynamic; default 3 over the duration
---@field rows? integer of the curve (default 50)
---@field out? string folder for curve.csv, force.svg, the VTK series, whose fields warp and weft are the directions of the yarns, and the formed plies with their yarns for Abaqus and CalculiX (ply1.inp) and OpenRadioss (ply1.rad)
---@field ledger_limit? number as for fabric.dynamic (default 0.05)
---@field prepare? function prepare(analysis), called before it runs
---@field state? table an empty table to gather the curve in, for `keep` of a:checkpoint in prepare, so that a restart has the rows from before it

---Plies are pressed through the opening of a die by a punch, under a blank holder. Returns curve (a list of stroke, force of punch, holder and die, N, and energies), angles (of each element ply, X, Y flat, x, y, z formed, its shear angle, degrees, and the unit vectors warp and weft; max and place), draw_in (of each node of the edges ply, edge, X, Y, draw_in, m; max, mean, left, right, bottom, top), wrinkles (height above the flat of the die, m, x, y, ply), report (text), peak (N), stroke (m, reached), series (VTK) and files (of the formed plies) with out=, analysis, model, punch, die, holder, and trouble where the run stopped.
---@param fields fabric_lab_form_fields
---@return table<string, any>
function fabric.lab.form(fields) end

---@class fabric_lab_form_finding_fields.prestress
---@field warp number N/m: along the warp
---@field weft number N/m: along the weft

---@class fabric_lab_form_finding_fields
---@field mesh mesh a shape to begin with; what is held is at its place
---@field prestress fabric_lab_form_finding_fields.prestress { warp=N/m, weft=N/m }: the tensions of the shape that is sought; equal ones are those of a soap film
---@field hold function function(model), which declares the supports, as by model:fix('boundary', 'x y z')
---@field warp? any as for fabric.model, on each shape; default 0
---@field tolerance? number how far nodes may still move in the last round, over the size of the mesh (default 1e-05)
---@field rounds? integer at most (default 100)

---The shape in which a sheet with given tensions is in balance, by rounds of statics with an updated reference [bletzinger1999]. Returns mesh (the shape, with the sets of the mesh), rounds, moves (m, the longest way of a node in each round), analysis and model of the last round. A model of this mesh with a card and the same prestress begins in balance.
---@param fields fabric_lab_form_finding_fields
---@return table<string, any>
function fabric.lab.form_finding(fields) end

---@class fabric_lab_frequency_response_fields.base
---@field x? number m: along x
---@field y? number m: along y
---@field z? number m: along z

---@class fabric_lab_frequency_response_fields.force
---@field set integer|string name of a node set, or a node
---@field x? number N: along x
---@field y? number N: along y
---@field z? number N: along z

---@class fabric_lab_frequency_response_fields
---@field from? analysis the state about which the cloth swings
---@field model? model in its place: the cloth as it is at time 0, without stress
---@field base? fabric_lab_frequency_response_fields.base { x=, y=, z= }, m: amplitudes of all supports, which shake together
---@field force? fabric_lab_frequency_response_fields.force { set=, x=, y=, z= }, N: in its place the amplitudes of a force on a set, shared evenly by its nodes, or on a node
---@field damping number structural: the stiffness is K (1 + i damping); twice the share of critical damping
---@field node integer whose motion is asked for
---@field along? "x"|"y"|"z" which component of it; default the largest of what shakes
---@field lowest number Hz: the first frequency
---@field highest number Hz: the last frequency
---@field points? integer frequencies from the first to the last; those of the modes, and of half their power, are added (default 201)
---@field count? integer how many modes; default all below twice the last frequency, and at least 10

---Steady swings of a node about a state under supports or a force that shake, with structural damping, summed over the natural modes. Returns curve (rows of frequency, Hz; amplitude, m; phase, degrees, below 0 where the node lags; relative, m, of the motion beside the supports), peak (the row of the largest amplitude), modes (those of fabric.modes) and covered: of a base, the share that the modes have of the mass which moves; of a force, the share of the deflection at rest that the lower half of the modes gives.
---@param fields fabric_lab_frequency_response_fields
---@return table<string, any>
function fabric.lab.frequency_response(fields) end

---@class fabric_lab_grab_fields
---@field card card the fabric, with rupture
---@field yarn? "warp"|"weft" that is pulled (default "warp")
---@field width? number m: of the specimen (default 0.1)
---@field length? number m: between the jaws (default 0.1)
---@field jaw? number m: width and depth of the jaws (default 0.025)
---@field h? number m: size of the elements (default 0.005)
---@field ledger_limit? number as for fabric.dynamic (default 0.05)
---@field speed? number m/s: of the grips apart; default: kinetic energy stays a small share of the work
---@field damping? number 1/s: of the masses
---@field coarse? "lower"|"refuse"|"keep" as for model:tearable (default "keep")
---@field seed? integer of the scatter of strengths (default 1)
---@field rows? integer of the curve, at equal times
---@field out? string folder for curve.csv and the VTK series
---@field prepare? function function(analysis), called before the run: for hooks, records and checkpoints of your own
---@field state? table an empty table to gather the curve in, for `keep` of a:checkpoint in prepare, so that a restart has the rows from before it; without it peaks and means are nil then

---A wide specimen is held in its middle by narrow jaws and pulled until it breaks, as in ISO 13934-2 [iso_13934_2]. strength is over the width of the jaws. Returns peak (N, the largest force), elongation (m) and strain there, strength (N/m), curve (a list of time, displacement, force: N, work over way from row to row, open: joints, and the energies of analysis.energy), energy (J, of the whole record), fracture (J), kinetic (kinetic energy over work at the peak), series (VTK), analysis, model and mesh. There are no peaks to take a mean of.
---@param fields fabric_lab_grab_fields
---@return table<string, any>
function fabric.lab.grab(fields) end

---@class fabric_lab_heart_loop_fields
---@field card card the fabric
---@field direction? number|"warp"|"weft" degrees: of the strip: warp, weft or an angle from the warp (default "warp")
---@field length? number m: of the strip, between the grips (default 0.15)
---@field width? number m: of the strip (default 0.025)
---@field cells? integer along the strip; default: 40, of a loop 80
---@field steps? integer steps in which the weight is applied, at least (default 5)

---Heart loop test [astm_d1388]: a strip's ends are held together, upright, and it hangs down as a heart. Returns height (from the grip to the lowest point, m), bending_length (of the standard's formula, m), rigidity (N.m), shape (one half, {x, z}), analysis.
---@param fields fabric_lab_heart_loop_fields
---@return table<string, any>
function fabric.lab.heart_loop(fields) end

---@class fabric_lab_identify_fields
---@field parameters table { {name=, start=, low=, high=}, ... }; a logarithm where the size is not known
---@field tests table { {name=, measured={numbers}, predict=function(p) return numbers end, noise=}, ... }; p by parameter name; noise: one standard deviation, or one per number; default 1 % of the largest
---@field further? table tests that could be made: {name=, predict=, noise=}; ranked by what they would add
---@field processes? integer side by side, for the differences (default 2)
---@field checkpoint? string file of the simulations so far; used if it exists, after one of its points has been simulated again
---@field key? number|string what predict depends on beside the parameters: a checkpoint of another key is refused
---@field iterations? integer at most (default 30)
---@field tolerance? number relative, of the sum of squares and of the parameters (default 1e-06)
---@field difference? number step of the differences over high - low (default 0.001)
---@field settle? integer rounds at the end, with central differences over a standard deviation along combinations of parameters (default 8)
---@field progress? boolean prints the progress on stderr (default false)

---Card parameters by bounded least squares through simulation. Returns parameters (by name), deviation (nan on a bound), on_bound (the bound, by name), known (by name), correlation, weakest, misses (per test: rms and worst over the largest measured value, deviations), chi2 (per degree of freedom), discrepancy (nil, or what the model may miss smoothly: deviation over the noise, ratio of likelihoods, told), of_noise (deviation and correlation by the stated noise alone), further (ranked), simulations, text, card(self, function(p) return card end): the card with the parameters' 95 % bands propagated to its numbers, for card:sample.
---@param fields fabric_lab_identify_fields
---@return table<string, any>
function fabric.lab.identify(fields) end

---@class fabric_lab_impact_fields
---@field card card the fabric, with rupture of warp and weft
---@field ball? number m: diameter (default 0.00556)
---@field mass? number kg: of the ball; default: of steel (default 7e-04)
---@field side? number m: of the clamped square (default 0.1)
---@field h? number m: size of the elements in the middle (default 0.001)
---@field most? number m: size of the elements at the rim (default 0.004)
---@field duration? number s: at which a run ends that has not done so before (default 0.001)
---@field stiffness? number Pa/m: of contact, as for model:contact
---@field friction? number of ball and cloth (default 0.2)
---@field ledger_limit? number as for fabric.dynamic (default 0.05)
---@field speed number m/s: at which the ball strikes
---@field coarse? "lower"|"refuse"|"keep" as for model:tearable
---@field seed? integer of the scatter of strengths (default 1)
---@field rows? integer of the curve, at equal times
---@field out? string folder for curve.csv and the VTK series
---@field prepare? function function(analysis), called before the run: for hooks, records and checkpoints of your own
---@field state? table an empty table to gather the curve in, for `keep` of a:checkpoint in prepare, so that a restart has the rows from before it; without it peaks and means are nil then

---A ball is shot through the middle of a clamped square. Returns residual (m/s, its speed behind the cloth; negative: thrown back), through (whether it is behind the cloth), energy (J, what it lost), fracture (J), depth (m, the deepest), peak (N, the largest force), curve (a list of time, depth, speed, force, open: joints, and the energies of analysis.energy), series (VTK), analysis, model, mesh and ball.
---@param fields fabric_lab_impact_fields
---@return table<string, any>
function fabric.lab.impact(fields) end

---@class fabric_lab_kes_bending_fields
---@field curvature? number[] 1/m: of a cycle 0 to 250, to -250, to 0
---@field moment? number[] N: per width
---@field card? card in place of the measured rows: what the instrument would show of it
---@field direction? "warp"|"weft" that the card is tested along (default "warp")
---@field at? number 1/m: curvature of 2HB: 50 or 100, laboratories differ (default 50)

---B (slope from 50 to 150 1/m, gf cm^2/cm) and 2HB (gf cm/cm, height of the loop); of a card also its curve, curvature and moment.
---@param fields fabric_lab_kes_bending_fields
---@return table<string, any>
function fabric.lab.kes_bending(fields) end

---@class fabric_lab_kes_card_fields.warp
---@field EMT number per cent: stretch at 500 gf/cm
---@field WT? number gf cm/cm^2: work; or LT
---@field LT? number work over that of a straight line, in place of WT
---@field RT number per cent: of the work that is recovered

---@class fabric_lab_kes_card_fields.weft
---@field EMT number per cent: stretch at 500 gf/cm
---@field WT? number gf cm/cm^2: work; or LT
---@field LT? number work over that of a straight line, in place of WT
---@field RT number per cent: of the work that is recovered

---@class fabric_lab_kes_card_fields.shear
---@field G number gf/(cm deg): slope
---@field 2HG number gf/cm: height of the loop at 0.5 degrees
---@field 2HG5? number gf/cm: at 5 degrees

---@class fabric_lab_kes_card_fields.bending.warp
---@field B number gf cm^2/cm: rigidity
---@field 2HB? number gf cm/cm: height of the loop

---@class fabric_lab_kes_card_fields.bending.weft
---@field B number gf cm^2/cm: rigidity
---@field 2HB? number gf cm/cm: height of the loop

---@class fabric_lab_kes_card_fields.bending
---@field warp fabric_lab_kes_card_fields.bending.warp along the warp
---@field weft fabric_lab_kes_card_fields.bending.weft along the weft
---@field twist? number N.m: rigidity; default: half of the mean
---@field build_up? number 1/m: curvature over which friction builds up (default 10)

---@class fabric_lab_kes_card_fields.compression
---@field LC number linearity
---@field WC number gf cm/cm^2: work
---@field RC number per cent: of the work that is recovered

---@class fabric_lab_kes_card_fields.poisson
---@field warp number as in fabric.woven
---@field weft number as in fabric.woven

---@class fabric_lab_kes_card_fields
---@field name string of the fabric
---@field thickness? number m: of the cloth; or T
---@field density? number kg/m^3: mass over volume; or W
---@field T? number mm: thickness at 0.5 gf/cm^2, in place of thickness
---@field W? number mg/cm^2: weight, in place of density
---@field warp? fabric_lab_kes_card_fields.warp pull along the warp; without it as of the weft, without both as of the library's cloths
---@field weft? fabric_lab_kes_card_fields.weft pull along the weft, likewise
---@field shear? fabric_lab_kes_card_fields.shear with 2HG5 elastic shear with friction that grows with the angle; without it as of the library's cloths
---@field bending? fabric_lab_kes_card_fields.bending without it as of the thickness
---@field compression? fabric_lab_kes_card_fields.compression what contact presses with; RC is kept in the card's source, since contact gives back all
---@field fibre_density? number kg/m^3: of what the yarns are made of, as in fabric.woven: cloth is pressed no thinner than its fibres
---@field poisson? fabric_lab_kes_card_fields.poisson KES does not measure them; default 0.4, assumed

---A card that reproduces the given KES numbers; its source says which it represents, and which not. fabric.lab.kes_sheet reads them back. Any part of the sheet will do, bending alone too: what is missing is taken from the cards of the library, marked assumed in card.provenance with the range in which it may lie, and varied by fabric.budget.
---@param fields fabric_lab_kes_card_fields
---@return card
function fabric.lab.kes_card(fields) end

---@class fabric_lab_kes_shear_fields
---@field angle? number[] degrees: of a cycle 0 to 8, to -8, to 0
---@field force? number[] N/m: shear force per width
---@field card? card in place of the measured rows: what the instrument would show of it

---G (slope from 0.5 to 2.5 degrees, gf/(cm deg)), 2HG and 2HG5 (gf/cm, height of the loop at 0.5 and 5 degrees); of a card also its curve, angle and force.
---@param fields fabric_lab_kes_shear_fields
---@return table<string, any>
function fabric.lab.kes_shear(fields) end

---@class fabric_lab_kes_sheet_fields
---@field card card the fabric

---The KES sheet of a card by virtual tests, as fabric.lab.kes_card takes it: warp and weft (EMT LT WT RT), shear (G 2HG 2HG5), bending (warp and weft, B 2HB; where the card has its own), compression (LC WC RC; where the card's goes from 0.5 to 50 gf/cm^2), T (mm), W (mg/cm^2).
---@param fields fabric_lab_kes_sheet_fields
---@return table<string, any>
function fabric.lab.kes_sheet(fields) end

---@class fabric_lab_kes_tensile_fields
---@field stretch? number[] elongation over length, up to the largest load and back
---@field force? number[] N/m: per width; KES goes to 500 gf/cm
---@field card? card in place of the measured rows: what the instrument would show of it
---@field direction? "warp"|"weft" that the card is tested along (default "warp")

---EMT (per cent at the largest load), WT (gf cm/cm^2), LT = WT over that of a straight line, RT (per cent of the work that comes back).
---@param fields fabric_lab_kes_tensile_fields
---@return table<string, any>
function fabric.lab.kes_tensile(fields) end

---@class fabric_lab_kilby_fields
---@field warp number Pa: E1
---@field weft number Pa: E2
---@field nu12 number contraction along the weft when pulled along the warp
---@field nu21 number the other way round
---@field bias? number Pa: E45; gives shear
---@field shear? number Pa: G12 (engineering), instead of bias
---@field reading? "definition"|"printed" nu12/E1 + nu21/E2 by the definition of the ratios, or nu21/E1 + nu12/E2 as eq. 3.4 is printed (default "definition")

---Kilby's relation G = 1/(4/E45 - 1/E1 - 1/E2 + coupling): returns shear and bias, one of which is given.
---@param fields fabric_lab_kilby_fields
---@return table<string, any>
function fabric.lab.kilby(fields) end

---@class fabric_lab_loops_fields
---@field tests table results of fabric.lab.tensile along one yarn with unloading and, better, reloading
---@field fit? table result of fabric.lab.fit of the same tests; default: made here, with find_slack='either', rule='robust'
---@field enough? number a straight law that misses by no more than this share of the peak stress (rms) is good enough (default 0.01)
---@field level? number of confidence (default 0.95)
---@field seed? integer of the bootstrap (default 1)

---How far unloading and reloading are from the law's straight line, and the curved loop that follows them: a part for fabric.lab.card (loading, unloading, tested, band and, where the records ask for it, loop {friction, reach, curve}); rms {straight, rule, curved} {all, unloading} as shares of the peak stress (rule: with the modulus of the first rows), low and high of each number, curved, curves {E, S, straight, curved} per test, text.
---@param fields fabric_lab_loops_fields
---@return table<string, any>
function fabric.lab.loops(fields) end

---@class fabric_lab_mesh_error_fields
---@field run function function(n) that returns {name=number, ...} on a mesh refined n = 1, 2, 4 times
---@field print? boolean a table (default true)

---Richardson's estimate from three meshes. Returns, by name, {f1, f2, f3, limit=, order=, error=}: error is that of the first mesh, a fraction of the limit; no order where the three do not approach one, and then error is their spread.
---@param fields fabric_lab_mesh_error_fields
---@return table<string, any>
function fabric.lab.mesh_error(fields) end

---The quantile of the normal distribution with mean 0 and deviation 1.
---@param probability number of values below it
---@return table<string, any>
function fabric.lab.normal(probability) end

---@class fabric_lab_parallel_fields
---@field count integer of items
---@field work function work(i) returns a list of numbers
---@field processes? integer parallel processes, each with one thread; default: the threads that the program may use
---@field done? function done(i) is called in this process after each item
---@field isolated? boolean each item in a process of its own, even with processes=1 (default false)
---@field collect? boolean what the items warn of is not shown but returned, a list warnings with each answer, and logged (default false)
---@field progress? string progress is shown, preceded by this word (default "")

---Calls work(i) for items 1 to count in parallel processes. Returns the lists in order; that of a failed item is empty and has trouble, the message, and died=true when its process ended without an answer.
---@param fields fabric_lab_parallel_fields
---@return table[]
function fabric.lab.parallel(fields) end

---@class fabric_lab_photograph_fields
---@field file string ends in .png
---@field rows integer of dots, following each other along the pull (y)
---@field columns integer of dots, across
---@field pitch number pixels: of the undeformed grid
---@field radius number pixels: of an undeformed dot
---@field width integer of the picture, pixels
---@field height integer of the picture, pixels
---@field F? number[] {F11, F12, F21, F22}: the map of the cloth, y upwards; default: none
---@field blur? number pixels: standard deviation of the lens (default 1)
---@field noise? number of a pixel, white being 1 (default 0.01)
---@field ground? number brightness of the cloth, white being 1 (default 0.85)
---@field ink? number brightness of the dots (default 0.15)
---@field seed? integer of the noise (default 1)

---Makes a photograph of a dot grid under a known map, with blur and noise: for trying the tracker. Needs the part photographs.
---@param fields fabric_lab_photograph_fields
function fabric.lab.photograph(fields) end

---@class fabric_lab_picture_frame_fields
---@field displacement number[] m: of the crosshead along the diagonal
---@field force? number[] N: less that of the empty frame
---@field card? card instead of the force: what the frame would show
---@field thickness? number m: of the cloth; default: the card's
---@field frame number m: side of the frame, between hinges
---@field cloth number m: side of the cloth without its arms

---Picture frame: angle (degrees), normal_force (N/m, normalised by frame / cloth^2), E12, S12 from force and displacement; or force from a card.
---@param fields fabric_lab_picture_frame_fields
---@return table<string, any>
function fabric.lab.picture_frame(fields) end

---@class fabric_lab_poisson_fields
---@field specimens table marker grids: { {rows=, columns=, x=, y=}, ... } as of fabric.lab.tracks
---@field noise? number of a coordinate; default: from the scatter of each specimen
---@field seed? integer of the bootstrap (default 1)
---@field common? number relative standard uncertainty that all share (default 0)

---The contraction ratio (eq. 3.3): one line through the origin per specimen with its boxes pooled, then the mean: value, low, high, variance, specimens { {value, plain, noise, uncertainty}, ... }.
---@param fields fabric_lab_poisson_fields
---@return table<string, any>
function fabric.lab.poisson(fields) end

---@class fabric_lab_poke_fields
---@field height? number m: that the punch rises to (default 0.4)
---@field stroke? number s: up and down (default 0.5)
---@field card card the fabric
---@field cells? integer along an edge; 20 are those of the thesis, 1 to 2 for each fold of a square of 2 m by its weight (model:check()) (default 20)
---@field size? number m: of the square (default 2)
---@field duration? number s: of the run (default 0.5)
---@field step? number s: as for fabric.dynamic; default: "auto"
---@field scheme? "explicit"|"implicit" as for fabric.dynamic (default "explicit")
---@field points? integer through the thickness, where the card has no bending of its own (default 3)
---@field damping? number 1/s: of the masses (default 0)
---@field every? number s: time between rows and frames (default 0.005)
---@field force? boolean as for fabric.dynamic (default false)
---@field strict? boolean a run that fails is an error; false: its rows so far are returned, with `trouble` (default true)
---@field ledger_limit? number as for fabric.dynamic (default 0.05)
---@field out? string folder for curve.csv and the VTK series

---A square sheet, its rim held, is pushed up by a punch in its middle and let down. Returns curve (a list of time, height of the punch, lowest: how far the lowest node hangs down, m; E11 and S11 one element beside the punch along the warp, E22 and S22 along the weft; the energies of analysis.energy), analysis, model, mesh, along_warp and along_weft (the two elements), and trouble where the run stopped.
---@param fields fabric_lab_poke_fields
---@return test
function fabric.lab.poke(fields) end

---@class fabric_lab_pool_fields.rate
---@field reference number speed at which the parameters hold, in the unit of the tests' rate
---@field most? number largest part for a factor e in the speed, either way; default 0.2

---@class fabric_lab_pool_fields
---@field parameters table { {name=, start=, low=, high=}, ... } as of fabric.lab.identify
---@field tests table one for each specimen, as of fabric.lab.identify: { {name=, measured=, predict=, noise=, rate=, finer=, x=, scale=}, ... }; rate: speed of the test; finer(p): predict on a mesh of half the size, when the simulation has one; x: abscissa of the numbers (strain, angle), of one meaning in all tests (default: the place in the list); scale: what the model's error is relative to, where it is not the predicted numbers: the fit then has no factor of specimens
---@field model? function function(p, test) return numbers end, in place of `predict` of each test; it reads the test's further fields (width=, angle= ...), and takes what `predict` is asked for
---@field groups? table names of fields of the tests by which they belong together: {'laboratory', 'size'}; each has a deviation of its own, and each label is predicted from the others
---@field leave? boolean predicts each label of each group by a fit to the others (default true)
---@field rate? fabric_lab_pool_fields.rate accounts for the speed: predictions times 1 + p.rate ln(rate / reference)
---@field level? number of confidence (default 0.95)
---@field processes? integer side by side, for the differences (default 2)
---@field iterations? integer at most, of each fit (default 30)
---@field progress? boolean prints the progress on stderr (default false)

---Parameters from several specimens, sizes, laboratories and speeds at once, with the scatter between specimens and the mesh's error beside the noise: parameters, low, high (by name), deviation, covariance, between (relative deviation of specimens), mesh (relative), chi2 (of what is left, per degree of freedom), tests (by name: predicted, low, high: band of the mean, next_low, next_high: of the next specimen, rms, factor: of this specimen), left_out (by name: inside, rms, at_end, predicted, low, high, from the others), coverage, left_out_by (by group a list {label, inside, points, rms, tests}), effects (what the model misses: freedom, deviation, shares), predict(self, {x=, ...}) -> {predicted, low, high, band, reason}: a specimen that was not tested; band is nil and reason says why where the tests do not show how wrong the model is; card(self, function(p) return card end): the card with the parameters' bands propagated to its numbers; text.
---@param fields fabric_lab_pool_fields
---@return table<string, any>
function fabric.lab.pool(fields) end

---@class fabric_lab_ratio_fields
---@field rows integer of markers, following each other along the pull
---@field columns integer of markers, across the pull
---@field x table of every marker, row by row, frame after frame; nan: lost
---@field y table likewise
---@field noise? number of a coordinate (standard deviation); default: from the scatter
---@field least? number strain along the pull from which on boxes count (default 0.01)

---Contraction ratio of one specimen (eq. 3.3), boxes pooled, corrected for noise in the positions: value, plain (not corrected), noise, uncertainty (standard, over the boxes).
---@param fields fabric_lab_ratio_fields
---@return table<string, any>
function fabric.lab.ratio(fields) end

---@class fabric_lab_read_fields
---@field file string of the load frame: CSV, TSV or the like, or a spreadsheet (.xlsx)
---@field columns? table {displacement=, force=, time=, strain=}: heading or place of the column, false: no time, no strain; default: known by the heading
---@field units? table {displacement='mm', force='N'}; default: those of the headings
---@field default_units? table the same, for columns whose heading says none
---@field gauge_length? number m: for a record of strains: the displacement follows
---@field width? number m: for a record of forces per width: the force follows
---@field vocabulary? string|table words of your frame: {force={'siua'}, displacement={...}, time=, strain=, units={force={dyn=1e-5}}}, or a Lua file that returns them
---@field separator? "auto"|","|";"|"tab"|"blank" between cells (default "auto")
---@field decimal? "auto"|"."|"," decimal sign (default "auto")
---@field thousands? "auto"|"."|","|"none" sign between thousands; auto: where it cannot be the decimal sign; none: no sign stands there (default "auto")
---@field reverse? "none"|"both"|"displacement"|"force" whose sign is changed, for a frame that counts a pull negative (default "none")
---@field restarts? "tell"|"specimens"|"cycles" where displacement and force leap back to their beginning. tell: a warning, read as one specimen; specimens: another begins there; cycles: one specimen whose way back was not recorded (default "tell")

---A load frame's record in SI: displacement, force, and time and strain where there are such columns that can be read; rows, names, preamble, file, lines (of the file, of each row), left_out (lines below the rows), specimen where the file names it, warnings (each {code, text, row}: reversed, restart, extensometer, drift, strain-unit, signs; or nil). A file with several specimens (headings that occur again, below or side by side, a column that names the specimen, sheets of a spreadsheet) gives a list of records.
---@param fields fabric_lab_read_fields
---@return table<string, any>
function fabric.lab.read(fields) end

---@class fabric_lab_reduce_fields
---@field displacement number[] m: of the crosshead
---@field force number[] N: of one length with it
---@field gauge_length number m: between the grips
---@field width number m: of the specimen
---@field thickness number m: of one ply
---@field plies integer layers that bear load: 2 for a sewn loop on two pins
---@field compliance? number m/N: of the frame, elastic (default 0)
---@field slip? number m/N: in the grips over the largest force so far; it does not come back (default 0)
---@field slack? number m: displacement at first contact (default 0)
---@field contact? number N: find the slack: where the force rises above this for good

---Stress and strain from displacement and force (eqs. 3.1, 3.2): returns displacement (of the specimen's end), E, S, slack, area. The specimen's length is gauge_length + slack.
---@param fields fabric_lab_reduce_fields
---@return table<string, any>
function fabric.lab.reduce(fields) end

---@class fabric_lab_rupture_fields.warp
---@field strips table strips pulled until they broke: largest forces (N), records { displacement=, force= }, or results of fabric.lab.tensile (breaks at the jaws count as in ISO 13934-1); or a group of fabric.lab.breaking_strength
---@field width number m: of the strips
---@field tears? table trouser or tongue tears in which these yarns broke: mean forces (N) or records { displacement=, force= }
---@field energy? number J/m: in their place, from elsewhere

---@class fabric_lab_rupture_fields.weft
---@field strips table strips pulled until they broke: largest forces (N), records { displacement=, force= }, or results of fabric.lab.tensile (breaks at the jaws count as in ISO 13934-1); or a group of fabric.lab.breaking_strength
---@field width number m: of the strips
---@field tears? table trouser or tongue tears in which these yarns broke: mean forces (N) or records { displacement=, force= }
---@field energy? number J/m: in their place, from elsewhere

---@class fabric_lab_rupture_fields
---@field card card the fabric
---@field warp? fabric_lab_rupture_fields.warp what was measured on the warp
---@field weft? fabric_lab_rupture_fields.weft the same of the weft
---@field source? string who measured, when (default "")
---@field legs? boolean of woven cards: a virtual trouser tear (some seconds for each family) says what legs take of the work, which is taken out of the energy; false: the energy is twice the mean force (default true)

---From strips pulled to break and tears to a card that breaks. Returns card (with rupture, and its origin in card.provenance), and warp and weft: strength (N/m) and energy (J/m, twice the mean force of the tears after their first quarter, less what legs of a woven card take of it), legs (of that: hysteresis over twice the force, way of the grips per metre of tear, force of a virtual tear with twice the force as energy, over the force, and the band of that, relative), strengths (of the strips that count), left_out (places of breaks at the jaws), tear (N, mean force), modulus (Weibull's, of strips: no part of the card), bands of 95 % for strength, modulus and energy.
---@param fields fabric_lab_rupture_fields
---@return table<string, any>
function fabric.lab.rupture(fields) end

---@class fabric_lab_seam_slippage_fields
---@field card card the fabric
---@field yarn? "warp"|"weft" that is pulled, across the seam (default "warp")
---@field h? number m: size of the elements (default 0.005)
---@field stiffness number N/m^2: of the seam: force per metre of it and metre of opening
---@field opening? number m: ISO 13936-1: at which the force is wanted (default 0.006)
---@field load? number N: ISO 13936-2: at which the opening is wanted (default 120)
---@field width? number m: of the specimen (default 0.1)
---@field length? number m: between the jaws (default 0.1)
---@field jaw? number m: width and depth of the jaws (default 0.025)
---@field rows? integer of the curves, default 40
---@field prepare? function function(analysis), called before each of the two runs

---How far a seam gapes, as in ISO 13936 [iso_13936_1; iso_13936_2]: a specimen with a seam and one without are pulled by jaws in their middle, in static steps. Returns force (N, at which the one with the seam is longer by `opening`; nil: not reached), opening (m, by which it is longer at `load`), sewn and plain (the curves, lists of displacement and force), and analysis.
---@param fields fabric_lab_seam_slippage_fields
---@return table<string, any>
function fabric.lab.seam_slippage(fields) end

---@class fabric_lab_seam_strength_fields
---@field card card the fabric
---@field yarn? "warp"|"weft" that is pulled, across the seam (default "warp")
---@field h? number m: size of the elements (default 0.005)
---@field strength number N/m: of the seam
---@field energy number J/m: that bursting takes, per metre of seam
---@field stiffness? number N/m^2: of the seam, where it gives way
---@field method? "strip"|"grab" ISO 13935-1 or -2 (default "strip")
---@field width? number m: of the specimen; default 50 mm, grab 100 mm
---@field length? number m: between the jaws; default 200 mm, grab 100 mm
---@field jaw? number m: grab: width and depth of the jaws, default 25 mm
---@field ledger_limit? number as for fabric.dynamic (default 0.05)
---@field speed? number m/s: of the grips apart; default: kinetic energy stays a small share of the work
---@field damping? number 1/s: of the masses
---@field rows? integer of the curve, at equal times
---@field out? string folder for curve.csv and the VTK series
---@field prepare? function function(analysis), called before the run: for hooks, records and checkpoints of your own
---@field state? table an empty table to gather the curve in, for `keep` of a:checkpoint in prepare, so that a restart has the rows from before it; without it peaks and means are nil then

---A specimen with a seam across it is pulled until the seam bursts, as in ISO 13935 [iso_13935_1; iso_13935_2]. Returns peak (N, the largest force), elongation (m) there, strength (N/m, over the width of the specimen, or of the jaws), tension (N/m, the largest in the cloth along the pull) and cloth, its share of the strength that the card has in rupture (above 1 the cloth would tear first, which a warning says), curve (a list of time, displacement, force: N, closed: stitches, and the energies of analysis.energy), energy (J), fracture (J), kinetic (kinetic energy over work at the peak), series (VTK), analysis and model.
---@param fields fabric_lab_seam_strength_fields
---@return table<string, any>
function fabric.lab.seam_strength(fields) end

---@class fabric_lab_shear_fields
---@field card card the fabric
---@field E12? number largest shear strain (tensor); default: up to where the card was tested
---@field path? number[] strains visited in turn, as parts of the largest; default {1, -1, 1}
---@field sides? "driven"|"free" driven: all four edges move, the shear is uniform; free: bottom and top alone (default "driven")
---@field cells? integer along an edge (default 3)
---@field steps? integer for the whole history (default 90)
---@field size? number m: of the square (default 0.0254)
---@field thickness? number m: default: the card's
---@field out? string folder for curve.csv and the VTK series square.pvd

---A square in cyclic simple shear, warp along the shear. Returns curve (a list of time, E12, force_x, force_y, S12 from the forces, S12_average, S12_centre, S22_average, S_uncorrected = force_x over area), analysis, model, mesh, E12, volume, and the method mesh_error().
---@param fields fabric_lab_shear_fields
---@return test
function fabric.lab.shear(fields) end

---@class fabric_lab_shear_from_bias_fields
---@field markers table a marker grid, as of fabric.lab.tracks
---@field warp? number degrees: from the x of the markers to the warp (default 45)
---@field force number[] N: at each frame
---@field displacement number[] m: of the crosshead at each frame
---@field gauge_length number m: between the grips
---@field width number m: of the specimen
---@field thickness number m: of one ply
---@field plies integer layers that bear load
---@field compliance? number m/N: of the frame (default 0)
---@field slip? number m/N: in the grips (default 0)

---Shear from a bias pull: E (tensor E12 = lambda1 lambda2 cos(phi)/2 over the boxes of zone 3, eq. 3.16) and S (S12 = P/(2 A0 lambda), eq. 3.15) per frame in which that zone is seen (frames), zones of the boxes, warp_stretch, weft_stretch, branches: a test for fabric.lab.fit.
---@param fields fabric_lab_shear_from_bias_fields
---@return table<string, any>
function fabric.lab.shear_from_bias(fields) end

---@class fabric_lab_speckles_fields
---@field file string ends in .png
---@field width integer of the picture, pixels
---@field height integer of the picture, pixels
---@field size? number pixels: of a speckle: deviation of its round blot (default 2)
---@field F? number[] {F11, F12, F21, F22}: the map of the cloth about the middle, y upwards; default: none
---@field shift? number[] pixels: {x, y}, y upwards, after the map
---@field noise? number of a pixel, white being 1 (default 0)
---@field pattern? integer seed of the speckles (default 1)
---@field seed? integer of the noise (default 1)

---Makes a photograph of speckled cloth under a known map, exact at every place: for trying the correlation. Needs the part photographs.
---@param fields fabric_lab_speckles_fields
---@return table<string, any>
function fabric.lab.speckles(fields) end

---@class fabric_lab_spread_fields
---@field tests table three specimens and more: results of fabric.lab.tensile or shear_from_bias
---@field fit? table result of fabric.lab.fit of these tests: strains count from the first contact that it found
---@field level? number of confidence (default 0.95)
---@field points? integer bins of strain, equally wide (default 50)

---How specimens differ in virgin loading: E, S (mean), deviation (of one specimen), low and high (band of the mean), next_low and next_high (band in which the next specimen lies), left_out (of each specimen the part of its points in the band of the others), least_like (that with the smallest part: specimen, E, S, low and high of the others' band), coverage (their mean), unlike (specimens that the others do not explain: specimen, ratio to them, their deviation), reach, text.
---@param fields fabric_lab_spread_fields
---@return table<string, any>
function fabric.lab.spread(fields) end

---@class fabric_lab_strip_rupture_fields
---@field card card the fabric, with rupture
---@field yarn? "warp"|"weft" that is pulled (default "warp")
---@field width? number m: of the specimen (default 0.05)
---@field length? number m: between the jaws (default 0.2)
---@field h? number m: size of the elements (default 0.005)
---@field ledger_limit? number as for fabric.dynamic (default 0.05)
---@field speed? number m/s: of the grips apart; default: kinetic energy stays a small share of the work
---@field damping? number 1/s: of the masses
---@field coarse? "lower"|"refuse"|"keep" as for model:tearable (default "keep")
---@field seed? integer of the scatter of strengths (default 1)
---@field rows? integer of the curve, at equal times
---@field out? string folder for curve.csv and the VTK series
---@field prepare? function function(analysis), called before the run: for hooks, records and checkpoints of your own
---@field state? table an empty table to gather the curve in, for `keep` of a:checkpoint in prepare, so that a restart has the rows from before it; without it peaks and means are nil then

---A strip is pulled until it breaks, as in ISO 13934-1 [iso_13934_1]. Yarns whose strength scatters break where they are weakest, others in the middle. Returns peak (N, the largest force), elongation (m) and strain there, strength (N/m), curve (a list of time, displacement, force: N, work over way from row to row, open: joints, and the energies of analysis.energy), energy (J, of the whole record), fracture (J), kinetic (kinetic energy over work at the peak), series (VTK), analysis, model and mesh. There are no peaks to take a mean of.
---@param fields fabric_lab_strip_rupture_fields
---@return table<string, any>
function fabric.lab.strip_rupture(fields) end

---The quantile of Student's t distribution.
---@param probability number of values below it
---@param freedom number degrees of freedom
---@return table<string, any>
function fabric.lab.student(probability, freedom) end

---@class fabric_lab_synthetic_fields
---@field card card the card whose tests are made
---@field direction? "warp"|"weft"|"bias" of the pull (default "warp")
---@field specimens? integer replicates (default 5)
---@field seed? integer of all that is random (default 1)
---@field rows? integer of the record on the way up (default 300)
---@field reach? number largest strain; default: as tested
---@field slip? number m/N: in the grips (default 0)
---@field compliance? number m/N: of the frame (default 0)
---@field markers? number[] {rows, columns}; default {5, 4}
---@field photographs? integer over the whole test (default 60)
---@field gauge_length? number m: between the grips (default 0.0762)
---@field width? number m: of the specimen (default 0.0254)
---@field thickness? number m: default: the card's
---@field plies? integer layers that bear load (default 2)

---Pulls of a card's cloth as a laboratory would have recorded them: a list of specimens {record={displacement, force}, photographs={markers, force, displacement, warp}}.
---@param fields fabric_lab_synthetic_fields
---@return table[]
function fabric.lab.synthetic(fields) end

---@class fabric_lab_tear_fields
---@field card card the fabric, with rupture
---@field method? "trouser"|"tongue"|"wing"|"trapezoid" ISO 13937-2, ASTM D2261, ISO 13937-3, ASTM D5587 (default "trouser")
---@field along? "warp"|"weft" yarns along which the tear runs: the others break (default "warp")
---@field h? number m: size of the elements along the tear, at most (default 0.003)
---@field width? number m: of the specimen, for a trapezoid along the tear; default: the standard's
---@field leg? number m: trouser, tongue, wing: from jaw to tip along the cut; default: half of the standard's gauge length, for a wing at right angles to the grip
---@field short? number m: trapezoid: the short side; default: the standard's
---@field long? number m: trapezoid: the long side; default: the standard's
---@field cut? number m: trapezoid: length of the cut; default: the standard's
---@field tear? number m: how far it is torn; default: 50 mm
---@field ledger_limit? number as for fabric.dynamic (default 0.05)
---@field speed? number m/s: of the grips apart; default: kinetic energy stays a small share of the work
---@field damping? number 1/s: of the masses
---@field coarse? "lower"|"refuse"|"keep" as for model:tearable
---@field seed? integer of the scatter of strengths (default 1)
---@field rows? integer of the curve, at equal times
---@field out? string folder for curve.csv and the VTK series
---@field prepare? function function(analysis), called before the run: for hooks, records and checkpoints of your own
---@field state? table an empty table to gather the curve in, for `keep` of a:checkpoint in prepare, so that a restart has the rows from before it; without it peaks and means are nil then

---A cut specimen is torn on: trouser [iso_13937_2], tongue (single rip) [astm_d2261], wing [iso_13937_3] or trapezoid [astm_d5587]; a membrane whose yarns break on the line of the cut. Returns mean (N, the work over the way of the grips after the first quarter of the tear), band ({low, high} of 95 % of that mean, from the scatter over the tear; nil of a short one), balance (where that work went, J per metre of tear: fracture, hysteresis, damping, stored, kinetic, together work; way of the grips per metre of tear; torn, m), expected (N, the energy of breaking and the other parts of the balance, over the way), rigid (N, half of the energy, for a wing over sin 55: with legs that neither stretch nor dissipate; not for a trapezoid), mean_of_peaks (N, as the standard takes it; nil where the record has no peaks), peaks, peak (N), curve (a list of time, displacement, force: N, work over way from row to row, torn: m, open: joints, and the energies of analysis.energy), energy (J), fracture (J), kinetic (kinetic energy over work at the peak), series (VTK), analysis, model and mesh.
---@param fields fabric_lab_tear_fields
---@return table<string, any>
function fabric.lab.tear(fields) end

---@class fabric_lab_tensile_fields
---@field file? string of the load frame
---@field record? table {displacement=, force=} in SI, or a list of such, instead of a file
---@field columns? table as in fabric.lab.read
---@field units? table as in fabric.lab.read
---@field default_units? table as in fabric.lab.read
---@field vocabulary? string|table as in fabric.lab.read
---@field thousands? "auto"|"."|","|"none" as in fabric.lab.read (default "auto")
---@field reverse? "none"|"both"|"displacement"|"force" as in fabric.lab.read (default "none")
---@field restarts? "tell"|"specimens"|"cycles" as in fabric.lab.read; a record of the deck's own stays one specimen (default "tell")
---@field gauge_length number m: between the grips
---@field width number m: of the specimen
---@field thickness number m: of one ply
---@field plies integer layers that bear load: 1, or 2 for a sewn loop on two pins
---@field compliance? number m/N: of frame and load cell (default 0)
---@field slip? number m/N: in the grips, over the largest force so far (default 0)
---@field zero? boolean displacement and force of the first row are taken off: a crosshead's position, an offset of the load cell (default false)
---@field pretension? number N: the pretension of a standard: a record may begin with a force up to this
---@field slack? number|"none"|"contact" m: displacement at first contact, or 'contact': found where the force rises above `contact` (default "none")
---@field contact? number N: default 1 % of the largest force
---@field tolerance? number m: smallest way back that is a reversal; default 1 % of the largest displacement
---@field kept? number failed below this part of the peak, if the force stays there (default 0.8)
---@field from_jaw? number|number[] m: where the specimen broke: distance from the nearer jaw, a number for each specimen; within 5 mm it is a break at the jaw
---@field outliers? "tell"|"drop"|"keep" single outlying readings of the force (a display that drops a digit). tell: left out with a warning; drop: left out silently; keep: kept (default "tell")

---A pull as stress and strain (eqs. 3.1, 3.2): E, S, displacement, force, time, branches (kind, first, last), loading (first and last row of virgin loading), yield and failure (rows or nil, on the virgin loading of all cycles), slack, area, outliers (places in the record of what was left out, or nil), warnings (preload, slip in the jaws, a late grip, a break at the jaw, and what fabric.lab.read tells: each {code, text, row}; or nil), extensometer (the row at which it was taken off: the lists end there, and beyond={force, time} has all rows; or nil), from_jaw and jaw (whether it broke at one). A file with several specimens gives a list of tests, each with its specimen.
---@param fields fabric_lab_tensile_fields
---@return table<string, any>
function fabric.lab.tensile(fields) end

---@class fabric_lab_tension_field_fields
---@field card card a card of the woven law, or an elastic one

---A card whose cloth folds without any force where it is shortened, in whatever direction: `folds="free"`. In tension nothing changes.
---@param fields fabric_lab_tension_field_fields
---@return card
function fabric.lab.tension_field(fields) end

---@class fabric_lab_track_fields.region
---@field left? integer first column, from 0 at the left
---@field top? integer first row, from 0 at the top
---@field right? integer column behind the last
---@field bottom? integer row below the last

---@class fabric_lab_track_fields.known
---@field from integer a marker
---@field to integer another
---@field distance number m: between them on the first photograph

---@class fabric_lab_track_fields
---@field files table photographs in order: PNG, JPEG, TIFF or BMP
---@field rows integer of dots, following each other along the pull (y)
---@field columns integer of dots, across
---@field region? fabric_lab_track_fields.region pixels of the photograph, as picture viewers count them; default: all
---@field scale? number m: of a pixel
---@field known? fabric_lab_track_fields.known a known distance, instead of the scale
---@field dark? boolean dots on lighter cloth (default true)
---@field largest? number area of a dot, pixels (default 1e+05)
---@field contrast? number least, black on white being 1 (default 0.1)

---Follows a grid of dots through photographs: rows, columns, frames, x, y (m, or pixels without a scale; y upwards; nan: lost), scale, doubtful = { {frame, marker, lost}, ... }; lost ones are looked for again. Needs the part photographs.
---@param fields fabric_lab_track_fields
---@return table<string, any>
function fabric.lab.track(fields) end

---@class fabric_lab_tracks_fields
---@field file string a table with columns frame, marker (from 1, row by row), x, y
---@field rows integer of markers, following each other along the pull
---@field columns integer of markers, across the pull

---Positions of a marker grid in a series of photographs: rows, columns, frames, their numbers in order, x, y; a marker without a row is lost (nan).
---@param fields fabric_lab_tracks_fields
---@return table<string, any>
function fabric.lab.tracks(fields) end

---@class fabric_lab_twist_fields
---@field warp number|number[] N.m: rigidity of the strip along the warp, or of each of several strips; with areal_mass its bending length, m
---@field weft number|number[] N.m: likewise
---@field bias? number|number[] N.m: likewise, of the strip at 45 degrees; without it the twist is assumed, half of the geometric mean of warp and weft
---@field areal_mass? number kg/m^2: then the three are bending lengths c, B = 9.80665 areal_mass c^3
---@field simulate? boolean fits the twist until a simulated cantilever of that width shows the bias; takes some seconds (default false)
---@field width? number m: of the strips (default 0.025)
---@field common? number relative standard uncertainty of all rigidities together: areal mass, angle of the plane (default 0)
---@field level? number of confidence (default 0.95)

---The twisting rigidity of cloth from cantilevers in three directions: that of a sheet bent to a cylinder, bias = (warp + weft) / 4 + twist. Returns bending (warp, weft, twist, N.m, as cards take it), bias (what that shows, N.m), reached (false where the twist would have to be zero or less; nil without bias), strips (how many along each) and words; with two strips and more along each also band {low, high, covariance, level} of the three, by Student's t. fabric.lab.card takes the result as bending=.
---@param fields fabric_lab_twist_fields
---@return table<string, any>
function fabric.lab.twist(fields) end

---@class fabric_lab_uniaxial_fields.grips
---@field lateral number N/m^2: stiffness across, per metre of edge

---@class fabric_lab_uniaxial_fields
---@field card card the fabric
---@field direction? number|"warp"|"weft" degrees: of the pull: warp, weft, or its angle from the warp (default "warp")
---@field displacement? number m: largest displacement; default: up to where the card was tested
---@field grips? "clamped"|"free"|fabric_lab_uniaxial_fields.grips clamped ends keep their width, free ends contract, {lateral=k}: springs across, k in N/m per metre of edge (default "clamped")
---@field path? number[] displacements visited in turn, as parts of the largest; default {1, 0}
---@field unload? boolean without a path: back again (default true)
---@field unilateral? boolean the grip lets go where the pull is zero; false: it pushes beyond that (default true)
---@field out_of_plane? "held"|"free" free: the strip, bowed by a tenth of its thickness, may buckle (default "held")
---@field stabilise? number|boolean as for fabric.static: a buckling strip needs it (default false)
---@field cells? number[] {across, along}; default {3, 9}
---@field steps? integer for the whole history (default 80)
---@field rows? integer of the curve, at equal times, besides the first; default: one for each step
---@field tolerance? number as for fabric.static (default 1e-10)
---@field max_iterations? integer as for fabric.static (default 200)
---@field max_cuts? integer as for fabric.static (default 12)
---@field method? "newton"|"relaxation"|"either" as for fabric.static (default "newton")
---@field width? number m: of the strip (default 0.0254)
---@field length? number m: between the grips (default 0.0762)
---@field thickness? number m: default: the card's
---@field yarns? "eased"|"full" as for fabric.model (default "eased")
---@field out? string folder for curve.csv and the VTK series strip.pvd

---A strip pulled and let go. Returns curve (a list of time, displacement, force, E, S = force over area, E_lateral, and E and S along the pull as _average over the elements and at the _centre, E12_average, E12_centre, S12_centre), peak (its row of largest displacement), zones (element numbers of the bias test's three zones), analysis, model, mesh, displacement, volume, and the method mesh_error().
---@param fields fabric_lab_uniaxial_fields
---@return test
function fabric.lab.uniaxial(fields) end

---@class fabric_lab_unloading_fields
---@field E number[] strains from the first row after a reversal
---@field S number[] Pa: stresses
---@field rule? "first"|"robust" first: line through the first points; robust: median slope of more of them (default "first")
---@field count? integer of first points (default 3)
---@field kept? number robust: points above this part of the first stress (default 0.7)

---The unloading modulus in Pa; nothing when there are too few points.
---@param fields fabric_lab_unloading_fields
---@return number
function fabric.lab.unloading(fields) end

---@class fabric_lab_viscous_fields
---@field tests table in shear, at several speeds or with holds: { {E=, S=, time=, name=}, ... } (E12, S12 in Pa, s), or bias pulls {displacement=, force=, width=, length=, time=} whose yarns do not stretch; speed= (m/s, of the crosshead) with displacement in place of the time
---@field thickness? number m: of the cloth, for bias pulls
---@field time? number s: known from elsewhere; default: found
---@field scatter? number relative deviation of one specimen; default: found where three and more were tested at speeds that repeat, else 0.04
---@field knots? integer intervals of the elastic curve (default 10)
---@field limit? number degrees: shear angle up to which rows count (default 30)
---@field level? number of confidence (default 0.95)

---The part of shear that relaxes (viscous of a card) from tests at several speeds or with holds: viscous {shear {modulus, time}} or nil where the tests do not tell it, modulus, time, low and high {modulus, time, viscosity} (by the profile of the sum of squares), open_below, open_above (the time is not determined), contradicts (the faster is the softer), speed {ratio, low, high, decades}, ratio {angle, E, ratio, low, high} (the fastest over the slowest against the angle), withheld (the conclusion depends on the angles that are used: none is drawn), by_limit ({limit, verdict}, ...), elastic {E, S}, shear (for fabric.lab.card), scatter, rms, profile, reason, text.
---@param fields fabric_lab_viscous_fields
---@return table<string, any>
function fabric.lab.viscous(fields) end

---@class fabric_lab_wear_fields
---@field analysis analysis a run of cloth on a body, as fabric.lab.dress leaves it
---@field body body of facets (fabric.rigid.limb, torso, surface, motion)
---@field mesh mesh of its facets at time 0, whose sets name its regions
---@field times number[] s: {begins, ends of the cycles of motion}
---@field regions? table names of sets of the mesh; default: all of its sets
---@field window? number s: over which pressures are means; default: a fortieth of a cycle
---@field samples? integer readings in a window (default 8)
---@field patch? number m: radius of the discs of skin over which peaks are means (default 0.02)
---@field state? table an empty table to gather in, for `keep` of a:checkpoint, so that a restart goes on with it
---@field out? string folder for pressure.csv, worn.pvd (cloth and body, with the pressure on it) and worn.txt

---Effects of worn cloth on the body and its wearer: runs through the times and returns regions (of each name, and of all: mean, Pa, the largest of its mean pressures over time, usual, their mean over time, peak, the largest over a disc of skin, peak_at, m, its middle on the body at time 0, touched, the largest share of its area), map (mean and largest of each vertex, Pa), rows (the mean pressures over time), cycles (of each: work, J, that moves the body, supports and loads did, and what became of it: cloth, what the law of the cloth dissipated, friction, damping, impact, fracture, stored, kinetic), slip (m, on the skin: largest and its node, mean, nodes), tension (warp, weft: value, N/m, element, time), beyond (strain over the tested strain of the card), compressed (how much shorter yarns get: value, element, time, folded: the part that folds within the element took; from 1 % on, where a finer mesh would fold, a warning says so), gives_way (whether the yarns of the card carry next to nothing then, or folds within elements took it), gap, ledger, and text, all of this in words.
---@param fields fabric_lab_wear_fields
---@return table<string, any>
function fabric.lab.wear(fields) end

---Cases for fabric.study{ sample= } by Latin hypercube sampling [mckay1979]: each input has one value in each of n equally probable parts of its range.
---@param inputs table { name={low, high} or {mean=, deviation=}, ..., n=cases, seed=1 }: uniform or normal inputs by name
---@return any
function fabric.latin_hypercube(inputs) end

---@class fabric_linear_fields.bending.friction_warp
---@field moment number N: friction moment per width
---@field curvature number 1/m: curvature over which it builds up
---@field memory? "slip"|"fading" slip: the friction moment grows linearly until it slips; fading: it approaches its limit exponentially over that curvature (default "slip")

---@class fabric_linear_fields.bending.friction_weft
---@field moment number N: friction moment per width
---@field curvature number 1/m: curvature over which it builds up
---@field memory? "slip"|"fading" slip: the friction moment grows linearly until it slips; fading: it approaches its limit exponentially over that curvature (default "slip")

---@class fabric_linear_fields.bending
---@field warp number|number[]|table N.m: bending rigidity along the warp: a number, or as it changes with the curvature k, B = b0 + b1 k + ..., {b0, b1, ...}, or measured points {{k, M}, ...} of curvature, 1/m, and moment per width, N, from {0, 0} on
---@field weft number|number[]|table N.m: bending rigidity along the weft: a number, or as it changes with the curvature k, B = b0 + b1 k + ..., {b0, b1, ...}, or measured points {{k, M}, ...} of curvature, 1/m, and moment per width, N, from {0, 0} on
---@field twist number N.m: twisting rigidity, multiplies 2 kappa12
---@field friction_warp? fabric_linear_fields.bending.friction_warp bending hysteresis along the warp
---@field friction_weft? fabric_linear_fields.bending.friction_weft bending hysteresis along the weft
---@field tested? number 1/m: curvature up to which the rigidities were measured: beyond it they are constant; 0: not stated (default 0)

---@class fabric_linear_fields.estimate.bending.friction_warp
---@field moment number N: friction moment per width
---@field curvature number 1/m: curvature over which it builds up
---@field memory? "slip"|"fading" slip: the friction moment grows linearly until it slips; fading: it approaches its limit exponentially over that curvature (default "slip")

---@class fabric_linear_fields.estimate.bending.friction_weft
---@field moment number N: friction moment per width
---@field curvature number 1/m: curvature over which it builds up
---@field memory? "slip"|"fading" slip: the friction moment grows linearly until it slips; fading: it approaches its limit exponentially over that curvature (default "slip")

---@class fabric_linear_fields.estimate.bending
---@field warp number|number[]|table N.m: bending rigidity along the warp: a number, or as it changes with the curvature k, B = b0 + b1 k + ..., {b0, b1, ...}, or measured points {{k, M}, ...} of curvature, 1/m, and moment per width, N, from {0, 0} on
---@field weft number|number[]|table N.m: bending rigidity along the weft: a number, or as it changes with the curvature k, B = b0 + b1 k + ..., {b0, b1, ...}, or measured points {{k, M}, ...} of curvature, 1/m, and moment per width, N, from {0, 0} on
---@field twist number N.m: twisting rigidity, multiplies 2 kappa12
---@field friction_warp? fabric_linear_fields.estimate.bending.friction_warp bending hysteresis along the warp
---@field friction_weft? fabric_linear_fields.estimate.bending.friction_weft bending hysteresis along the weft
---@field tested? number 1/m: curvature up to which the rigidities were measured: beyond it they are constant; 0: not stated (default 0)

---@class fabric_linear_fields.estimate
---@field bending fabric_linear_fields.estimate.bending of the bending
---@field source string where the estimate comes from

---@class fabric_linear_fields.rupture.warp.scatter
---@field modulus number Weibull modulus of the strength; the larger, the less it scatters
---@field length? number m: length of yarn at which the strength was measured; without it strength does not depend on length
---@field exponent? number strength goes with length^-exponent; default 1 / modulus, the weakest link

---@class fabric_linear_fields.rupture.warp
---@field strength number N/m: mean force per width at which these yarns break
---@field energy number J/m: energy that breaking these yarns takes, per metre of the tear
---@field scatter? fabric_linear_fields.rupture.warp.scatter how the strength differs from place to place
---@field yarns? number 1/m: yarns per metre of the line on which they break; with scatter each yarn has a strength of its own, and a place of the mesh the mean of its yarns

---@class fabric_linear_fields.rupture.weft.scatter
---@field modulus number Weibull modulus of the strength; the larger, the less it scatters
---@field length? number m: length of yarn at which the strength was measured; without it strength does not depend on length
---@field exponent? number strength goes with length^-exponent; default 1 / modulus, the weakest link

---@class fabric_linear_fields.rupture.weft
---@field strength number N/m: mean force per width at which these yarns break
---@field energy number J/m: energy that breaking these yarns takes, per metre of the tear
---@field scatter? fabric_linear_fields.rupture.weft.scatter how the strength differs from place to place
---@field yarns? number 1/m: yarns per metre of the line on which they break; with scatter each yarn has a strength of its own, and a place of the mesh the mean of its yarns

---@class fabric_linear_fields.rupture
---@field warp? fabric_linear_fields.rupture.warp breaking of the warp yarns; without it they hold
---@field weft? fabric_linear_fields.rupture.weft breaking of the weft yarns; without it they hold

---@class fabric_linear_fields
---@field name? string of the fabric (default "")
---@field source? string where the numbers come from (default "")
---@field density number kg/m^3: mass over volume
---@field thickness number m: of the sheet
---@field bending? fabric_linear_fields.bending own bending rigidity instead of integration through the thickness
---@field provenance? table where values come from: {['warp.loading']='fitted to 4 specimens', ['shear.unloading']='assumed: ...'}; words begin with fitted, measured, copied, typed or assumed
---@field ranges? table where assumed numbers may lie, for fabric.budget: {['warp.poisson']={0.1, 0.6}, ['warp.loading']={0.5, 2}}; Poisson's ratios as they are, others as factors
---@field through_thickness? boolean bending by integration through the thickness is intended where the card has no bending of its own: no warning, even if that is far stiffer than cloth (default false)
---@field estimate? fabric_linear_fields.estimate estimates of what was not measured, used by fabric.card(name, { bending='estimated' })
---@field compression? table one sheet pressed between two plates, {{gap, pressure}, ...}: gap, m, is its thickness then, which is also how far apart the middles of two such sheets are, pressure in Pa; what contact presses with
---@field fibre_density? number kg/m^3: of what the yarns are made of; areal mass over it is how thin the sheet can be pressed at most; default 1500 (cotton 1540, polyester 1380)
---@field folds? "resolved"|"within elements"|"free" where compressed cloth folds: resolved, in the shape of the mesh alone; within elements too, which then carry no more than folds of their size would; or free, the same without any force (default "resolved")
---@field rupture? fabric_linear_fields.rupture where yarns break: in tearable zones of a model, see model:tearable
---@field warp number Pa: modulus along the warp
---@field weft number Pa: modulus along the weft
---@field shear number Pa: engineering shear modulus, S12 = 2 shear E12
---@field poisson number|number[] {nu12, nu21}

---A linear orthotropic sheet for small strains; refused unless nu12/warp = nu21/weft.
---@param fields fabric_linear_fields
---@return card
function fabric.linear(fields) end

---@class fabric_mesh_annulus_fields
---@field inner number m: radius
---@field outer number m: radius
---@field around integer elements along the circle
---@field across integer elements from the inner to the outer circle
---@field angle? number degrees: of the sector, counter-clockwise from +x (default 360)
---@field slit? boolean cut a full ring open at angle 0 (default false)

---A ring or a sector of one in the x-y plane about the origin, normal +z; nodes around first, from the inner circle outward. Sets inner, outer, boundary, all. Below 360 degrees the sets start and end are its two cut edges, at 360 degrees seam is the line at angle 0. A slit ring has start and end too.
---@param fields fabric_mesh_annulus_fields
---@return mesh
function fabric.mesh.annulus(fields) end

---@class fabric_mesh_cylinder_fields
---@field radius number m: of the cylinder
---@field length number m: from z = 0 up
---@field around integer elements along the circle
---@field along integer elements along the axis
---@field angle? number degrees: of the sector, counter-clockwise from +x (default 360)

---A sleeve, or an open shell cut from one, about the z axis, normal outward; nodes around first, from the bottom up. Sets bottom, top, boundary, all. Below 360 degrees the sets start and end are its two cut edges, at 360 degrees seam is the line at angle 0.
---@param fields fabric_mesh_cylinder_fields
---@return mesh
function fabric.mesh.cylinder(fields) end

---@class fabric_mesh_disk_fields
---@field radius number m: of the rim
---@field cells integer elements along each side of the square core; the rim has four times as many
---@field rings? integer rings of elements around the core, default half of cells

---A disk of quadrilaterals in the x-y plane about the origin, normal +z: a square core, then rings. Sets boundary (the rim), core, all, and centre when cells is even.
---@param fields fabric_mesh_disk_fields
---@return mesh
function fabric.mesh.disk(fields) end

---@class fabric_mesh_hemisphere_fields
---@field radius number m: of the sphere
---@field hole? number degrees: polar angle at which the cap is cut off (default 18)
---@field around integer elements along the equator
---@field along integer elements from the equator to the hole
---@field angle? number degrees: of the sector, counter-clockwise from +x (default 90)

---The upper half of a sphere about the origin with a hole at the top, or a sector of it, normal outward; nodes around first, from the equator up. Sets bottom (the equator), top (edge of the hole), boundary, all. Below 360 degrees the sets start and end are its two cut edges, at 360 degrees seam is the line at angle 0.
---@param fields fabric_mesh_hemisphere_fields
---@return mesh
function fabric.mesh.hemisphere(fields) end

---@class fabric_mesh_merge_fields
---@field meshes table { a, b, ... }
---@field distance? number m: within which nodes of different meshes become one (default 1e-06)

---Several meshes as one: nodes of different meshes that coincide are joined, sets of one name become one, all and boundary are made anew. The edges that meet need the same nodes.
---@param fields fabric_mesh_merge_fields
---@return mesh
function fabric.mesh.merge(fields) end

---@class fabric_mesh_of_fields
---@field nodes table { {x, y, z}, ... }, m; without z it is 0
---@field elements table { {1, 2, 5, 4}, ... }: node numbers, 3 or 4, counter-clockwise
---@field join? boolean make one node of those at one place (within 1e-6 of the mesh's size) (default false)

---A mesh of your own, from its nodes and elements; also written fabric.mesh{ nodes=, elements= }. Sets all and boundary.
---@param fields fabric_mesh_of_fields
---@return mesh
function fabric.mesh.of(fields) end

---@class fabric_mesh_panel_fields
---@field outline? table { {x, y}, {x, y, name=}, {arc=, name=}, {spline=, name=}, ... }: a start, then pieces, each from where the one before it ends
---@field file? string in place of an outline: a .dxf of a pattern program (AAMA/ASTM), or a .svg
---@field piece? string of the file, if it has several: its name or block
---@field size_name? string of the garment, if the file holds the piece in several: '38'
---@field unit? number m: of the file's lengths (fabric.units.mm), if it does not say
---@field size number m: of an element
---@field grain? number degrees: direction of the warp, counter-clockwise from +x, default 0; wins over the grain line of a file
---@field holes? table { line, ... }: closed lines like the outline
---@field darts? table { {from=, tip=, to=, name=}, ... }: wedges cut from the outline
---@field notches? table { {name=, edge=, at=|share=|point=}, ... }: places that get a node
---@field triangles? boolean equilateral ones, in place of squares (default false)
---@field quadrilaterals? boolean true: no element is a triangle, and each side has an even number of them; false: triangles along the outline where they fit; default: without, where rows oblique to the grain or more than 5 % of the area would have them, unless elements get much narrower or rows= is given
---@field rows? number degrees: direction of the rows of elements, counter-clockwise from +x; default: the grain, or straight sides oblique to it where that leaves less than half as many triangles

---A panel from its outline, in the x-y plane, normal +z: rows of squares along the grain or along sides oblique to it, and a rim of quadrilaterals, and triangles unless these matter, whose border nodes lie on the outline. A piece is a straight line to {x, y}, {arc={to=, through=|centre=, clockwise=}}, {spline={ {x, y}, ... }}, {bezier={c, c, to}}, or {name=}, which closes the line; a line {circle={x, y}, radius=} is a circle; elements= of a piece sets their number. Named edges, the sides NAME_in and NAME_out of darts, and notches become sets; all and boundary as usual. Edges of a file are edge1, edge2, ..., its notches notch1, notch2, .... A model takes the warp from the grain.
---@param fields fabric_mesh_panel_fields
---@return mesh
function fabric.mesh.panel(fields) end

---Reads a mesh of triangles and quadrilaterals; its lengths are m afterwards: Gmsh 2 and 4.1, VTK's .vtu and legacy .vtk, Wavefront .obj, .stl and .ply (text and binary; equal vertices of an .stl are joined), .inp of Abaqus and CalculiX, .k of LS-DYNA, .rad of OpenRadioss' starter. Physical groups and groups become node sets, sets of elements those of their nodes; so do integer arrays: those of 0 and 1 by their name, others as name_value; parts and solids where there are several. Nodes in no element are left out; the sets all and boundary are added. Also with named fields: fabric.mesh.read{ file=, join=true }.
---@param file string ends in .msh, .vtu, .vtk, .obj, .stl, .ply, .inp, .k, .key or .rad; a bare name may be a mesh shipped with the program
---@param join? boolean make one node of those at one place (within 1e-6 of the mesh's size) (default false)
---@param reference? boolean the same mesh in the stress-free shape that an .inp, a .k or a .rad has beside it, for reference= of a model (default false)
---@param units? "m"|"cm"|"mm"|"inch" of the file's lengths; default m, with a warning where that would be odd; none for a .rad whose /BEGIN states them
---@return mesh
function fabric.mesh.read(file, join, reference, units) end

---@class fabric_mesh_rectangle_fields.grading
---@field x? number[] m: of the lines of nodes across x, from 0 to the width, ascending
---@field y? number[] m: of those across y, from 0 to the height

---@class fabric_mesh_rectangle_fields
---@field width number m: size along x
---@field height number m: size along y
---@field nx? integer elements along x; may be left out with grading.x
---@field ny? integer elements along y; may be left out with grading.y
---@field origin? number[] m: corner of smallest x and y, {x, y} or {x, y, z}
---@field grading? fabric_mesh_rectangle_fields.grading positions of the lines of nodes, from the origin corner; without: at equal distances
---@field triangles? boolean cut every cell into two triangles, the cuts turning from cell to cell (default false)

---A structured rectangle in the x-y plane, normal +z, nodes and elements row by row from the origin corner; sets left, right, bottom, top, boundary, corners, all.
---@param fields fabric_mesh_rectangle_fields
---@return mesh
function fabric.mesh.rectangle(fields) end

---@class fabric_model_fields.prestress
---@field warp? number N/m: along the warp (default 0)
---@field weft? number N/m: along the weft (default 0)

---@class fabric_model_fields
---@field mesh? mesh the surface
---@field card? card the fabric
---@field layers? table { {card=, warp=, thickness=, name=}, ... }: plies from below, in place of a card
---@field thickness? number m: replaces the card's; mass per area changes with it
---@field warp? number|function|number[] degrees: warp direction: angle counter-clockwise about the normal from global +x, {x, y, z}, or function(x, y, z) returning either; default: along the grain of a panel, 0 on another flat generated mesh
---@field points? integer integration points through the thickness (default 3)
---@field offset? number reference surface: -1 lower face, 0 middle, 1 upper face (default 0)
---@field reference? mesh the stress-free shape: the same elements with other nodes. Strains, yarns and masses are those of this shape; the mesh is where the run starts
---@field rest? "own"|"flat"|"as placed" where it is free of moments: own, with the curvature of the stress-free shape; flat; or as placed, with that of the mesh (default "own")
---@field prestress? fabric_model_fields.prestress tension at the start, per width of the mesh, by a strain of the law that is printed
---@field regions? table { set = {card=, thickness=, warp=, ...}, ... }: sets of elements with a card or section of their own
---@field bodies? table { {name=, mesh=, card=, regions=, ...}, ... }: several meshes in place of one; their sets are then name.left
---@field membrane? boolean cloth without bending and transverse shear, whose directors are held: for sheets that are taut, or fold more sharply than an element can show (default false)
---@field folds? "resolved"|"within elements"|"free" where compressed cloth folds: resolved, in the shape of the mesh alone; within elements too, which then carry no more compression than folds of their size; free, the same without any force; default: that of each card
---@field yarns? "eased"|"full" eased: the strain of yarns that cross quadrilaterals obliquely varies in an element only as far as shear can hold it, so that stiff yarns do not lock a mesh; full: as interpolated, as in the thesis (default "eased")
---@field imperfection? number m: nodes are moved across the sheet by at most this, in a pattern of waves that is always the same, so that a sheet that is pressed or sheared in its plane can buckle; the mesh of the deck stays as it is

---The declared problem: a mesh of a fabric, or several, to be held, moved and loaded.
---@param fields fabric_model_fields
---@return model
function fabric.model(fields) end

---@class fabric_modes_fields
---@field from? analysis the state about which the cloth swings
---@field model? model in its place: the cloth as it is at time 0, without stress
---@field count? integer how many, from the lowest on (default 10)
---@field below? number Hz: those below this frequency alone; without count all of them

---Natural frequencies of small swings about a state: a list of { frequency= (Hz), mass= {x=, y=, z=} (kg, effective), growth= (1/s, above 0 where the state is unstable), shape=, own_mass= (kg, that of the shape), participation= {x=, y=, z=} (of the shape in a motion of the supports by 1) }. The list's mass= {x=, y=, z=} (kg) is all that can move.
---@param fields fabric_modes_fields
---@return any
function fabric.modes(fields) end

---@class fabric_plot_fields
---@field rows? table in the place of curves: a list of tables, a test with a curve, or a table of lists
---@field x? string with rows: the field along x
---@field y? string|table with rows: the field along y, or a list of fields
---@field curves? table { {x=, y=, label=, style=}, ... }: lists of numbers, a nan being a gap, or {rows=, x="E", y="S"} by the fields of a list of tables; style: line, dashed, points, line_points; error=, xerror=, band={low=, high=}, colour=
---@field title? string above the axes
---@field xlabel? string what x is
---@field ylabel? string what y is
---@field xunit? string of fabric.units, a quotient of two (N/mm, N/5cm), or %: x is SI and shown in it, behind the label
---@field yunit? string likewise
---@field xrange? number[] {low, high} shown, in SI; default: all
---@field yrange? number[] {low, high} shown, in SI; default: all
---@field ynames? table a list of names: what stands at y = 1, 2, ..., in the place of numbers
---@field log? ""|"x"|"y"|"xy" logarithmic axes
---@field key? "best"|"none"|"top left"|"top right"|"bottom left"|"bottom right"|"below"|"right" where the labels of the curves stand; best: the first corner free of curves, else below
---@field file? string ends in .svg, .pdf, .eps or .png; none: drawn in letters
---@field panels? table { {curves=, title=, xlabel=, ...}, ... }: several plots on one page; what a panel does not say is taken from the call
---@field layout? number[] {rows, columns} of the panels; default: two columns
---@field letters? boolean (a), (b), ... above the panels (default true)
---@field size? number[] m: {width, height} of the page; default {85*mm, 60*mm}, a column of a journal; with panels 170 mm wide, 60 mm for a row
---@field font? string a family of letters; default: Helvetica, or what stands for it (default "")
---@field font_size? number points: size of all letters (default 8)
---@field dpi? number pixels of a PNG per inch (default 300)
---@field columns? integer width of a drawing in letters (default 79)
---@field lines? integer height of a drawing in letters (default 24)

---Draws curves (by gnuplot) into a file, or without one returns them as text: the prompt shows it, a deck prints it by print(fabric.plot{...}). fabric.plot(rows, "E", "S", {...}) is short for fabric.plot{ rows=rows, x="E", y="S", ... }. With a file it returns whether it was drawn: false, with a warning, where gnuplot is not installed.
---@param fields fabric_plot_fields
---@return string|boolean|nil
function fabric.plot(fields) end

---One material point of virgin cloth, to be driven by strains.
---@param card card the fabric
---@param size? number m: length of cloth that the point stands for, over which yarns that soften break (see damage of a card); without it they hold
---@return point
function fabric.point(card, size) end

---A table of coefficients times a unit: fabric.poly({8, 826}, MPa).
---@param coefficients number[] ascending powers
---@param unit? number a multiplier of fabric.units (default 1)
---@return number[]
function fabric.poly(coefficients, unit) end

---From 0 to value over the duration, then held.
---@param value number end value
---@param duration number s: time to reach it
---@return history
function fabric.ramp(value, duration) end

---@class fabric_render_fields
---@field file string to write; ends in .png
---@field vtu? string|table file of a:vtk, or a list of them: panels of one scale
---@field run? table|analysis in place of files: the run as it stands, with its rigid bodies, or a list of runs
---@field field? "none"|"displacement"|"ux"|"uy"|"uz"|"velocity"|"vx"|"vy"|"vz"|"nx"|"ny"|"nz"|"position"|"x"|"y"|"z"|"reference"|"X"|"Y"|"Z"|"reaction"|"reaction_x"|"reaction_y"|"reaction_z"|"gap"|"contact_pressure"|"crease_angle"|"joint_open"|"rupture_warp"|"rupture_weft"|"E11"|"E22"|"E23"|"E13"|"E12"|"S11"|"S22"|"S23"|"S13"|"S12"|"residual1"|"residual2"|"slack1"|"slack2"|"folded"|"stored"|"dissipated"|"dissipated_warp"|"dissipated_weft"|"dissipated_shear"|"dissipated_damage"|"shear_angle"|"tension_warp"|"tension_weft"|"nominal_strain_warp"|"nominal_strain_weft"|"nominal_stress_warp"|"nominal_stress_weft"|"cauchy_11"|"cauchy_22"|"cauchy_12"|"beyond"|"region" what the colours show (default "none")
---@field title? string on top (default "")
---@field labels? string|table above the panels
---@field bar? string title of the colour bar; default: the field with its unit (MPa, mm)
---@field factor? number the bar shows that much times the SI value; default: to the unit
---@field range? number[] {low, high} of the bar; default: those of all panels
---@field view? "above"|"front"|"side"|"oblique"|number[] above (from +z, y up), front (along +y), side (along -x), oblique, or {azimuth, elevation} in degrees (default "above")
---@field views? table { 'front', 'side', 'above', 'oblique', {30, 25}, ... }: several views in one picture, in one scale
---@field columns? integer of panels
---@field width? integer pixels (default 1200)
---@field height? integer pixels (default 900)
---@field size? number[] m: {width, height} on paper, in the place of pixels: {85*mm, 60*mm} for a column of a journal
---@field dpi? number with size: pixels per inch (default 300)
---@field font_size? number points: with size: of all letters (default 7)
---@field smooth? boolean colours and shading that change evenly between the nodes; else each element has its own (default false)
---@field edges? boolean of the elements (default true)
---@field fit? boolean the picture is no wider than its one panel needs: for tall things (default false)
---@field bodies? "shown"|"clear"|"none" rigid bodies of a run: clear lets the cloth behind them be seen, none leaves them out, and the picture is as large as the cloth (default "shown")
---@field axes? boolean with a scale, in mm (m from 1.5 m on) (default true)

---Draws deformed sheets with a field and its colour bar into a PNG, off-screen: on the virtual display Xvfb, or where that is not installed on the display of DISPLAY. Returns whether it was drawn: false, with a warning, under --safe.
---@param fields fabric_render_fields
---@return boolean
function fabric.render(fields) end

---@class fabric_rigid_cylinder_fields
---@field radius number m: of the rod
---@field from number[] m: {x, y, z}: one end of its axis
---@field to number[] m: {x, y, z}: the other end
---@field mass? number kg: with it the body moves freely under contact and gravity
---@field name? string for messages and files; default the shape's

---A rigid rod, whose ends are round.
---@param fields fabric_rigid_cylinder_fields
---@return body
function fabric.rigid.cylinder(fields) end

---@class fabric_rigid_die_fields
---@field shape? "hemisphere"|"box"|"double dome"|"L"|"Z" of the punch or of the opening: hemisphere (round), box, double dome; L and Z: profiles along y, whose face ends at x = 0 in a wall (default "hemisphere")
---@field radius? number m: of a hemisphere, a dome or a round opening
---@field size? number[] m: {along x, along y} of a box; of L and Z the width of the lower face and the length of the profile
---@field corner? number m: radius of a box's corners, seen from above
---@field length? number m: from centre to centre of a double dome, along x
---@field waist? number m: radius of the arcs that join both domes
---@field angle? number degrees: of the wall of L and Z from the horizontal, default 90
---@field edge number m: radius of the rounded edge of the opening
---@field height? number m: of the wall of L and Z, which is the depth of the floor of Z; default four times the edge of an L
---@field outer number m: radius of the round outside; of L and Z how far the face goes to -x
---@field facing? "up"|"down" up: the cloth lies on it; down: a blank holder (default "up")
---@field at? number[] {x, y, z}: its lowest point, or the middle of the opening in the face of a die, m; default the origin
---@field around? integer facets around (default 64)
---@field mass? number kg: with it forces and contact move the body
---@field name? string for messages and files; default the shape's

---A plate with an opening for forming, its face at `at`: a die, or facing down a blank holder. shape, radius, size, corner, length and waist are those of the opening. For an L or Z profile a block whose wall goes down from `at`, the sharp corner of its face, of a Z to a floor.
---@param fields fabric_rigid_die_fields
---@return body
function fabric.rigid.die(fields) end

---@class fabric_rigid_disc_fields
---@field radius number m: over all
---@field centre number[] m: {x, y, z}: of the disc
---@field normal number[] {x, y, z}: of its faces
---@field edge number m: radius of its rounded edge: half of its thickness
---@field mass? number kg: with it the body moves freely under contact and gravity
---@field name? string for messages and files; default the shape's

---A rigid flat disc with a rounded edge, such as the pedestal of a drape tester.
---@param fields fabric_rigid_disc_fields
---@return body
function fabric.rigid.disc(fields) end

---@class fabric_rigid_dome_fields
---@field radius number m: of the dome, or of both
---@field length? number m: from centre to centre along x; without it a hemisphere
---@field waist? number m: radius of the arcs that join both domes; default the radius
---@field at? number[] {x, y, z}: its lowest point, m; default the origin
---@field around? integer facets around (default 64)
---@field mass? number kg: with it forces and contact move the body
---@field name? string for messages and files; default the shape's

---A dome or a double dome as a punch: fabric.rigid.punch of these shapes.
---@param fields fabric_rigid_dome_fields
---@return body
function fabric.rigid.dome(fields) end

---@class fabric_rigid_limb_fields
---@field upper number m: length of the first part, up to the middle of the joint
---@field lower number m: length of the second part
---@field radii number[] m: {beginning, joint, end}
---@field bend? number|function|history degrees: of the joint, up to 150: a number, or a history or function(t), which is followed (default 0)
---@field duration? number s: over which bend= is followed; afterwards it stays
---@field every? number s: time between two shapes, between which points go straight; default: what turns by 3 degrees
---@field joint? number m: length of the middle line that bends, to an arc; default 2.2 of its radius, enough for 119 degrees
---@field from? number[] {x, y, z}: where the middle line begins, m, default the origin
---@field axis? number[] {x, y, z}: direction of the first part, default {0, 0, 1}
---@field towards? number[] {x, y, z}: where the second part bends to, default {1, 0, 0}
---@field around? integer facets around, a multiple of 4 (default 32)
---@field size? number m: of facets along the limb; default: as around the joint
---@field name? string for messages and files; default the shape's

---An arm, a leg or a finger: two tapered round parts with a joint that bends, closed, with round ends. Returns a rigid body, which stands (and m:move may move it) where bend is a number, and the list of the meshes of its shapes, whose sets are upper, joint, lower, joint_inner and joint_outer.
---@param fields fabric_rigid_limb_fields
---@return body
function fabric.rigid.limb(fields) end

---@class fabric_rigid_motion_fields
---@field files? table { 'file', ... }: mesh files with the same facets at other places
---@field meshes? table { mesh, ... }: in their place
---@field times number[] s: at which it has these shapes, ascending
---@field closed? boolean the surface bounds a solid in every shape; a hole in it is an error, and cloth may not start inside (default false)
---@field name? string for messages and files; default the shape's

---A rigid surface that moves from shape to shape, each vertex in straight lines; before the first time and after the last it is at rest. Friction acts with the speed of the surface where it touches.
---@param fields fabric_rigid_motion_fields
---@return body
function fabric.rigid.motion(fields) end

---@class fabric_rigid_plane_fields
---@field point number[] m: {x, y, z}: of the plane
---@field normal number[] {x, y, z}: out of the solid, towards the cloth
---@field name? string for messages and files; default the shape's

---A rigid plane: all that lies behind it is solid.
---@param fields fabric_rigid_plane_fields
---@return body
function fabric.rigid.plane(fields) end

---@class fabric_rigid_punch_fields
---@field shape? "hemisphere"|"box"|"double dome"|"L"|"Z" of the punch or of the opening: hemisphere (round), box, double dome; L and Z: profiles along y, whose face ends at x = 0 in a wall (default "hemisphere")
---@field radius? number m: of a hemisphere, a dome or a round opening
---@field size? number[] m: {along x, along y} of a box; of L and Z the width of the lower face and the length of the profile
---@field corner? number m: radius of a box's corners, seen from above
---@field length? number m: from centre to centre of a double dome, along x
---@field waist? number m: radius of the arcs that join both domes
---@field angle? number degrees: of the wall of L and Z from the horizontal, default 90
---@field edge? number m: radius of the lower edge of a box, of the edges of L and Z
---@field height? number m: of a box; of the shaft of a hemisphere; of the wall of L and Z; default the shorter side, the radius, the width of an L
---@field at? number[] {x, y, z}: its lowest point, or the middle of the opening in the face of a die, m; default the origin
---@field around? integer facets around (default 64)
---@field mass? number kg: with it forces and contact move the body
---@field name? string for messages and files; default the shape's

---A punch for forming, its lowest point at `at`: a hemisphere with its shaft (a rod, round without facets), a box with radii, a double dome, or a block whose wall forms an L or, with its upper face, a Z profile along y; there `at` is the sharp corner of lower face and wall.
---@param fields fabric_rigid_punch_fields
---@return body
function fabric.rigid.punch(fields) end

---@class fabric_rigid_sphere_fields
---@field radius number m: of the ball
---@field centre number[] m: {x, y, z}: at time 0
---@field mass? number kg: with it the body moves freely under contact and gravity
---@field name? string for messages and files; default the shape's

---A rigid ball that cloth may touch: fixed, moved (m:move), or free, with a mass.
---@param fields fabric_rigid_sphere_fields
---@return body
function fabric.rigid.sphere(fields) end

---@class fabric_rigid_surface_fields
---@field mesh? mesh its facets, counter-clockwise from outside
---@field file? string a mesh file in its place
---@field closed? boolean the surface bounds a solid; a hole in it is an error (default false)
---@field mass? number kg: with it the body moves freely under contact and gravity
---@field name? string for messages and files; default the shape's

---A rigid surface of triangles, each counted once; quadrilaterals are cut along their shorter diagonal, vertices of free edges at one place are one, what looks inwards of a closed one is turned.
---@param fields fabric_rigid_surface_fields
---@return body
function fabric.rigid.surface(fields) end

---@class fabric_rigid_torso_fields
---@field sections table { {height, half width, half depth}, ... }, m: half axes of ellipses along the axis, from the lowest on
---@field from? number[] {x, y, z}: where the height is 0, m, default the origin
---@field axis? number[] {x, y, z}: direction of heights, default {0, 0, 1}
---@field towards? number[] {x, y, z}: direction of widths, default {1, 0, 0}
---@field around? integer facets around (default 48)
---@field size? number m: of facets along the axis; default: as around the smaller half axis of the first section
---@field name? string for messages and files; default the shape's

---A trunk, hips, a leg that stays straight or a dress form: a closed surface through elliptical sections, smooth and without bulges between them, with round ends. Returns a rigid body, which stands (and m:move may move it), and its mesh.
---@param fields fabric_rigid_torso_fields
---@return body
function fabric.rigid.torso(fields) end

---@class fabric_show_fields.options
---@field rows? integer at most, from the beginning and the end (default 40)
---@field columns? table names, in their order; default: all, in the order of a file, else by the alphabet

---Prints rows as a table under their names.
---@param rows table of a test, a record, or a fabric.table; or lists of equal length with names
---@param options? fabric_show_fields.options what to show
---@return any
function fabric.show(rows, options) end

---Cases for fabric.study{ sample= } at the points of Sobol's sequence [joe2008]: a list of { name=value }. Means over n such cases are closer than over n random ones; best with n a power of 2.
---@param inputs table { name={low, high} or {mean=, deviation=}, ..., n=cases, seed=1 }: uniform or normal inputs by name; seed 0: the sequence as it is, others shift it
---@return any
function fabric.sobol(inputs) end

---@class fabric_static_fields
---@field model? model what is computed; with from= that of the other run unless given
---@field duration number s: time to run, from 0 or from the other run's time
---@field step? number s: largest step; default duration/20
---@field tolerance? number residual over the largest nodal force (default 1e-10)
---@field max_iterations? integer of one step, before it is cut (default 200)
---@field max_cuts? integer halvings of one step, before the run gives up (default 12)
---@field line_search? boolean only steps that lower the energy, but for a few on trial (default true)
---@field ledger_limit? number the run stops when cloth stores more than loads and supports can have given it, by this part of the external work (default 0.05)
---@field min_step? number s: smallest step that cuts go down to
---@field linear? "auto"|"symmetric"|"unsymmetric" direct solver: auto (symmetric where law and loads are), symmetric, unsymmetric (default "auto")
---@field control? "load"|"arc" load: steps in time; arc: steps along the path, past limit points, where time may go down (default "load")
---@field method? "newton"|"relaxation"|"either"|"auto" auto: Newton's method, and where it is slow an overdamped motion and relaxation, in turn; newton: that alone; relaxation: every step by dynamic relaxation, of cloth with bending of its own by an overdamped motion; either: relaxation for steps in which Newton fails (default "auto")
---@field limit? "tell"|"stop" tell: warns once when the cloth is strained beyond what the card was tested to (2 % are let pass); stop: ends the run there, on the strain, however long the steps (default "tell")
---@field path? number error of a run by the length of its steps, where laws remember their path, over the largest displacement or force: each step is compared with two halves and cut; without it some are, and a warning says so
---@field stabilise? number|boolean viscous forces on the nodes that lose this fraction of a step's work; true: 2e-4
---@field from? analysis a run of the same cloth, whose state and time this one begins with
---@field release? number s: with from=: over which the forces of what no longer holds the cloth are taken away; default at once

---A quasi-static run: Newton's method through the histories' time.
---@param fields fabric_static_fields
---@return analysis
function fabric.static(fields) end

---@class fabric_study_fields
---@field parameters? table { name={values}, ... }: every combination; or { {name=value, ...}, ... }: these cases
---@field sample? table instead: the cases of fabric.sobol or fabric.latin_hypercube
---@field run function run(p), p.name being the values of a case, returns a table of named numbers, strings, true or false
---@field folder? string where each finished case is kept, and study.csv when all are (default "out/study")
---@field workers? integer cases side by side, each in a process with one thread; default: the threads that the program may use
---@field again? boolean runs cases again that failed before (default false)

---Runs a function for many sets of parameters in parallel processes. Finished cases are kept and not run again when the deck is run again; a case that fails leaves its message and does not stop the others. As a task of a Slurm array job it runs its share; fabricsh --cases deck.lua lists the cases, --case K runs one of them. Returns the cases in order, each {parameters, values, warnings, trouble} (warnings as analysis.warnings has them, of all runs of the case), with complete, missing, failed, file (the table as CSV), parameters and results (names).
---@param fields fabric_study_fields
---@return table
function fabric.study(fields) end

---@class fabric_svk_fields.bending.friction_warp
---@field moment number N: friction moment per width
---@field curvature number 1/m: curvature over which it builds up
---@field memory? "slip"|"fading" slip: the friction moment grows linearly until it slips; fading: it approaches its limit exponentially over that curvature (default "slip")

---@class fabric_svk_fields.bending.friction_weft
---@field moment number N: friction moment per width
---@field curvature number 1/m: curvature over which it builds up
---@field memory? "slip"|"fading" slip: the friction moment grows linearly until it slips; fading: it approaches its limit exponentially over that curvature (default "slip")

---@class fabric_svk_fields.bending
---@field warp number|number[]|table N.m: bending rigidity along the warp: a number, or as it changes with the curvature k, B = b0 + b1 k + ..., {b0, b1, ...}, or measured points {{k, M}, ...} of curvature, 1/m, and moment per width, N, from {0, 0} on
---@field weft number|number[]|table N.m: bending rigidity along the weft: a number, or as it changes with the curvature k, B = b0 + b1 k + ..., {b0, b1, ...}, or measured points {{k, M}, ...} of curvature, 1/m, and moment per width, N, from {0, 0} on
---@field twist number N.m: twisting rigidity, multiplies 2 kappa12
---@field friction_warp? fabric_svk_fields.bending.friction_warp bending hysteresis along the warp
---@field friction_weft? fabric_svk_fields.bending.friction_weft bending hysteresis along the weft
---@field tested? number 1/m: curvature up to which the rigidities were measured: beyond it they are constant; 0: not stated (default 0)

---@class fabric_svk_fields.estimate.bending.friction_warp
---@field moment number N: friction moment per width
---@field curvature number 1/m: curvature over which it builds up
---@field memory? "slip"|"fading" slip: the friction moment grows linearly until it slips; fading: it approaches its limit exponentially over that curvature (default "slip")

---@class fabric_svk_fields.estimate.bending.friction_weft
---@field moment number N: friction moment per width
---@field curvature number 1/m: curvature over which it builds up
---@field memory? "slip"|"fading" slip: the friction moment grows linearly until it slips; fading: it approaches its limit exponentially over that curvature (default "slip")

---@class fabric_svk_fields.estimate.bending
---@field warp number|number[]|table N.m: bending rigidity along the warp: a number, or as it changes with the curvature k, B = b0 + b1 k + ..., {b0, b1, ...}, or measured points {{k, M}, ...} of curvature, 1/m, and moment per width, N, from {0, 0} on
---@field weft number|number[]|table N.m: bending rigidity along the weft: a number, or as it changes with the curvature k, B = b0 + b1 k + ..., {b0, b1, ...}, or measured points {{k, M}, ...} of curvature, 1/m, and moment per width, N, from {0, 0} on
---@field twist number N.m: twisting rigidity, multiplies 2 kappa12
---@field friction_warp? fabric_svk_fields.estimate.bending.friction_warp bending hysteresis along the warp
---@field friction_weft? fabric_svk_fields.estimate.bending.friction_weft bending hysteresis along the weft
---@field tested? number 1/m: curvature up to which the rigidities were measured: beyond it they are constant; 0: not stated (default 0)

---@class fabric_svk_fields.estimate
---@field bending fabric_svk_fields.estimate.bending of the bending
---@field source string where the estimate comes from

---@class fabric_svk_fields.rupture.warp.scatter
---@field modulus number Weibull modulus of the strength; the larger, the less it scatters
---@field length? number m: length of yarn at which the strength was measured; without it strength does not depend on length
---@field exponent? number strength goes with length^-exponent; default 1 / modulus, the weakest link

---@class fabric_svk_fields.rupture.warp
---@field strength number N/m: mean force per width at which these yarns break
---@field energy number J/m: energy that breaking these yarns takes, per metre of the tear
---@field scatter? fabric_svk_fields.rupture.warp.scatter how the strength differs from place to place
---@field yarns? number 1/m: yarns per metre of the line on which they break; with scatter each yarn has a strength of its own, and a place of the mesh the mean of its yarns

---@class fabric_svk_fields.rupture.weft.scatter
---@field modulus number Weibull modulus of the strength; the larger, the less it scatters
---@field length? number m: length of yarn at which the strength was measured; without it strength does not depend on length
---@field exponent? number strength goes with length^-exponent; default 1 / modulus, the weakest link

---@class fabric_svk_fields.rupture.weft
---@field strength number N/m: mean force per width at which these yarns break
---@field energy number J/m: energy that breaking these yarns takes, per metre of the tear
---@field scatter? fabric_svk_fields.rupture.weft.scatter how the strength differs from place to place
---@field yarns? number 1/m: yarns per metre of the line on which they break; with scatter each yarn has a strength of its own, and a place of the mesh the mean of its yarns

---@class fabric_svk_fields.rupture
---@field warp? fabric_svk_fields.rupture.warp breaking of the warp yarns; without it they hold
---@field weft? fabric_svk_fields.rupture.weft breaking of the weft yarns; without it they hold

---@class fabric_svk_fields
---@field name? string of the fabric (default "")
---@field source? string where the numbers come from (default "")
---@field density number kg/m^3: mass over volume
---@field thickness number m: of the sheet
---@field bending? fabric_svk_fields.bending own bending rigidity instead of integration through the thickness
---@field provenance? table where values come from: {['warp.loading']='fitted to 4 specimens', ['shear.unloading']='assumed: ...'}; words begin with fitted, measured, copied, typed or assumed
---@field ranges? table where assumed numbers may lie, for fabric.budget: {['warp.poisson']={0.1, 0.6}, ['warp.loading']={0.5, 2}}; Poisson's ratios as they are, others as factors
---@field through_thickness? boolean bending by integration through the thickness is intended where the card has no bending of its own: no warning, even if that is far stiffer than cloth (default false)
---@field estimate? fabric_svk_fields.estimate estimates of what was not measured, used by fabric.card(name, { bending='estimated' })
---@field compression? table one sheet pressed between two plates, {{gap, pressure}, ...}: gap, m, is its thickness then, which is also how far apart the middles of two such sheets are, pressure in Pa; what contact presses with
---@field fibre_density? number kg/m^3: of what the yarns are made of; areal mass over it is how thin the sheet can be pressed at most; default 1500 (cotton 1540, polyester 1380)
---@field folds? "resolved"|"within elements"|"free" where compressed cloth folds: resolved, in the shape of the mesh alone; within elements too, which then carry no more than folds of their size would; or free, the same without any force (default "resolved")
---@field rupture? fabric_svk_fields.rupture where yarns break: in tearable zones of a model, see model:tearable
---@field warp? number Pa: modulus along the warp
---@field weft? number Pa: modulus along the weft
---@field shear? number Pa: engineering shear modulus, S12 = 2 shear E12
---@field poisson number|number[] {nu12, nu21}, or one number for both
---@field young? number Pa: modulus of an isotropic sheet, instead of warp, weft, shear
---@field transverse? number[] Pa: {G13, G23}; default 5/6 of shear

---A St. Venant-Kirchhoff sheet: for comparison, with constant moduli; S12 = 2 shear E12.
---@param fields fabric_svk_fields
---@return card
function fabric.svk(fields) end

---@class fabric_table_fields
---@field file string of numbers in columns
---@field separator? "auto"|","|";"|"tab"|"blank" between cells; auto: found from the file (default "auto")
---@field decimal? "auto"|"."|"," decimal sign; auto: found from the file (default "auto")
---@field thousands? "auto"|"."|","|"none" sign between thousands, wherever it occurs; auto: where it cannot be the decimal sign; none: no sign stands there (default "auto")
---@field blocks? boolean a list of the tables in the file, one for each heading or sheet; false: there is one (default false)
---@field lenient? boolean a bad cell is no error but nan, and the column has trouble, the message (default false)

---Reads a CSV or the like, with or without heading, units, comments, byte-order mark. Returns a list of columns {name, unit, values} with file, header (whether there is one) and preamble (lines above the numbers), lines (of the file, of each row) and left_out, the lines of words and totals below the rows. A column of text alone (dates, labels) has nan, words, and trouble, the message of its first cell. A spreadsheet (.xlsx) is read where openpyxl is installed.
---@param fields fabric_table_fields
---@return table[]
function fabric.table(fields) end

---Writes the session as a deck that can be run; without an argument returns the file's name or false. The file is complete at any moment; inputs that failed are comments in it.
---@param file? string|boolean a new Lua file that holds all input at the prompt, from the start of the session on; false ends it
function fabric.transcript(file) end

---Prints a warning on stderr with the deck's line, each text once.
---@param text string what to say
function fabric.warn(text) end

---The global variables that were set at the prompt or by the deck, objects first: rows of name, class and text, which print as a table.
function fabric.who() end

---Why the last failed run failed: the text of its analysis:why().
---@return string
function fabric.why() end

---@class fabric_woven_fields.bending.friction_warp
---@field moment number N: friction moment per width
---@field curvature number 1/m: curvature over which it builds up
---@field memory? "slip"|"fading" slip: the friction moment grows linearly until it slips; fading: it approaches its limit exponentially over that curvature (default "slip")

---@class fabric_woven_fields.bending.friction_weft
---@field moment number N: friction moment per width
---@field curvature number 1/m: curvature over which it builds up
---@field memory? "slip"|"fading" slip: the friction moment grows linearly until it slips; fading: it approaches its limit exponentially over that curvature (default "slip")

---@class fabric_woven_fields.bending
---@field warp number|number[]|table N.m: bending rigidity along the warp: a number, or as it changes with the curvature k, B = b0 + b1 k + ..., {b0, b1, ...}, or measured points {{k, M}, ...} of curvature, 1/m, and moment per width, N, from {0, 0} on
---@field weft number|number[]|table N.m: bending rigidity along the weft: a number, or as it changes with the curvature k, B = b0 + b1 k + ..., {b0, b1, ...}, or measured points {{k, M}, ...} of curvature, 1/m, and moment per width, N, from {0, 0} on
---@field twist number N.m: twisting rigidity, multiplies 2 kappa12
---@field friction_warp? fabric_woven_fields.bending.friction_warp bending hysteresis along the warp
---@field friction_weft? fabric_woven_fields.bending.friction_weft bending hysteresis along the weft
---@field tested? number 1/m: curvature up to which the rigidities were measured: beyond it they are constant; 0: not stated (default 0)

---@class fabric_woven_fields.estimate.bending.friction_warp
---@field moment number N: friction moment per width
---@field curvature number 1/m: curvature over which it builds up
---@field memory? "slip"|"fading" slip: the friction moment grows linearly until it slips; fading: it approaches its limit exponentially over that curvature (default "slip")

---@class fabric_woven_fields.estimate.bending.friction_weft
---@field moment number N: friction moment per width
---@field curvature number 1/m: curvature over which it builds up
---@field memory? "slip"|"fading" slip: the friction moment grows linearly until it slips; fading: it approaches its limit exponentially over that curvature (default "slip")

---@class fabric_woven_fields.estimate.bending
---@field warp number|number[]|table N.m: bending rigidity along the warp: a number, or as it changes with the curvature k, B = b0 + b1 k + ..., {b0, b1, ...}, or measured points {{k, M}, ...} of curvature, 1/m, and moment per width, N, from {0, 0} on
---@field weft number|number[]|table N.m: bending rigidity along the weft: a number, or as it changes with the curvature k, B = b0 + b1 k + ..., {b0, b1, ...}, or measured points {{k, M}, ...} of curvature, 1/m, and moment per width, N, from {0, 0} on
---@field twist number N.m: twisting rigidity, multiplies 2 kappa12
---@field friction_warp? fabric_woven_fields.estimate.bending.friction_warp bending hysteresis along the warp
---@field friction_weft? fabric_woven_fields.estimate.bending.friction_weft bending hysteresis along the weft
---@field tested? number 1/m: curvature up to which the rigidities were measured: beyond it they are constant; 0: not stated (default 0)

---@class fabric_woven_fields.estimate
---@field bending fabric_woven_fields.estimate.bending of the bending
---@field source string where the estimate comes from

---@class fabric_woven_fields.rupture.warp.scatter
---@field modulus number Weibull modulus of the strength; the larger, the less it scatters
---@field length? number m: length of yarn at which the strength was measured; without it strength does not depend on length
---@field exponent? number strength goes with length^-exponent; default 1 / modulus, the weakest link

---@class fabric_woven_fields.rupture.warp
---@field strength number N/m: mean force per width at which these yarns break
---@field energy number J/m: energy that breaking these yarns takes, per metre of the tear
---@field scatter? fabric_woven_fields.rupture.warp.scatter how the strength differs from place to place
---@field yarns? number 1/m: yarns per metre of the line on which they break; with scatter each yarn has a strength of its own, and a place of the mesh the mean of its yarns

---@class fabric_woven_fields.rupture.weft.scatter
---@field modulus number Weibull modulus of the strength; the larger, the less it scatters
---@field length? number m: length of yarn at which the strength was measured; without it strength does not depend on length
---@field exponent? number strength goes with length^-exponent; default 1 / modulus, the weakest link

---@class fabric_woven_fields.rupture.weft
---@field strength number N/m: mean force per width at which these yarns break
---@field energy number J/m: energy that breaking these yarns takes, per metre of the tear
---@field scatter? fabric_woven_fields.rupture.weft.scatter how the strength differs from place to place
---@field yarns? number 1/m: yarns per metre of the line on which they break; with scatter each yarn has a strength of its own, and a place of the mesh the mean of its yarns

---@class fabric_woven_fields.rupture
---@field warp? fabric_woven_fields.rupture.warp breaking of the warp yarns; without it they hold
---@field weft? fabric_woven_fields.rupture.weft breaking of the weft yarns; without it they hold

---@class fabric_woven_fields.warp.loop
---@field friction number fraction of the peak stress due to friction between the fibres: the width of the loop
---@field reach? number fraction of the strain from the peak to zero stress over which that friction is lost, and built up again after a reversal (default 0.5)
---@field curve? number fraction of the elastic part that grows with the square of that strain; 0: linearly (default 0)

---@class fabric_woven_fields.warp
---@field loading number[]|table Pa: tangent modulus D(E) = d0 + d1 E + ..., Pa, as {d0, d1, ...}; or measured points {{E, S}, ...} from {0, 0} on
---@field unloading number Pa: unloading modulus
---@field poisson number nu12: contraction along weft when pulled along warp
---@field loop? fabric_woven_fields.warp.loop unloading and reloading along curves instead of one straight line, with loops inside loops; unloading is then the secant from the peak to zero stress; law potential only

---@class fabric_woven_fields.weft.loop
---@field friction number fraction of the peak stress due to friction between the fibres: the width of the loop
---@field reach? number fraction of the strain from the peak to zero stress over which that friction is lost, and built up again after a reversal (default 0.5)
---@field curve? number fraction of the elastic part that grows with the square of that strain; 0: linearly (default 0)

---@class fabric_woven_fields.weft
---@field loading number[]|table Pa: tangent modulus D(E) = d0 + d1 E + ..., Pa, as {d0, d1, ...}; or measured points {{E, S}, ...} from {0, 0} on
---@field unloading number Pa: unloading modulus
---@field poisson number nu21: contraction along warp when pulled along weft
---@field loop? fabric_woven_fields.weft.loop unloading and reloading along curves instead of one straight line, with loops inside loops; unloading is then the secant from the peak to zero stress; law potential only

---@class fabric_woven_fields.shear.friction
---@field stress number Pa: stress at which friction slips at zero strain
---@field growth? number Pa: increase of this stress with the strain, in shear's measure: the loop widens (default 0)

---@class fabric_woven_fields.shear
---@field loading number[]|table Pa: tangent modulus in the measure's strain, Pa, as {g0, g1, ...}; or measured points
---@field unloading number Pa: unloading modulus, in the same measure
---@field measure? "tensor"|"engineering" tensor: dS12/dE12 in E12; engineering: dS12/d(2E12) in 2E12 (default "tensor")
---@field memory? "printed"|"fading" memory of the branch left at a reversal: printed, as in the published law, erases it at once; fading lets it decay with the slip that follows (default "printed")
---@field friction? fabric_woven_fields.shear.friction elastic-frictional shear: loading is elastic; in parallel, friction sticks with the modulus unloading less the initial modulus and slips at stress + growth |strain|; law potential only

---@class fabric_woven_fields.tested
---@field warp? number largest E11 tested (default 0)
---@field weft? number largest E22 tested (default 0)
---@field shear? number largest E12 tested (tensor) (default 0)

---@class fabric_woven_fields.biaxial
---@field alpha number weight of E22
---@field offset number strain where it begins
---@field loading number Pa: q of T = q y^2 / 2
---@field unloading number Pa: unloading modulus

---@class fabric_woven_fields.damage.warp
---@field strength number N/m: force of the yarns per width at which they break, without the contraction of the cloth across
---@field energy number J/m: energy that breaking these yarns takes, per metre of the tear

---@class fabric_woven_fields.damage.weft
---@field strength number N/m: force of the yarns per width at which they break, without the contraction of the cloth across
---@field energy number J/m: energy that breaking these yarns takes, per metre of the tear

---@class fabric_woven_fields.damage
---@field warp? fabric_woven_fields.damage.warp breaking of the warp yarns; without it they hold
---@field weft? fabric_woven_fields.damage.weft breaking of the weft yarns; without it they hold

---@class fabric_woven_fields.viscous.shear
---@field modulus number Pa: of the part that relaxes, in shear's measure
---@field time number s: relaxation time: at constant strain its stress falls to 1/e

---@class fabric_woven_fields.viscous
---@field shear fabric_woven_fields.viscous.shear a spring and a dashpot in series beside in-plane shear

---@class fabric_woven_fields.bands.warp
---@field low number[] of loading coefficients (of points: their stresses beyond zero strain), unloading, poisson; of bending: warp, weft, twist, then moment and curvature of each friction; of the biaxial spring: alpha, offset, loading, unloading
---@field high number[] of the same parameters
---@field covariance number[] of the same parameters, row by row

---@class fabric_woven_fields.bands.weft
---@field low number[] of loading coefficients (of points: their stresses beyond zero strain), unloading, poisson; of bending: warp, weft, twist, then moment and curvature of each friction; of the biaxial spring: alpha, offset, loading, unloading
---@field high number[] of the same parameters
---@field covariance number[] of the same parameters, row by row

---@class fabric_woven_fields.bands.shear
---@field low number[] of loading coefficients (of points: their stresses beyond zero strain), unloading, poisson; of bending: warp, weft, twist, then moment and curvature of each friction; of the biaxial spring: alpha, offset, loading, unloading
---@field high number[] of the same parameters
---@field covariance number[] of the same parameters, row by row

---@class fabric_woven_fields.bands.bending
---@field low number[] of loading coefficients (of points: their stresses beyond zero strain), unloading, poisson; of bending: warp, weft, twist, then moment and curvature of each friction; of the biaxial spring: alpha, offset, loading, unloading
---@field high number[] of the same parameters
---@field covariance number[] of the same parameters, row by row

---@class fabric_woven_fields.bands.biaxial
---@field low number[] of loading coefficients (of points: their stresses beyond zero strain), unloading, poisson; of bending: warp, weft, twist, then moment and curvature of each friction; of the biaxial spring: alpha, offset, loading, unloading
---@field high number[] of the same parameters
---@field covariance number[] of the same parameters, row by row

---@class fabric_woven_fields.bands
---@field level? number of confidence (default 0.95)
---@field warp? fabric_woven_fields.bands.warp of the warp's parameters
---@field weft? fabric_woven_fields.bands.weft of the weft's parameters
---@field shear? fabric_woven_fields.bands.shear of the shear's parameters
---@field bending? fabric_woven_fields.bands.bending of the bending's parameters
---@field biaxial? fabric_woven_fields.bands.biaxial of the biaxial's parameters

---@class fabric_woven_fields
---@field name? string of the fabric (default "")
---@field source? string where the numbers come from (default "")
---@field density number kg/m^3: mass over volume
---@field thickness number m: of the sheet
---@field bending? fabric_woven_fields.bending own bending rigidity instead of integration through the thickness
---@field provenance? table where values come from: {['warp.loading']='fitted to 4 specimens', ['shear.unloading']='assumed: ...'}; words begin with fitted, measured, copied, typed or assumed
---@field ranges? table where assumed numbers may lie, for fabric.budget: {['warp.poisson']={0.1, 0.6}, ['warp.loading']={0.5, 2}}; Poisson's ratios as they are, others as factors
---@field through_thickness? boolean bending by integration through the thickness is intended where the card has no bending of its own: no warning, even if that is far stiffer than cloth (default false)
---@field estimate? fabric_woven_fields.estimate estimates of what was not measured, used by fabric.card(name, { bending='estimated' })
---@field compression? table one sheet pressed between two plates, {{gap, pressure}, ...}: gap, m, is its thickness then, which is also how far apart the middles of two such sheets are, pressure in Pa; what contact presses with
---@field fibre_density? number kg/m^3: of what the yarns are made of; areal mass over it is how thin the sheet can be pressed at most; default 1500 (cotton 1540, polyester 1380)
---@field folds? "resolved"|"within elements"|"free" where compressed cloth folds: resolved, in the shape of the mesh alone; within elements too, which then carry no more than folds of their size would; or free, the same without any force (default "resolved")
---@field rupture? fabric_woven_fields.rupture where yarns break: in tearable zones of a model, see model:tearable
---@field warp fabric_woven_fields.warp along the warp
---@field weft fabric_woven_fields.weft along the weft
---@field shear fabric_woven_fields.shear in-plane shear
---@field tested? fabric_woven_fields.tested strains up to which it was measured
---@field law? "potential"|"incremental"|"thesis" the law that is compiled from the card (default "potential")
---@field transverse? "elastic"|"follow" transverse shear of the comparison laws (default "elastic")
---@field shear_hysteresis? boolean of the comparison laws (default true)
---@field biaxial? fabric_woven_fields.biaxial a fourth spring that acts when both yarns are stretched
---@field damage? fabric_woven_fields.damage yarns that soften and break wherever they reach their strength, law potential only; where a tear runs along a line that is known, rupture and tearable zones are sharper
---@field viscous? fabric_woven_fields.viscous stress that relaxes with time, law potential only
---@field bands? fabric_woven_fields.bands confidence bands of the measured parameters

---A woven fabric: loading curves, unloading moduli and Poisson ratios along warp and weft, and in shear.
---@param fields fabric_woven_fields
---@return card
function fabric.woven(fields) end

---Writes a file as a whole and makes its folders: a reader sees the old file or the new one, never a part.
---@param path string of the file
---@param content string all of it
function fabric.write(path, content) end

---Its points { {t, v}, ... }; of a constant one; nil of a function of time, as model:declared may have it.
---@return any
function history:points() end

---The history's value at a time.
---@param time number s: when
---@return number
function history:value(time) end

---Errors of the mesh and remarks on it: a table {ok, text, items, area, shortest, longest, aspect, warping, least_angle, triangles, quadrilaterals, parts, borders}, which prints as its text; an item has key (degenerate, inverted, fold, repeated, orientation, one_sided, apart, unused, duplicate, nonmanifold, aspect, warping, angle, wide, taper, hanging, free), severity (note, warning, error), text, elements, nodes. With a card two lines more, and yarns (degrees from the sides of elements, most, stiffness over shear, locking: share of the cloth whose elements lock) and folds (length: from one to the next by weight, flesh: on flesh, element: its side, m).
---@param card? card of the cloth that the mesh is for
---@param warp? number|number[] degrees: as for fabric.model
---@param flesh? number Pa/m: stiffness of what the cloth lies on, as flesh
---@return table<string, any>
function mesh:check(card, warp, flesh) end

---Numbers of the elements all of whose nodes are in the set.
---@param set string name of a node set
---@return integer[]
function mesh:elements(set) end

---Cuts a hole along the grid: leaves out the elements inside and the nodes that no element has any more. The others are numbered anew in their order; sets keep them, boundary has the rim, too.
---@param inside function function(x, y, z) that says whether the middle of an element is inside
---@param rim? string name of a set to make of the nodes of its rim
---@return any
function mesh:hole(inside, rim) end

---Moves every node; on an error none is moved.
---@param f function function(x, y, z) that returns the new x, y, z
---@return mesh
function mesh:map(f) end

---Turns elements around until neighbours agree on the normal, as few as that takes; returns how many.
---@param direction? number[] {x, y, z}: the mean normal of each part points along it
---@return integer
function mesh:orient(direction) end

---Joins triangles in pairs to quadrilaterals where these have corners of 30 to 150 degrees and are flat; returns how many triangles are left. Stiff yarns that cross triangles obliquely lock them.
---@return any
function mesh:pair() end

---Cuts every element from its middle to the middles of its sides into quadrilaterals, four of a quadrilateral and three of a triangle, so that no triangle is left, which stiff yarns would lock. New nodes lie on the sides: make a mesh of a curved outline fine enough before. Sets take them.
---@return any
function mesh:refine() end

---Makes or replaces a named set of nodes; with the name alone gives its node numbers.
---@param name string of the set
---@param nodes? function|number[] node numbers, or function(x, y, z) that says whether a node is inside
---@return mesh
---@overload fun(self: mesh, name: string): integer[]
function mesh:set(name, nodes) end

---@class mesh_slit_fields
---@field from number[] m: {x, y} or {x, y, z}: a node, where the slit begins
---@field to number[] m: where it ends
---@field left? string name of a set to make of the nodes of its left side, seen on the way against the normal
---@field right? string the same of its right side

---Slits the mesh along a straight line of edges between nodes: the nodes on it are doubled, but for an end inside the mesh, which is the tip. The left side keeps them, the new nodes follow all others and are in the same sets; boundary has the sides of the slit, too.
---@param fields mesh_slit_fields
---@return any
function mesh:slit(fields) end

---@class mesh_wrap_fields.cylinder
---@field radius number m: at the point `at` of the panel
---@field from? number[] {x, y, z}: the point of the axis beside it, m, default the origin
---@field axis? number[] {x, y, z}: its direction, default {0, 0, 1}
---@field towards? number[] {x, y, z}: where `at` lies as seen from the axis, default {1, 0, 0}
---@field at? number[] m: {x, y}: a point in the plane of the panel, default {0, 0}

---@class mesh_wrap_fields.cone
---@field radius number m: at the point `at` of the panel
---@field from? number[] {x, y, z}: the point of the axis beside it, m, default the origin
---@field axis? number[] {x, y, z}: its direction, default {0, 0, 1}
---@field towards? number[] {x, y, z}: where `at` lies as seen from the axis, default {1, 0, 0}
---@field at? number[] m: {x, y}: a point in the plane of the panel, default {0, 0}
---@field angle number degrees: between axis and surface; positive: wider along the axis

---@class mesh_wrap_fields
---@field cylinder? mesh_wrap_fields.cylinder to go around
---@field cone? mesh_wrap_fields.cone to go around
---@field overlap? boolean allow more than one turn (default false)

---Lays a mesh in the x-y plane around a cylinder or a cone, with lengths, angles and areas kept and the normal outward: the point `at` comes to lie beside `from` at the distance radius, +y runs along the axis there, +x around it counter-clockwise. The warp of a panel goes along. Errors move no node.
---@param fields mesh_wrap_fields
---@return any
function mesh:wrap(fields) end

---Writes the mesh, lengths in m. With its sets: .vtu and .msh (Gmsh 4.1), which read back equal, .inp (Abaqus, CalculiX), .k (LS-DYNA), .rad (OpenRadioss). The surface alone: .obj, .ply, .stl. The old file stays until the new one is whole.
---@param file string ends in .msh, .vtu, .obj, .stl, .ply, .inp, .k or .rad
---@return mesh
function mesh:write(file) end

---@class model_band_fields
---@field set string the nodes of an edge
---@field stiffness number N: force per strain of the band
---@field ease? number by what share of the edge the band is shorter without force (default 0)
---@field over? number s: time in which it becomes that short; without it, it is from the start

---Puts a band along an edge: elastic in a hem, or with a high stiffness a cord that is drawn tight. It pulls and never pushes.
---@param fields model_band_fields
---@return model
function model:band(fields) end

---@class model_centrifuge_fields
---@field speed number|function|history degrees/s: of turning
---@field axis number[] {x, y, z}: direction of the axis
---@field set? string name of a set of nodes, with their mass (default "all")
---@field centre? number[] {x, y, z}, m: a point of the axis; default {0, 0, 0}

---Loads cloth with centrifugal forces, as in a frame that turns steadily: mass times distance from the axis times the square of the speed. They follow the cloth (their stiffness is in the tangent). Forces of Coriolis and of a changing speed are not among them.
---@param fields model_centrifuge_fields
---@return model
function model:centrifuge(fields) end

---The suitability of the mesh for this cloth, as two lines for each region: how yarns cross its elements, and how large folds are beside elements, by weight and on bodies that give way.
---@return model
function model:check() end

---@class model_contact_fields.friction
---@field static? number of what sticks, at least the kinetic one
---@field kinetic? number of what slides
---@field warp? number of sliding along the warp of the cloth that comes first in the model
---@field weft? number of sliding across it

---@class model_contact_fields.film
---@field viscosity number Pa s: of what is between the surfaces, such as a hot matrix
---@field thickness number m: of it
---@field speed? number m/s: of sliding from which the viscosity falls; default: it stays
---@field exponent? number of the speed in the traction far above that: 1 would be the same viscosity at all speeds

---@class model_contact_fields
---@field between? table { body or set, ... }: every two of them touch ("all": the whole cloth)
---@field self? string a set whose cloth touches itself
---@field friction? number|model_contact_fields.friction friction coefficient; or {static, kinetic}, of what sticks and of what slides; or {warp, weft}, by direction (default 0)
---@field film? model_contact_fields.film beside friction, viscosity times sliding speed over thickness, where the surfaces touch; with speed and exponent n times (1 + (v / speed)^2)^((n - 1) / 2)
---@field thickness? number m: of the cloth in contact; default: the cloth's own, or that of its card's compression
---@field stiffness? number Pa/m: pressure per closed gap; default: the compression curve of the card, or else 1 MPa down to the floor; in explicit runs no more than the cloth's own stable step carries
---@field restitution? number speed after over speed before of a sheet that meets something flat; 1: nothing is lost (default 0.5)
---@field settle? number s: time from the start in which sheets and bodies that begin too near to each other, but not one through the other, are brought apart; without it they are refused

---Lets surfaces touch: cloth on rigid bodies, on other cloth, on itself. Nothing passes through.
---@param fields model_contact_fields
---@return model
function model:contact(fields) end

---@class model_copy_fields.changes
---@field without? string|table what the copy does not have: a kind of m:list() or kind and set, 'pressure' or 'fix left', or a list of these

---A model of the same cloth with the same supports and loads, which may be changed also where a run has compiled this one.
---@param changes? model_copy_fields.changes what differs; supports and loads are added by its calls
---@return model
function model:copy(changes) end

---@class model_crease_fields
---@field line? table { {x, y, z}, ... }: through points of the stress-free shape, in m, along edges of its mesh
---@field set? string the nodes of a line of edges, in place of the line
---@field angle number degrees: between the normals of both sides where the crease is at rest; positive where they lean towards each other, as in a valley seen from the side of the normals
---@field stiffness? number N/rad: N m/rad per metre of crease: makes it a hinge, whose moment is this times the angle from rest; without it the sheet is as stiff there as elsewhere

---Makes a crease: a line along which the sheet is at rest at an angle. The elements beside it are as stiff as elsewhere. Creases that all have a stiffness may cross.
---@param fields model_crease_fields
---@return model
function model:crease(fields) end

---@class model_damper_fields.rate
---@field x? number N s/m: along x
---@field y? number N s/m: along y
---@field z? number N s/m: along z

---@class model_damper_fields.options
---@field to? number[]|body another body, whose speed is subtracted; default the ground

---Resists the speed of a rigid body's centre; what it takes is in a.energy.damping.
---@param set body the rigid body
---@param rate model_damper_fields.rate {x=, y=, z=}: force per speed
---@param options? model_damper_fields.options to = where it ends
---@return model
function model:damper(set, rate, options) end

---The declarations as data: rows of kind (sheet, or the call's name) and set, with the numbers, vectors and histories of the call under their names, in SI units and degrees; freedoms as the list `held`, axes of their own as `frame`. model:list says the same in words.
---@return model
function model:declared() end

---@class model_fix_fields.options
---@field frame? table {e1, e2}: directions of x and, made normal to it, y in this call

---Holds freedoms of a node set, or of a rigid body that forces place in the others; fixing twice is harmless.
---@param set string|body name of a node set, or a rigid body
---@param freedoms string some of x y z rx ry rz rotation; rotation is both of the director's, or all three of a body
---@param options? model_fix_fields.options frame = {e1, e2} for x and y that are not those of space; e2 is made normal to e1
---@return model
function model:fix(set, freedoms, options) end

---@class model_force_fields.components
---@field x? number|function|history N: history along x
---@field y? number|function|history N: history along y
---@field z? number|function|history N: history along z

---@class model_force_fields.options
---@field frame? table {e1, e2}: directions of x and, made normal to it, y in this call

---Loads a node set with a total force; a single node takes it whole. Loads a rigid body at its centre (dynamic runs need its mass), which then moves in the directions that m:fix does not hold.
---@param set string|body name of a node set, or a rigid body
---@param components model_force_fields.components {x=, y=, z=}: the total force, shared by length or area
---@param options? model_force_fields.options frame = {e1, e2} for x and y that are not those of space; e2 is made normal to e1
---@return model
function model:force(set, components, options) end

---@class model_gas_fields.gas
---@field molar number kg/mol: its molar mass
---@field cp number J/(kg K): its specific heat at constant pressure

---@class model_gas_fields
---@field set? string|table elements that close around the gas: a set, or a list of sets (default "all")
---@field lids? string|table|body rigid bodies that close the holes whose rims lie at them, and sets of nodes around holes that something closes which weighs nothing: the gas pushes on it, and it on the nodes, evenly
---@field initial? number Pa: pressure above that outside at time 0; default 0
---@field mass? number kg: mass of the gas at time 0, in place of a pressure
---@field temperature? number K: at time 0, and of what flows in (default 293.15)
---@field gas? "air"|model_gas_fields.gas "air" or {molar=, cp=}
---@field exponent? number n of p V^n: 1 isothermal, 1.4 adiabatic (default 1)
---@field inflow? number|function|table|history kg/s: { {time, kg/s}, ... } or a history: mass that flows in
---@field vents? table { {set=|area=, coefficient=0.6, to=?, opens=?}, ... }: holes through which gas flows out, or to another volume, as through a nozzle; a set counts by its area at the start
---@field leakage? number|function|number[] speed of the air through the cloth, m/s at 100 Pa; {m/s, Pa} at another pressure; or function(Pa) returning m/s
---@field outside? number Pa: absolute pressure outside (default 101325)

---Fills a closed volume with gas. Its pressure is the same everywhere and follows from the volume, the mass and the temperature. Returns the volume, for a:gas and for vents of others.
---@param fields model_gas_fields
---@return model
function model:gas(fields) end

---Lets gravity act on the whole cloth, and on rigid bodies that have a mass and forces place. A second call takes the place of the first.
---@param acceleration table m/s^2: {gx, gy, gz}, each a history
---@return model
function model:gravity(acceleration) end

---Its supports and loads (before them bodies and regions, if any): rows of kind (the call's name), set and what, which print as a table.
---@return model
function model:list() end

---@class model_moment_fields.components
---@field x? number|function|history N m: history along x
---@field y? number|function|history N m: history along y
---@field z? number|function|history N m: history along z

---@class model_moment_fields.options
---@field frame? table {e1, e2}: directions of x and, made normal to it, y in this call

---Loads the directors of a node set with a moment, shared by length or area; or a rigid body about its centre.
---@param set string|body name of a node set, or a rigid body
---@param components model_moment_fields.components {x=, y=, z=}: the total moment about axes that stay fixed in space
---@param options? model_moment_fields.options frame = {e1, e2} for x and y that are not those of space; e2 is made normal to e1
---@return model
function model:moment(set, components, options) end

---@class model_move_fields.components.turn
---@field axis number[] {x, y, z}: direction of the axis
---@field angle? number|function|history degrees: angle about the axis
---@field centre? number[] {x, y, z}, m: a point of the axis; default the body's centre, of a surface without a mass that of its area

---@class model_move_fields.components
---@field x? number|function|history m: history along x
---@field y? number|function|history m: history along y
---@field z? number|function|history m: history along z
---@field turn? model_move_fields.components.turn of a rigid body: {axis=, angle=, centre=}

---@class model_move_fields.options
---@field frame? table {e1, e2}: directions of x and, made normal to it, y in this call

---Prescribes displacements of a node set, or of a rigid body, as histories (number, function(t), fabric.history, fabric.ramp).
---@param set string|body name of a node set, or a rigid body
---@param components model_move_fields.components {x=, y=, z=, turn=}: displacement from the reference position
---@param options? model_move_fields.options frame = {e1, e2} for x and y that are not those of space; e2 is made normal to e1
---@return model
function model:move(set, components, options) end

---Loads elements with a pressure that follows the surface (its load stiffness is in the tangent).
---@param value number|function|history Pa: pressure, positive along the shell normal
---@param set? string name of a node set; the elements all of whose nodes are in it (default "all")
---@return model
function model:pressure(value, set) end

---@class model_remove_fields.row
---@field kind string the call's name
---@field set string its set
---@field what? string as listed; without it the last of them

---Takes back (undoes) a support or a load: a row of m:list() or its number.
---@param row integer|model_remove_fields.row a row of m:list(), or its number
---@return model
function model:remove(row) end

---@class model_seam_fields.seam
---@field over? number s: time in which threads draw the edges together, before they become one; without it they lie on each other and are one from the start
---@field ease? number by what share of the longer edge the other may be shorter; the rest is spread evenly (default 0.01)
---@field reverse? boolean whether the edges are matched from different ends, the end of an edge with the lowest number of a node being its first; default so that the ends lie nearer
---@field hinge? boolean whether the edges can turn against each other; default where their normals are more than 60 degrees apart as they become one
---@field stiffness? number N/m^2: force per metre of seam and metre of opening, of a seam that gives way; default none, the edges become one
---@field strength? number N/m: force per metre at which the seam bursts; default never
---@field energy? number J/m: that bursting takes, per metre; with strength

---Sews two edges of the cloth together: threads draw them together, then they are one. The edge with more nodes follows the other, matched by the length along each.
---@param seam model_seam_fields.seam|table { first, second, ... }: the sets of the nodes of two edges
---@return model
function model:seam(seam) end

---@class model_spring_fields.stiffness
---@field x? number N/m: along x
---@field y? number N/m: along y
---@field z? number N/m: along z

---@class model_spring_fields.options
---@field frame? table {e1, e2}: directions of x and, made normal to it, y in this call
---@field to? number[]|body of a rigid body: another body, or {x, y, z}, m, where its centre is when the spring is slack; default where it begins

---Ties a node set to its reference position by springs; or the centre of a rigid body to the ground or to another body.
---@param set string|body name of a node set, or a rigid body
---@param stiffness model_spring_fields.stiffness {x=, y=, z=}: the total stiffness to ground, shared by length or area
---@param options? model_spring_fields.options frame = {e1, e2} for x and y that are not those of space, e2 is made normal to e1; to = where a body's spring ends
---@return model
function model:spring(set, stiffness, options) end

---@class model_strength_fields
---@field set? string the elements meant (default "all")
---@field factor? number strength of the yarns there over that of the card, the mean (default 1)
---@field modulus? number Weibull modulus, with which it differs from element to element; without it it does not
---@field seed? integer of that (default 1)

---The strength of yarns that soften (see damage of a card) where it is not that of the card: weakened lines, scatter. Where sets overlap, the factors multiply.
---@param fields model_strength_fields
---@return model
function model:strength(fields) end

---Holds a node set in a plane of symmetry: the displacement along the normal and the two rotations out of the plane. The nodes lie in such a plane, and the cloth is symmetric about it: its yarns run along and across it, in each layer. A free body that the plane cuts moves in it; its mass is that of the part in the model.
---@param set string name of a node set
---@param normal string "x", "y" or "z": normal of the plane
---@return model
function model:symmetry(set, normal) end

---@class model_tearable_fields.options
---@field coarse? "lower"|"refuse"|"keep" where elements are coarse for the card's strength and energy: lower the strength until a tear runs at the right force, and say so; refuse; or keep the strength, which is right where no tear runs, as in a strip without a notch (default "lower")
---@field seed? integer of the scatter of strengths (default 1)
---@field path? string a set of nodes: yarns break at these places only, where the path of a tear is given

---Declares a tearable zone: each corner of its elements gets a node of its own, which moves with the others at its place until a:cut opens the joint, or in explicit motion its yarns reach the strength that the card has in rupture. The further nodes are numbered after those of the mesh.
---@param set string a set whose elements may come apart along their edges during a run
---@param options? model_tearable_fields.options of breaking yarns
---@return model
function model:tearable(set, options) end

---Ties nodes to each other exactly, by elimination. To a rigid body they are tied by springs that are stiff beside the cloth, and turn freely there.
---@param kind string "equal": the set's nodes share displacements; "straight": they stay on the line between its ends; "rigid": nodes and directors move as one body; "periodic": two sets whose pairs of nodes keep one common relative displacement; the second follows the first
---@param set string name of a node set
---@param second? string|body periodic: the set that follows; rigid: nothing, or a rigid body with a name, along with which the nodes go; else freedoms, some of x y z
---@param freedoms? string periodic: some of x y z rotation; default all
---@return model
function model:tie(kind, set, second, freedoms) end

---@class model_traction_fields.components
---@field x? number|function|history N/m^2 or N/m: history along x
---@field y? number|function|history N/m^2 or N/m: history along y
---@field z? number|function|history N/m^2 or N/m: history along z

---@class model_traction_fields.options
---@field frame? table {e1, e2}: directions of x and, made normal to it, y in this call

---Loads a node set with a dead traction on its reference area, or a line load on its reference edges.
---@param set string name of a node set
---@param components model_traction_fields.components {x=, y=, z=}: per area where the set holds whole elements, else per edge length
---@param options? model_traction_fields.options frame = {e1, e2} for x and y that are not those of space; e2 is made normal to e1
---@return model
function model:traction(set, components, options) end

---@class model_turn_fields.motion
---@field axis number[] {x, y, z}: direction of the axis
---@field angle? number|function|history degrees: angle about the axis
---@field centre? number[] {x, y, z}, m: with it the nodes turn about this point too

---Turns the directors of a node set rigidly, and with a centre the nodes too: a rotating grip.
---@param set string name of a node set
---@param motion model_turn_fields.motion {axis=, angle=, centre=}
---@return model
function model:turn(set, motion) end

---@class model_velocity_fields.velocity
---@field x? number m/s: along x
---@field y? number m/s: along y
---@field z? number m/s: along z
---@field spin? number[] {wx, wy, wz}, degrees/s: in addition, a rigid rotation
---@field centre? number[] {x, y, z}, m: a point of its axis; default {0, 0, 0}

---Velocity of a node set, or of a free rigid body, at time 0, for fabric.dynamic: one for all, or a function of place that returns it for each node.
---@param set string|body name of a node set, or a rigid body
---@param velocity function|model_velocity_fields.velocity {x=, y=, z=, spin=, centre=}, or function(x, y, z) returning it
---@return model
function model:velocity(set, velocity) end

---@class point_bend_fields
---@field k11? number 1/m: along the warp
---@field k22? number 1/m: along the weft
---@field k12? number 1/m: twist, tensor component

---Reaches total curvatures in one straight increment and commits them, by the card's own bending; components not named stay. Returns M11 M22 M12 (moments per width, N; M12 works on 2 k12), k11 k22 k12, stored and dissipated (J/m^2).
---@param fields point_bend_fields
---@return any
function point:bend(fields) end

---E11 = E and E22 = ratio E, for each E of a list: a list of rows, or the columns named.
---@param ratio number E22 over E11
---@param E number[] values of E11
---@param columns? table names, such as {'E11', 'S11'}: returns {E11={...}, S11={...}}
---@return table<string, any>
function point:biaxial(ratio, E, columns) end

---Many straight increments in one call: a list of rows, or the columns named. A component without a column stays.
---@param strains table { {E11, E22, E12}, ... } or { E11={...}, E22={...}, E12={...} }; seconds that an increment takes as fourth number of a row, or in over={...}
---@param columns? table names, such as {'E11', 'S11'}: returns {E11={...}, S11={...}}
---@return table<string, any>
function point:path(strains, columns) end

---Back to virgin cloth at zero strain and time 0.
function point:reset() end

---Where the point is: the row of its last commit, residual strains and slack of both yarns, and the branch (virgin, unloading, slack) of warp, weft and shear.
---@return table<string, any>
function point:state() end

---@class point_strain_fields
---@field E11? number along the warp
---@field E22? number along the weft
---@field E12? number shear, tensor component
---@field over? number s: that an increment takes; 0: at once (default 0)

---Reaches a total strain in one straight increment and commits it; components not named stay. Returns S11 S22 S12 E11 E22 E12 stored dissipated.
---@param fields point_strain_fields
---@return table<string, any>
function point:strain(fields) end

---Strain along a direction with the other stresses driven to zero. Returns the same and S, E, E_lateral; for a list of strains a list of such rows, or the columns named.
---@param direction number|"warp"|"weft" degrees from the warp: warp, weft or an angle
---@param E number|number[] strain along it, or a list of strains
---@param columns? table names, such as {'E11', 'S11'}: returns {E11={...}, S11={...}}
---@param over? number s: that an increment takes; 0: at once (default 0)
---@return table<string, any>
function point:uniaxial(direction, E, columns, over) end

---@class shape_mesh_fields.options
---@field body? string of several bodies this one alone

---The mesh of the model moved by the shape, without stress: a next model that begins imperfect.
---@param amplitude number m: of its longest displacement
---@param options? shape_mesh_fields.options which part
---@return mesh
function shape:mesh(amplitude, options) end

---@class shape_vtk_fields.options
---@field amplitude? number m: of its longest displacement; default a tenth of the cloth's length
---@field frames? integer of one swing; 1: where it is farthest; default 24

---Writes one swing of the shape about its state as a series for ParaView and fabric.render.
---@param stem string path of the files without ending
---@param options? shape_vtk_fields.options how far, and in how many frames
---@return shape
function shape:vtk(stem, options) end

return fabric
