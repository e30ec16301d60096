import { type Texture, Vector2, Vector3, Vector4 } from 'three'
import type { Layer } from '../../core/types.ts'
import type { AreaArray } from '../atlas/area-array.ts'
import type { Cell, InfluenceAtlas } from '../atlas/influence-atlas.ts'
import { findReach, reachAll } from '../reach.ts'
import type { ActivationTable } from './activation-table.ts'
import type { PaperArray } from './paper-array.ts'
import type { WrinkleTextures } from './wrinkle-textures.ts'

/** What shaders read, `{ value }` as uniforms; the objects stay the same as long as the wrinkles live. */
export interface WrinkleInputs {
  readonly textures: WrinkleTextures
  /** For shaders that loop over the areas themselves. */
  areas: AreaArray
  readonly areaTexture: { value: Texture }
  /** The atlas of influence maps. */
  readonly influence: { value: Texture }
  /** Columns and rows of its cells, and the number of this mesh's first one. */
  readonly grid: { value: Vector3 }
  /** Half a texel of a cell in 0..1: no sample reaches further out. */
  readonly inset: { value: Vector2 }
  /** Texture coordinates outside of which nothing shows now: u0, v0, u1, v1. */
  readonly reach: { value: Vector4 }
  /** 1 = wrinkles in full, 0 = too far away to show. */
  readonly fade: { value: number }
  /** Per layer: scale of its normals, strength of its occlusion. */
  readonly normalScale: { value: Vector4 }
  readonly occlusionStrength: { value: Vector4 }
  /** In the paper's mode only. */
  paper: (PaperArray & { table: ActivationTable }) | null
}

/** Inputs of a set whose faces stand in an atlas. */
export function createInputs(
  textures: WrinkleTextures,
  areas: AreaArray,
  atlas: InfluenceAtlas,
): WrinkleInputs {
  const perLayer = (number: (layer: Pick<Layer, 'normalScale' | 'occlusionStrength'>) => number) =>
    new Vector4().fromArray([...textures.layers.map(number), 1, 1, 1])
  return {
    textures,
    areas,
    areaTexture: { value: areas.texture },
    influence: { value: atlas.target.texture },
    grid: { value: new Vector3() },
    inset: { value: new Vector2(0.5 / atlas.width, 0.5 / atlas.height) },
    reach: { value: new Vector4() },
    fade: { value: 1 },
    normalScale: { value: perLayer(({ normalScale }) => normalScale ?? 1) },
    occlusionStrength: { value: perLayer(({ occlusionStrength }) => occlusionStrength ?? 1) },
    paper: null,
  }
}

/** Tells the shaders where the cells of a mesh are, since an atlas may have grown, and where anything shows in them. */
export function placeCells(
  { grid, reach, areas }: WrinkleInputs,
  atlas: InfluenceAtlas,
  cells: readonly Cell[],
): void {
  grid.value.set(atlas.grid.columns, atlas.grid.rows, cells[0].index)
  if (cells.length === 1) findReach(areas, cells[0].face.values, reach.value)
  else reachAll(reach.value)
}
