import type { Material, Mesh, Sphere, Texture } from 'three'
import { FurrowError } from '../../core/error.ts'
import { HeightField, weightedTexels } from '../../relief/height-fields.ts'
import { TOLERANCES } from '../../relief/needed-halvings.ts'
import { SPLIT_DEFAULTS } from '../../relief/split-mesh.ts'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import { instancesOf } from '../mesh/instances.ts'
import { CoarsePass } from './coarse-pass.ts'
import { type Raised, ringTexture, type Split, splitGeometry } from './dense-geometry.ts'
import { checkReach, createHeightMaps, type HeightMaps } from './height-maps.ts'
import type { MeshUnits } from './mesh-units.ts'
import { outlinesOf } from './outlines-of.ts'
import type { RaisedFace } from './raised-face.ts'
import type { ReliefInputs } from './relief-inputs.ts'
import { createReliefMesh } from './relief-mesh.ts'
import type { ReliefParts } from './relief-parts.ts'
import { inSlices } from './slices.ts'
import { StandIn } from './stand-in.ts'

/** The face whose relief it is. */
export interface ReliefHost {
  readonly face: RaisedFace
  readonly units: MeshUnits
  /** Called during a frame if a shader cannot draw the relief: it is then to be dropped. */
  refuse(error: unknown): void
}

/** The dense geometry of one mesh, and the texel of its first vertex in the coarse textures. */
type MeshSplit = Split & { mesh: Mesh; first: number }

/** The relief of one face: dense geometries that are drawn in place of its meshes. */
export class Relief {
  /** 0 = the meshes as they are, 1 = full relief. */
  readonly amount = { value: 0 }
  /** Pixels per metre in the picture being drawn. */
  pixelsPerMetre = Infinity
  /** Why it is not as fine as it should be; null if it is. */
  readonly limitation: FurrowError | null
  readonly #host: ReliefHost
  readonly #parts: ReliefParts
  readonly #heights: HeightMaps
  readonly #ring: Texture
  readonly #pass: CoarsePass
  readonly #inputs: ReliefInputs
  readonly #standIns: StandIn[]
  readonly #onDispose: (() => void)[] = []
  #isRefused = false

  private constructor(
    host: ReliefHost,
    parts: ReliefParts,
    heights: HeightMaps,
    splits: readonly MeshSplit[],
  ) {
    this.#host = host
    this.#parts = parts
    this.#heights = heights
    this.limitation = longEdges(splits)
    this.#ring = ringTexture(splits)
    this.#pass = new CoarsePass(splits, this.#ring, parts)
    const [positions, directions] = this.#pass.target.textures
    this.#inputs = {
      heights,
      coarse: { positions, directions },
      unitsPerMetre: 1 / host.units.deformed,
      amount: this.amount,
      refuse: (error) => {
        this.#isRefused = true
        host.refuse(error)
      },
    }
    this.#standIns = splits.flatMap((split) => this.#standInsOf(split))
  }

  /**
   * Splits the meshes of a face, in slices.
   *
   * @param isWanted asked now and then; the work ends when it no longer is, and the result is null.
   * @throws FurrowError when the meshes or the heights are not fit for it.
   */
  static async create(host: ReliefHost, parts: ReliefParts, isWanted: () => boolean): Promise<Relief | null> {
    const { face, units } = host
    const { meshes, shaderInputs } = face
    const { material } = face.material
    for (const mesh of meshes) checkPositions(mesh)
    const heights = await createHeightMaps(shaderInputs.textures.layers)
    try {
      checkReach(heights, units.atRest * Math.max(...meshes.map(radiusOf)))
      const raised = raisedBy(shaderInputs, heights)
      const splits: MeshSplit[] = []
      let first = 0
      for (const mesh of meshes) {
        const { reach } = heights
        const map = heights.texture.image as { width: number; height: number }
        const request = { mesh, material, raised, first, metresPerUnit: units.atRest, reach, map }
        const split = await inSlices(splitGeometry(request), isWanted)
        if (!split) break
        splits.push({ ...split, mesh, first })
        first += split.next.length
      }
      if (splits.length === meshes.length) return new Relief(host, parts, heights, splits)
    } catch (error) {
      heights.dispose()
      throw error
    }
    heights.dispose()
    return null
  }

  /** Makes the material draw it; for `PatchedMaterial`. */
  patch(material: Material): () => void {
    const { mesh, shaderInputs } = this.#host.face
    return this.#parts.patch(material, this.#inputs, shaderInputs, instancesOf(mesh))
  }

  /** Draws the dense geometries from now on, or the meshes themselves. Not to be called during a frame. */
  show(isShown: boolean): void {
    // Those of one mesh hook into each other, and must let go in turn.
    for (const standIn of isShown ? this.#standIns : this.#standIns.toReversed()) standIn.show(isShown)
  }

  /** Takes over how the meshes are drawn, from the next frame on. */
  follow(): void {
    for (const standIn of this.#standIns) standIn.follow()
  }

  dispose(): void {
    this.show(false)
    for (const free of this.#onDispose) free()
    this.#pass.dispose()
    this.#ring.dispose()
    this.#heights.dispose()
  }

  /** Of its surface, and of the outlines round it. */
  #standInsOf(split: MeshSplit): StandIn[] {
    const { shaderInputs } = this.#host.face
    const { material } = this.#host.face.material
    const { mesh, geometry } = split
    this.#onDispose.push(() => geometry.dispose())
    const outlines = outlinesOf(mesh, material).flatMap((own) => {
      const copy = this.#parts.outlineMaterial(own, this.#inputs, shaderInputs, instancesOf(mesh))
      if (!copy) return []
      this.#onDispose.push(() => copy.dispose())
      return this.#standInOf(split, own, copy)
    })
    return [this.#standInOf(split, material, material), ...outlines]
  }

  /**
   * @param material of the mesh.
   * @param drawn what is drawn with instead.
   */
  #standInOf({ mesh, geometry }: MeshSplit, material: Material, drawn: Material): StandIn {
    const { face } = this.#host
    const dense = createReliefMesh(mesh, geometry, drawn)
    this.#onDispose.push(
      this.#parts.dressShadow(dense, mesh, this.#inputs, face.shaderInputs, instancesOf(mesh)),
    )
    return new StandIn(mesh, dense, {
      material,
      isOn: () => !this.#isRefused && face.mode !== 'off',
      prepare: (renderer, camera, drawn) => face.prepare(renderer, camera, drawn),
      deform: (renderer, isShadow) => {
        if (isShadow) this.#parts.duringShadow(renderer, () => this.#pass.update(renderer))
        else this.#pass.update(renderer)
      },
      version: () => versionFor(this.pixelsPerMetre),
    })
  }
}

/** Pixels by which a surface may miss its heights: another version of it then differs by less than one. */
const MOST_PIXELS = 0.45

/** The coarsest version of a surface that is fine enough: edges of triangles cost more than what they show, see bench/README.md. */
function versionFor(pixelsPerMetre: number): number {
  const tooCoarse = TOLERANCES.findIndex((tolerance) => tolerance * pixelsPerMetre > MOST_PIXELS)
  return tooCoarse < 0 ? TOLERANCES.length - 1 : Math.max(tooCoarse - 1, 0)
}

/** @throws FurrowError when positions of a mesh are no numbers. */
function checkPositions(mesh: Mesh): void {
  if (Number.isFinite(radiusOf(mesh))) return
  throw new FurrowError({
    who: `Wrinkles.relief of mesh "${mesh.name}"`,
    problem: 'the mesh has positions that are not numbers',
    remedy: 'export it again; it is shown without relief until then',
  })
}

function raisedBy({ areas }: ShaderInputs, { array, layers }: HeightMaps): Raised {
  const { texture, slots, channels, width, height } = areas
  const { data, depth } = texture.image as { data?: Uint8Array; depth: number }
  // Compressed areas are on the graphics card only.
  const weights = channels === 1 && data ? { data, width, height, depth, channels } : null
  const raised = layers.map((own) => ({
    ...own,
    areas: slots.flatMap(({ layer, slice }) => (layer === own.layer ? slice : [])),
  }))
  if (array) return raised.map((layer) => new HeightField(layer, array, weights))
  const slices = raised.flatMap((layer) => layer.areas)
  return weights && weightedTexels(weights, slices)
}

function radiusOf({ geometry }: Mesh): number {
  if (geometry.boundingSphere === null) geometry.computeBoundingSphere()
  return (geometry.boundingSphere as Sphere).radius
}

/** The first mesh whose edges are longer than they should be, so as not to be too many. */
function longEdges(splits: readonly MeshSplit[]): FurrowError | null {
  const long = splits.find(({ edge }) => edge > SPLIT_DEFAULTS.edge)
  if (!long) return null
  const millimetres = (length: number) => `${(1000 * length).toPrecision(2)} mm`
  return new FurrowError({
    code: 'out-of-range',
    who: `Wrinkles.relief of mesh "${long.mesh.name}"`,
    problem: `more than ${SPLIT_DEFAULTS.budget} triangles, so their edges are longer`,
    value: millimetres(long.edge),
    limit: millimetres(SPLIT_DEFAULTS.edge),
    remedy: 'let fewer areas be on layers with heights',
  })
}
