# SPDX-License-Identifier: Apache-2.0
# Completion of quoin(1) for bash.
_quoin() {
  local word="${COMP_WORDS[COMP_CWORD]}" previous="${COMP_WORDS[COMP_CWORD - 1]}"
  local commands="union intersection difference xor csg info check repair convert view classify section interfere \
hull minkowski erode decompose gaussian-map distance width homology persistence delaunay voronoi alpha flow assembly arrange overlay locate polygon constrained envelope"
  local common="--json --threads --timeout --seed --weld -q --quiet -v --verbose -h --help"
  local makes="-o --output --format --accept-rounding"
  local draws="-o --output --format --labels"
  local operations="union intersection difference xor minkowski offset"
  COMPREPLY=()
  if [[ $COMP_CWORD -eq 1 ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$commands --help --version" -- "$word")
    return
  fi
  if [[ $COMP_CWORD -eq 2 && ${COMP_WORDS[1]} == polygon && $word != -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$operations" -- "$word")
    return
  fi
  case "$previous" in
    --format)
      local formats="off obj stl ply qsolid html"
      case "${COMP_WORDS[1]}" in
        arrange | overlay | locate | gaussian-map) formats="svg html" ;;
        assembly) formats="json html" ;;
        delaunay) formats="vtk ply obj off qcells html" ;;
        voronoi) formats="vtk ply obj off qcells" ;;
        flow | constrained) formats="vtk ply obj off qcells svg html" ;;
        alpha) formats="vtk ply obj off qcells html txt" ;;
        polygon) formats="wkt geojson dxf svg html" ;;
      esac
      mapfile -t COMPREPLY < <(compgen -W "$formats" -- "$word")
      return
      ;;
    --fill)
      mapfile -t COMPREPLY < <(compgen -W "even-odd nonzero positive" -- "$word")
      return
      ;;
    --input-format)
      mapfile -t COMPREPLY < <(compgen -W "xyz pts csv ply obj off pcd" -- "$word")
      return
      ;;
    --graph)
      mapfile -t COMPREPLY < <(compgen -W "gabriel relative-neighbours spanning-tree" -- "$word")
      return
      ;;
    --plane) [[ ${COMP_WORDS[1]} == section ]] && return ;;
    --stable)
      mapfile -t COMPREPLY < <(compgen -W "1 2 3" -- "$word")
      return
      ;;
    --unstable)
      mapfile -t COMPREPLY < <(compgen -W "1 2" -- "$word")
      return
      ;;
    --memory | --value | --radius | --pieces | --shape | --simplify | --ratio | --ball | --within | --translate | --direction | --prime | --threads | --timeout | --seed | --weld | --point | --line | --flatten | --distance | --precision | --base | --limit) return ;;
  esac
  if [[ $word == -* ]]; then
    local options="$common"
    case "${COMP_WORDS[1]}" in
      union | intersection | difference | xor | csg | repair | convert | view | hull | decompose) options+=" $makes" ;;
      minkowski | erode) options+=" $makes --ball --within --inner" ;;
      gaussian-map) options+=" $draws --cube" ;;
      homology) options+=" --prime" ;;
      persistence) options+=" --prime --barcode -o --output" ;;
      delaunay) options+=" -o --output --format --input-format --plane --memory --weighted --check --delone" ;;
      voronoi) options+=" -o --output --format --input-format --plane --memory --weighted --cells --exact" ;;
      alpha)
        options+=" -o --output --format --input-format --plane --memory --weighted --value --radius --pieces --values --exact --graph --persistence --prime --barcode"
        ;;
      flow) options+=" -o --output --format --input-format --plane --memory --stable --unstable --shape --simplify --reconstruct --ratio --separate" ;;
      assembly)
        options+=" -o --output --format --sequence --sequence-only --infinitesimal --direction --one-part --base --prune --limit"
        ;;
      distance) options+=" --translate --direction --path -o --output" ;;
      classify) options+=" --point --points --line" ;;
      section) options+=" --plane -o --output" ;;
      arrange) options+=" $draws --sphere" ;;
      overlay) options+=" $draws" ;;
      locate) options+=" $draws --point --points" ;;
      polygon) options+=" $draws --fill --flatten --plain --distance --precision --inner --tight --reflect" ;;
      constrained) options+=" $draws --points --inside --flatten" ;;
      envelope) options+=" -o --output --format --labels --upper --flatten" ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
    return
  fi
  local prefix=""
  if [[ ${COMP_WORDS[1]} == csg && $word == *=* ]]; then
    prefix="${word%%=*}="
    word="${word#*=}"
  fi
  mapfile -t COMPREPLY < <(compgen -f -P "$prefix" -- "$word")
  compopt -o filenames 2> /dev/null || true
}
complete -F _quoin quoin
