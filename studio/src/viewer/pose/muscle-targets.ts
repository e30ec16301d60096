import { type MuscleDriver, muscleOffsets } from 'furrow'
import { morphNormalDeltas } from 'furrow/internal'
import { coordinates, trianglesOf } from 'furrow/internal/three'
import { addMuscles } from 'furrow/three'
import type { BufferAttribute, BufferGeometry, Mesh } from 'three'

/** For each muscle, adds a blendshape to the meshes of a face, and updates it when the muscle changes. */
export class MuscleTargets {
  readonly #meshes: readonly Mesh[]
  /** Muscles for which this class has added blendshapes. The keys are their names. */
  readonly #added = new Map<string, MuscleDriver>()

  constructor(meshes: readonly Mesh[]) {
    this.#meshes = meshes
  }

  /** Adds, updates and removes the blendshapes of muscles. */
  update(muscles: readonly MuscleDriver[]): void {
    for (const name of this.#added.keys()) {
      if (muscles.some((muscle) => muscle.name === name)) continue
      removeTarget(this.#meshes, name)
      this.#added.delete(name)
    }
    const [{ morphTargetDictionary: known = {} }] = this.#meshes
    const added = muscles.filter(({ name }) => known[name] === undefined)
    for (const mesh of this.#meshes) addMuscles(mesh, added)
    for (const muscle of added) this.#added.set(muscle.name, muscle)
    for (const muscle of muscles) {
      const before = this.#added.get(muscle.name)
      if (!before || JSON.stringify(before) === JSON.stringify(muscle)) continue
      for (const mesh of this.#meshes) updateMuscle(mesh, muscle)
      this.#added.set(muscle.name, muscle)
    }
  }
}

/** Removes a blendshape. This changes the indices of other blendshapes. */
function removeTarget(meshes: readonly Mesh[], name: string): void {
  const indices = new Map<BufferGeometry, number>()
  for (const { geometry, morphTargetDictionary: dictionary, morphTargetInfluences } of meshes) {
    const index = dictionary?.[name]
    if (index === undefined) continue
    indices.set(geometry, index)
    morphTargetInfluences!.splice(index, 1)
    delete dictionary![name]
    for (const other of Object.keys(dictionary!)) if (dictionary![other] > index) dictionary![other]--
  }
  // Meshes can share a geometry.
  for (const [geometry, index] of indices) {
    for (const offsets of Object.values(geometry.morphAttributes)) offsets?.splice(index, 1)
    geometry.dispose()
  }
}

function updateMuscle({ geometry, morphTargetDictionary }: Mesh, muscle: MuscleDriver): void {
  const index = morphTargetDictionary![muscle.name]
  const positions = coordinates(geometry.getAttribute('position'))
  const offsets = muscleOffsets(muscle, positions)
  write(geometry, 'position', index, positions, offsets)
  if (geometry.morphAttributes.normal?.[index]) {
    const normals = coordinates(geometry.getAttribute('normal'))
    const changes = morphNormalDeltas({ positions, normals, triangles: trianglesOf(geometry) })
    write(geometry, 'normal', index, normals, changes(offsets))
  }
  // Renderers cache all blendshapes of a geometry in a texture. Make them create this texture again.
  geometry.dispose()
}

function write(
  geometry: BufferGeometry,
  name: 'position' | 'normal',
  index: number,
  rest: ArrayLike<number>,
  offsets: Float32Array,
): void {
  const base = geometry.morphTargetsRelative ? null : rest
  const attribute = geometry.morphAttributes[name]![index] as BufferAttribute
  attribute.array.set(base ? offsets.map((offset, i) => offset + base[i]) : offsets)
  attribute.needsUpdate = true
}
