import { BufferAttribute, BufferGeometry, type Mesh, MeshBasicMaterial, Vector3 } from 'three'
import { coordinates, trianglesOf } from '../three/sources/geometry-arrays.ts'
import { movingCopy } from './moving-copy.ts'
import { PoseWatch } from './pose-watch.ts'
import { strainColour, strainOf } from './strain.ts'

/** Draws the strain of a face's skin. Copies of the meshes follow the pose of the face, and have the strain as vertex colours. */
export class StrainView {
  readonly #parts: { mesh: Mesh; copy: Mesh; rest: Float32Array; indices: ArrayLike<number> }[]
  readonly #material = new MeshBasicMaterial({ vertexColors: true, toneMapped: false })
  readonly #watch: PoseWatch

  /** Adds a copy of each mesh to the mesh's parent. The copies are invisible until `visible` is set. */
  constructor(meshes: readonly Mesh[]) {
    this.#watch = new PoseWatch(meshes)
    this.#parts = meshes.map((mesh) => {
      const copy = movingCopy(mesh, this.#material)
      copy.name = 'strain'
      copy.geometry = geometryOf(mesh.geometry)
      const { geometry } = mesh
      return { mesh, copy, rest: coordinates(geometry.attributes.position), indices: trianglesOf(geometry) }
    })
  }

  set visible(visible: boolean) {
    for (const { copy } of this.#parts) copy.visible = visible
  }

  /** Updates the colours if the pose has changed. */
  follow(): void {
    if (!this.#watch.hasChanged()) return
    const point = new Vector3()
    for (const { mesh, copy, rest, indices } of this.#parts) {
      const posed = new Float32Array(rest.length)
      for (let i = 0; i < rest.length / 3; i++) mesh.getVertexPosition(i, point).toArray(posed, 3 * i)
      const colours = copy.geometry.attributes.color as BufferAttribute
      for (const [i, strain] of strainOf(rest, posed, indices).entries())
        colours.setXYZ(i, ...strainColour(strain))
      colours.needsUpdate = true
    }
  }

  dispose(): void {
    for (const { copy } of this.#parts) {
      copy.removeFromParent()
      copy.geometry.dispose()
    }
    this.#material.dispose()
  }
}

/** Copies a geometry for drawing strain. Attributes are not shared, because disposing of a geometry frees its attributes on the GPU. */
function geometryOf({
  attributes,
  morphAttributes,
  morphTargetsRelative,
  index,
}: BufferGeometry): BufferGeometry {
  const geometry = new BufferGeometry()
  const { position, skinIndex, skinWeight } = attributes
  geometry.setAttribute('position', new BufferAttribute(coordinates(position), 3))
  geometry.setAttribute('color', new BufferAttribute(new Float32Array(3 * position.count), 3))
  if (skinIndex && skinWeight) {
    geometry.setAttribute('skinIndex', new BufferAttribute(Uint16Array.from(coordinates(skinIndex, 4)), 4))
    geometry.setAttribute('skinWeight', new BufferAttribute(coordinates(skinWeight, 4), 4))
  }
  if (morphAttributes.position) geometry.morphAttributes.position = morphAttributes.position
  geometry.morphTargetsRelative = morphTargetsRelative
  if (index) geometry.setIndex(index.clone())
  return geometry
}
