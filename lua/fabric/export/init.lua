-- fabric.export: cards, meshes and whole models for other programs; fabric.import: the reverse.
require "fabric.export.card"
require "fabric.export.model"
require "fabric.export.import"
require "fabric.export.mesh"
