import type { Landmarks } from '../../../packages/furrow/src/author/auto/surface/landmarks.ts'
import { prepareSkin } from '../../../packages/furrow/src/author/auto/surface/prepare-skin.ts'
import { skinAt } from '../../../test/skin-at.ts'

/** Landmarks of a head, and a conversion of positions on its skin to the units of its file. */
export interface HeadFrame {
  landmarks: Landmarks
  /** Millimetres per unit of the file. */
  scale: number
  /** Returns the point of the skin nearest to a position in face coordinates, moved by an expression, in the file's coordinates. */
  pointAt(near: readonly number[], expression: Readonly<Record<string, number>>): [number, number, number]
}

export async function headFrame(path: string): Promise<HeadFrame> {
  const { skin, face } = prepareSkin(await skinAt(path))
  if (!face) throw new Error(`sheets: no face was detected, got ${path}`)
  const { surface, landmarks, scale, find } = face
  const vertexOf = new Map([...surface.pointOf].map((point, vertex) => [point, vertex]))
  return {
    landmarks,
    scale,
    pointAt(near, expression) {
      let [best, least] = [0, Number.POSITIVE_INFINITY]
      for (const point of vertexOf.keys()) {
        const distance = [0, 1, 2].reduce(
          (sum, k) => sum + (surface.points[3 * point + k]! - near[k]!) ** 2,
          0,
        )
        if (distance < least) [best, least] = [point, distance]
      }
      const vertex = vertexOf.get(best)!
      const at = (k: number) =>
        Object.entries(expression).reduce(
          (sum, [name, weight]) =>
            find(name).reduce(
              (sum, target) => sum + weight * skin.targets[target]!.offsets[3 * vertex + k]!,
              sum,
            ),
          skin.positions[3 * vertex + k]!,
        )
      return [at(0), at(1), at(2)]
    },
  }
}
