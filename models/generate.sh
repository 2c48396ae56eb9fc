#!/usr/bin/env bash
# Writes every model of this folder, its picture and README.md. Same files on every run.
# Build first: dotnet build -c Release src/MeshLab.Cli
set -euo pipefail
cd "$(dirname "$0")"
mlab() { dotnet ../src/MeshLab.Cli/bin/Release/net10.0/mlab.dll "$@"; }

# file | kind and parameters | what it is good for
models='
creature.obj|creature|the default model of the tour: a scan-like, noisy beast whose tail grows back into its back
genus-3.ply|holed-torus --genus 3|a smooth closed surface of genus 3
flange.stl|flange|a machine part: sharp edges, flat faces, slivers, five holes through it
bracket.off|bracket|the smallest machine part: an L-shaped extrusion
perforated-sheet.off|perforated-sheet|an open surface with ten boundary loops
vase.obj|vase|mostly quadrilaterals, triangles around a pole, one 48-gon as the foot
chain.ply|chain|five components, interlocked
knot.obj|knot|the trefoil knot as a tube, with texture coordinates
terrain.ply|terrain|a height field
spring.stl|spring|a wire swept along a helix, with caps
torus.off|torus --quads 1|a torus of quadrilaterals
torus-triangles.obj|torus|the same torus in triangles, with texture coordinates
icosphere.off|icosphere --level 4|a sphere with even triangles
sphere.obj|sphere|a sphere by meridians and parallels, with texture coordinates
ellipsoid.ply|ellipsoid|half-axes 1, 3/4, 1/2
catenoid.obj|catenoid|a minimal surface: mean curvature 0
hyperbolic-paraboloid.off|hyperbolic-paraboloid|a saddle: negative Gaussian curvature
annulus.obj|annulus|a flat ring: two boundary loops
open-cylinder.obj|open-cylinder|developable, with a seam in its texture coordinates
cube.obj|cube|the textbook cube: twelve triangles
cone.stl|cone|the textbook cone: 50 sides
tetrahedron.off|tetrahedron|the textbook tetrahedron: the smallest closed mesh
dodecahedron.obj|dodecahedron|twelve pentagons
grid.obj|grid --m 21 --n 21 --quads 1|a flat quadrilateral grid
'

mkdir -p pictures
{
    echo '# Models'
    echo
    echo 'Written by `models/generate.sh` with `mlab generate`; the pictures by `mlab render`, the numbers by `mlab info`.'
    echo
    echo '| picture | file | vertices | edges | faces | components | boundary loops | genus | what | made by |'
    echo '|---|---|---:|---:|---:|---:|---:|---:|---|---|'
} > README.md

field() { sed -n "s/.*\"$1\":\([0-9]*\).*/\1/p" <<< "$info"; }

while IFS='|' read -r file recipe what; do
    [ -n "$file" ] || continue
    name=${file%.*}
    view=30,20
    [ "$name" != tetrahedron ] || view=75,24 # from the usual side one sees a single face
    read -ra words <<< "$recipe"
    mlab generate "${words[0]}" "$file" "${words[@]:1}" --json > /dev/null
    mlab render "$file" "pictures/$name.png" --size 320x256 --view "$view" --json > /dev/null
    info=$(mlab info "$file" --json | tr -d ' \n' | sed 's/"input":{[^}]*},*//')
    echo "| ![$name](pictures/$name.png) | [$file]($file) | $(field vertices) | $(field edges) | $(field faces) | $(field components) |" \
        "$(field boundaryLoops) | $(field genus) | $what | \`mlab generate $recipe\` |" >> README.md
done <<< "$models"
