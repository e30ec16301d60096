import { type Material, type Mesh, MeshNormalMaterial, type MeshStandardMaterial } from 'three'
import type { WrinklesBase } from '../three/wrinkles-base.ts'
import { movingCopy } from './moving-copy.ts'
import { StrainView } from './strain-view.ts'

/** Ways to draw a face. `shaded` uses the face's material; the other views show technical data. */
export const VIEWS = ['shaded', 'influence', 'normals', 'strain', 'wireframe'] as const
export type View = (typeof VIEWS)[number]

/** Views that draw a copy of each mesh. Instanced meshes do not support them. */
const COPYING: readonly View[] = ['normals', 'strain']

/** Returns the views that a face supports. */
export function viewsOf(wrinkles: WrinklesBase): readonly View[] {
  return wrinkles.faceCount === 1 ? VIEWS : VIEWS.filter((view) => !COPYING.includes(view))
}

/** A view that is currently drawn. */
interface ShownView {
  /** Updates the view to the current state of the face. Called in each animation frame. */
  follow?(): void
  /** Removes the view and restores the face. */
  end(): void
}

/** Draws a face in one of the views. */
export class FaceView {
  readonly #wrinkles: WrinklesBase
  #shown: ShownView | null = null
  #view: View = 'shaded'

  constructor(wrinkles: WrinklesBase) {
    this.#wrinkles = wrinkles
  }

  get view(): View {
    return this.#view
  }

  set view(view: View) {
    this.dispose()
    const show = { shaded: null, influence, normals, strain, wireframe }[view]
    this.#shown = show?.(this.#wrinkles) ?? null
    this.#view = view
  }

  /** Updates the view; called in each animation frame. */
  follow(): void {
    this.#shown?.follow?.()
  }

  /** Restores the original materials of the face. */
  dispose(): void {
    this.#shown?.end()
    this.#shown = null
    this.#view = 'shaded'
  }
}

function influence(wrinkles: WrinklesBase): ShownView {
  return { end: replaceMaterials(wrinkles, wrinkles.createInfluenceMaterial()) }
}

/** Draws copies of the meshes in the colours of their normals. The copies have the wrinkles and activations of the meshes. */
function normals(wrinkles: WrinklesBase): ShownView {
  const plain = [wrinkles.cloneMaterial()].flat()
  const { normalMap, normalScale, side } = plain.find((own) => 'normalMap' in own) as MeshStandardMaterial
  for (const own of plain) if (![wrinkles.mesh.material].flat().includes(own)) own.dispose()
  const material = new MeshNormalMaterial({ normalMap, normalScale, side })
  const reveal = hide(wrinkles)
  const copies = wrinkles.meshes.map((mesh) => movingCopy(mesh, material))
  const Wrinkles = wrinkles.constructor as new (mesh: Mesh, source: WrinklesBase) => WrinklesBase
  const mirror = new Wrinkles(copies[0], wrinkles)
  for (const copy of copies.slice(1)) mirror.addMesh(copy)
  for (const copy of copies) copy.visible = true
  mirror.driven = false
  return {
    follow() {
      for (const name of mirror.areaNames)
        if (wrinkles.hasArea(name)) mirror.setActivation(name, wrinkles.getActivation(name))
    },
    end() {
      mirror.dispose()
      material.dispose()
      for (const copy of copies) copy.removeFromParent()
      reveal()
    },
  }
}

/** Draws the strain of the skin in colours: orange where it is compressed, blue where it is stretched. */
function strain(wrinkles: WrinklesBase): ShownView {
  const reveal = hide(wrinkles)
  const view = new StrainView(wrinkles.meshes)
  view.visible = true
  return {
    follow: () => view.follow(),
    end() {
      view.dispose()
      reveal()
    },
  }
}

/** Draws the edges of all triangles, including the triangles of relief. */
function wireframe({ meshes }: WrinklesBase): ShownView {
  const materials = new Set(meshes.flatMap(({ material }) => material))
  const drawn = [...materials].filter(
    (material): material is MeshStandardMaterial => 'wireframe' in material && !material.wireframe,
  )
  const set = (isWireframe: boolean) => {
    for (const material of drawn) Object.assign(material, { wireframe: isWireframe, needsUpdate: true })
  }
  set(true)
  return { end: () => set(false) }
}

/**
 * Makes the meshes invisible by a material that writes nothing. They must still be drawn, because drivers run before each draw. Returns a
 * function that makes the meshes visible again.
 */
function hide(wrinkles: WrinklesBase): () => void {
  const material = wrinkles.createInfluenceMaterial()
  material.colorWrite = material.depthWrite = false
  return replaceMaterials(wrinkles, material)
}

/** Draws the meshes with one material. Returns a function that restores the original materials and disposes of the new one. */
function replaceMaterials({ meshes }: WrinklesBase, material: Material): () => void {
  const originals = meshes.map((mesh) => ({ mesh, original: mesh.material }))
  for (const mesh of meshes) mesh.material = material
  return () => {
    // A mesh keeps its material if the page has replaced `material` in the meantime.
    for (const { mesh, original } of originals) if (mesh.material === material) mesh.material = original
    material.dispose()
  }
}
