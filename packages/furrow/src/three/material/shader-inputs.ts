import { type Texture, Vector2, Vector3, Vector4 } from 'three'
import type { Cell } from '../../runtime/atlas-cells.ts'
import { findReach, reachAll, reachNothing } from '../../runtime/reach.ts'
import type { AreaArray } from '../atlas/area-array.ts'
import type { InfluenceAtlas } from '../atlas/influence-atlas.ts'
import type { ActivationTable } from './activation-table.ts'
import type { PaperArray } from './paper-array.ts'
import { release, retain } from './texture-users.ts'
import { listTextures, type WrinkleTextures } from './wrinkle-textures.ts'

/** Uniforms of the shaders. Each `{ value }` object keeps its identity for the lifetime of the wrinkles. */
export interface ShaderInputs {
  readonly textures: WrinkleTextures
  areas: AreaArray
  /** Texture of `areas`, for shaders that loop over them. */
  readonly areaTexture: { value: Texture }
  /** Influence atlas. */
  readonly influence: { value: Texture }
  /** Whether the atlas holds a single, non-instanced face; see `AtlasCells.isSingle`. */
  isAlone(): boolean
  /** Columns and rows of the atlas, and the index of the mesh's first cell. */
  readonly grid: { value: Vector3 }
  /** Location of the first cell, see `AtlasCells.locate`. */
  readonly cell: { value: Vector4 }
  /** Transform of texture coordinates to coordinates in the cell, see `AtlasCells.inside`. */
  readonly inside: { value: Vector4 }
  /** Half a texel of a cell, in cell coordinates (0..1). */
  readonly inset: { value: Vector2 }
  /** UV bounds of the active areas: u0, v0, u1, v1. Empty if all wrinkles are faded out. */
  readonly reach: { value: Vector4 }
  /** Opacity, 0 (hidden) to 1. */
  readonly fade: { value: number }
  /** Normal scale per layer. */
  readonly normalScale: { value: Vector4 }
  /** Occlusion strength per layer. */
  readonly occlusionStrength: { value: Vector4 }
  /** Blood amplitude per layer. */
  readonly bloodAmplitude: { value: Vector4 }
  /** Inputs of the paper mode; null in other modes. */
  paper: (PaperArray & { table: ActivationTable }) | null
}

/** Creates shader inputs for faces with cells in an atlas. Textures may be shared with other faces. */
export function createShaderInputs(
  textures: WrinkleTextures,
  areas: AreaArray,
  atlas: InfluenceAtlas,
  isInstanced: boolean,
): ShaderInputs {
  const { cells, target } = atlas
  const inputs: ShaderInputs = {
    textures,
    areas,
    areaTexture: { value: areas.texture },
    influence: { value: target.texture },
    isAlone: () => !isInstanced && cells.isSingle,
    grid: { value: new Vector3() },
    cell: { value: new Vector4() },
    inside: { value: new Vector4().copy(cells.inside as Vector4) },
    inset: { value: new Vector2(0.5 / cells.width, 0.5 / cells.height) },
    reach: { value: new Vector4() },
    fade: { value: 1 },
    normalScale: textures.normalScale,
    occlusionStrength: textures.occlusionStrength,
    bloodAmplitude: textures.bloodAmplitude,
    paper: null,
  }
  retainShaderInputs(inputs)
  return inputs
}

/** Registers a user of the textures. */
export function retainShaderInputs({ textures, areas }: ShaderInputs): void {
  for (const texture of [areas.texture, ...listTextures(textures)]) retain(texture)
}

/** Replaces the area array. */
export function exchangeAreas(inputs: ShaderInputs, areas: AreaArray): void {
  retain(areas.texture)
  release(inputs.areas.texture)
  inputs.areas = areas
  inputs.areaTexture.value = areas.texture
}

/** Disposes of textures without other users. Textures drawn later are uploaded again. */
export function releaseShaderInputs({ textures, areas, paper }: ShaderInputs): void {
  for (const texture of [areas.texture, ...listTextures(textures)]) release(texture)
  paper?.texture.dispose()
  paper?.table.texture.dispose()
}

/** Updates the location of a mesh's cells, because the atlas may grow, and the bounds of its active areas. */
export function locateCells(
  { grid, cell, reach, fade, areas }: ShaderInputs,
  atlas: InfluenceAtlas,
  cells: readonly Cell[],
): void {
  const { columns, rows } = atlas.cells.grid
  const { index, face } = cells[0]
  grid.value.set(columns, rows, index)
  atlas.cells.locate(index, cell.value)
  if (fade.value === 0) reachNothing(reach.value)
  else if (cells.length === 1) findReach(areas, face.activations.values, reach.value)
  else reachAll(reach.value)
}
