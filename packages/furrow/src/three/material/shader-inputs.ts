import { type Texture, Vector2, Vector3, Vector4 } from 'three'
import type { Cell } from '../../runtime/atlas-cells.ts'
import { findReach, reachAll, reachNothing } from '../../runtime/reach.ts'
import type { AreaArray } from '../atlas/area-array.ts'
import type { InfluenceAtlas } from '../atlas/influence-atlas.ts'
import type { ActivationTable } from './activation-table.ts'
import type { PaperArray } from './paper-array.ts'
import { release, retain } from './texture-users.ts'
import { listTextures, type WrinkleTextures } from './wrinkle-textures.ts'

/**
 * Uniforms of the shaders that show the wrinkles of one mesh. Shaders keep references to the `{ value }` objects, which must not be replaced.
 * The influence atlas is a texture with one cell per face. The cell holds in UV space how strongly each layer of wrinkles is visible.
 */
export interface ShaderInputs {
  readonly textures: WrinkleTextures
  areas: AreaArray
  /** Texture of `areas`, for shaders that loop over all areas. */
  readonly areaTexture: { value: Texture }
  /** Influence atlas. */
  readonly influence: { value: Texture }
  /** Whether the mesh is not instanced, and its cell fills the atlas; see `AtlasCells.isSingle`. */
  isAlone(): boolean
  /** Columns and rows of the atlas, and the index of the mesh's first cell. */
  readonly grid: { value: Vector3 }
  /** Location of the first cell in the atlas, see `AtlasCells.locate`. */
  readonly cell: { value: Vector4 }
  /** Converts texture coordinates to coordinates in the cell, see `AtlasCells.inside`. */
  readonly inside: { value: Vector4 }
  /** Half the size of an atlas texel, relative to a cell. Keeps filtered samples inside the cell of an instance. */
  readonly inset: { value: Vector2 }
  /** UV bounds of the active areas: u0, v0, u1, v1. Empty while the wrinkles are faded out. Unbounded for several instances. */
  readonly reach: { value: Vector4 }
  /** Opacity of the wrinkles, 0 (hidden) to 1. */
  readonly fade: { value: number }
  /** Normal scale per layer. */
  readonly normalScale: { value: Vector4 }
  /** Occlusion strength per layer. */
  readonly occlusionStrength: { value: Vector4 }
  /** Blood amplitude per layer. */
  readonly bloodAmplitude: { value: Vector4 }
  /** Strength of the onset map per layer. */
  readonly onsetStrength: { value: Vector4 }
  /** Textures of the mode `paper`; null until the mode is first used. */
  paper: (PaperArray & { table: ActivationTable }) | null
}

/** Creates the shader inputs of a mesh. Each instance of the mesh is a face with a cell in the atlas. Several meshes may share the textures. */
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
    onsetStrength: textures.onsetStrength,
    paper: null,
  }
  retainShaderInputs(inputs)
  return inputs
}

/** Increments the user counts of the textures, see `retain`. */
export function retainShaderInputs({ textures, areas }: ShaderInputs): void {
  for (const texture of [areas.texture, ...listTextures(textures)]) retain(texture)
}

export function exchangeAreas(inputs: ShaderInputs, areas: AreaArray): void {
  retain(areas.texture)
  release(inputs.areas.texture)
  inputs.areas = areas
  inputs.areaTexture.value = areas.texture
}

/** Decrements the user counts of the textures, and disposes of textures without users. A later draw uploads them again. */
export function releaseShaderInputs({ textures, areas, paper }: ShaderInputs): void {
  for (const texture of [areas.texture, ...listTextures(textures)]) release(texture)
  paper?.texture.dispose()
  paper?.table.texture.dispose()
}

/** Updates two groups of uniforms: the bounds of the active areas, and the location of the cells, which changes when the atlas grows. */
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
