import { type Texture, Vector2, Vector3, Vector4 } from 'three'
import type { Cell } from '../../runtime/atlas-cells.ts'
import { findReach, reachAll, reachNothing } from '../../runtime/reach.ts'
import type { AreaArray } from '../atlas/area-array.ts'
import type { InfluenceAtlas } from '../atlas/influence-atlas.ts'
import type { ActivationTable } from './activation-table.ts'
import type { PaperArray } from './paper-array.ts'
import { release, retain } from './texture-users.ts'
import { listTextures, type WrinkleTextures } from './wrinkle-textures.ts'

/** What shaders read, as uniforms `{ value }`. The objects stay the same for the lifetime of the wrinkles. */
export interface ShaderInputs {
  readonly textures: WrinkleTextures
  areas: AreaArray
  /** Their texture, for shaders that loop over the areas. */
  readonly areaTexture: { value: Texture }
  /** The atlas of influence maps. */
  readonly influence: { value: Texture }
  /** Whether that is the map of one face, which is no instance, see `AtlasCells.isSingle`. */
  isAlone(): boolean
  /** Columns and rows of its cells, and the index of this mesh's first cell. */
  readonly grid: { value: Vector3 }
  /** Where that cell is, see `AtlasCells.locate`. */
  readonly cell: { value: Vector4 }
  /** What takes texture coordinates there, see `AtlasCells.inside`. */
  readonly inside: { value: Vector4 }
  /** Half a texel of a cell, in 0..1. */
  readonly inset: { value: Vector2 }
  /** Texture coordinates outside which there are no wrinkles now: u0, v0, u1, v1. Empty where all are faded out. */
  readonly reach: { value: Vector4 }
  /** 1 = not faded, 0 = too far away to show wrinkles. */
  readonly fade: { value: number }
  /** Scale of normals, per layer. */
  readonly normalScale: { value: Vector4 }
  /** Strength of occlusion, per layer. */
  readonly occlusionStrength: { value: Vector4 }
  /** Amplitude of blood, per layer. */
  readonly bloodAmplitude: { value: Vector4 }
  /** In the paper's mode only. */
  paper: (PaperArray & { table: ActivationTable }) | null
}

/** Creates the inputs of a set whose faces have cells in an atlas. Other faces may use the same textures. */
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

/** Counts a face as a user of the textures. */
export function retainShaderInputs({ textures, areas }: ShaderInputs): void {
  for (const texture of [areas.texture, ...listTextures(textures)]) retain(texture)
}

/** Takes other areas. */
export function exchangeAreas(inputs: ShaderInputs, areas: AreaArray): void {
  retain(areas.texture)
  release(inputs.areas.texture)
  inputs.areas = areas
  inputs.areaTexture.value = areas.texture
}

/** Frees the textures that no other face uses. Textures that are drawn afterwards are uploaded again. */
export function releaseShaderInputs({ textures, areas, paper }: ShaderInputs): void {
  for (const texture of [areas.texture, ...listTextures(textures)]) release(texture)
  paper?.texture.dispose()
  paper?.table.texture.dispose()
}

/** Updates where the cells of a mesh are, since an atlas may grow, and where there are active areas in them. */
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
