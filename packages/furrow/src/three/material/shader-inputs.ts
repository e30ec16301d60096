import { type Texture, Vector2, Vector3, Vector4 } from 'three'
import type { Layer } from '../../core/types.ts'
import type { Cell } from '../../runtime/atlas-cells.ts'
import { findReach, reachAll } from '../../runtime/reach.ts'
import type { AreaArray } from '../atlas/area-array.ts'
import type { InfluenceAtlas } from '../atlas/influence-atlas.ts'
import type { ActivationTable } from './activation-table.ts'
import type { PaperArray } from './paper-array.ts'
import type { WrinkleTextures } from './wrinkle-textures.ts'

/** What shaders read, as uniforms `{ value }`; the objects stay the same as long as the wrinkles exist. */
export interface ShaderInputs {
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
export function createShaderInputs(
  textures: WrinkleTextures,
  areas: AreaArray,
  atlas: InfluenceAtlas,
): ShaderInputs {
  const { cells, target } = atlas
  const perLayer = (number: (layer: Pick<Layer, 'normalScale' | 'occlusionStrength'>) => number) =>
    new Vector4().fromArray([...textures.layers.map(number), 1, 1, 1])
  return {
    textures,
    areas,
    areaTexture: { value: areas.texture },
    influence: { value: target.texture },
    grid: { value: new Vector3() },
    inset: { value: new Vector2(0.5 / cells.width, 0.5 / cells.height) },
    reach: { value: new Vector4() },
    fade: { value: 1 },
    normalScale: { value: perLayer(({ normalScale }) => normalScale ?? 1) },
    occlusionStrength: { value: perLayer(({ occlusionStrength }) => occlusionStrength ?? 1) },
    paper: null,
  }
}

/** Tells the shaders where the cells of a mesh are, since an atlas may have grown, and where anything shows in them. */
export function placeCells(
  { grid, reach, areas }: ShaderInputs,
  {
    cells: {
      grid: { columns, rows },
    },
  }: InfluenceAtlas,
  cells: readonly Cell[],
): void {
  grid.value.set(columns, rows, cells[0].index)
  if (cells.length === 1) findReach(areas, cells[0].face.activations.values, reach.value)
  else reachAll(reach.value)
}
