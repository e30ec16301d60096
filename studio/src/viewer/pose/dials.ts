import { canonicalTargetName } from 'furrow/internal'
import type { Mesh, Object3D } from 'three'
import type { Wrinkles } from '../../../../stage/stage.ts'

/** Number that a slider controls, usually 0..1. */
export interface Dial {
  readonly name: string
  read(): number
  write(value: number): void
}

/** Blendshapes of one region of the face. */
export interface ShapeGroup<T extends { readonly name: string }> {
  readonly name: string
  readonly shapes: T[]
}

/** Groups of blendshapes in display order, each with the prefixes of its blendshape names. The last group contains all other blendshapes. */
const GROUPS: readonly [name: string, prefix: RegExp][] = [
  ['Brows', /^brow/i],
  ['Eyes', /^eye/i],
  ['Cheeks & nose', /^(cheek|nose)/i],
  ['Mouth', /^mouth/i],
  ['Jaw', /^jaw/i],
  ['Tongue', /^tongue/i],
  ['Other', /^/],
]

export function areaDials(wrinkles: Wrinkles): Dial[] {
  return wrinkles.areaNames.map((name) => ({
    name,
    // The slider of a removed area exists until the next render.
    read: () => (wrinkles.hasArea(name) ? wrinkles.getActivation(name) : 0),
    write: (value) => wrinkles.setActivation(name, value),
  }))
}

/** Blendshape in one mesh. */
interface Binding {
  /** Indices of all blendshapes of the mesh. The keys are their names. */
  indices: Record<string, number>
  /** Name of this blendshape, as the mesh spells it. */
  spelling: string
  /** Weights of all blendshapes of the mesh. */
  weights: number[]
}

/** Makes a dial for each blendshape. The dial moves all meshes that have the blendshape, such as skin, teeth and tongue. */
export function targetDials(root: Object3D): Dial[] {
  const bindings = new Map<string, Binding[]>()
  root.traverse((object) => {
    const { morphTargetDictionary: indices, morphTargetInfluences: weights } = object as Mesh
    if (!indices || !weights) return
    for (const spelling of Object.keys(indices)) {
      const name = canonicalTargetName(spelling)
      bindings.set(name, [...(bindings.get(name) ?? []), { indices, spelling, weights }])
    }
  })
  return [...bindings].map(([name, targets]) => ({
    name,
    // Look up the index each time, because removing a muscle's blendshape changes indices. The slider of a removed blendshape exists until the next render.
    read: () => {
      const [{ indices, spelling, weights }] = targets
      return weights[indices[spelling]] ?? 0
    },
    write: (value) => {
      for (const { indices, spelling, weights } of targets) {
        if (spelling in indices) weights[indices[spelling]] = value
      }
    },
  }))
}

export function groupShapes<T extends { readonly name: string }>(shapes: readonly T[]): ShapeGroup<T>[] {
  const groups = GROUPS.map(([name]) => ({ name, shapes: [] as T[] }))
  for (const shape of shapes)
    groups[GROUPS.findIndex(([, prefix]) => prefix.test(shape.name))].shapes.push(shape)
  return groups.filter((group) => group.shapes.length > 0)
}
