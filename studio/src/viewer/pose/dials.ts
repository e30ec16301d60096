import { canonicalTargetName } from 'furrow/internal'
import type { Mesh, Object3D } from 'three'
import type { Wrinkles } from '../../../../stage/stage.ts'

/** A number in 0..1 that a slider shows and sets. */
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

/** Groups of blendshapes by the prefixes of their names, in the order in which they are shown. The last takes the rest. */
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
    // An area that was removed may have a slider until the next render.
    read: () => (wrinkles.hasArea(name) ? wrinkles.getActivation(name) : 0),
    write: (value) => wrinkles.setActivation(name, value),
  }))
}

/** A blendshape of a mesh: its index by its name there, and the weights by index. */
interface Binding {
  indices: Record<string, number>
  spelling: string
  weights: number[]
}

/** One dial per blendshape for all meshes that have it: skin, eyes, teeth and tongue move together. */
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
    // A muscle that was removed may have a slider until the next render, and changes the indices of others.
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

/** Groups blendshapes by region, in the order in which regions are shown. */
export function groupShapes<T extends { readonly name: string }>(shapes: readonly T[]): ShapeGroup<T>[] {
  const groups = GROUPS.map(([name]) => ({ name, shapes: [] as T[] }))
  for (const shape of shapes)
    groups[GROUPS.findIndex(([, prefix]) => prefix.test(shape.name))].shapes.push(shape)
  return groups.filter((group) => group.shapes.length > 0)
}
