import type { Pose } from './evaluate.ts'
import { type Bump, creased, type Field, normalPng, stored } from './paint.ts'

/** Creases of each expression. Those of surprise and anger share the forehead. */
export const CREASES: Readonly<Record<string, Bump[]>> = {
  surprise: [{ u: 0.5, v: 0.25, radius: 0.18, slope: 0.5 }],
  anger: [
    { u: 0.5, v: 0.32, radius: 0.1, slope: 0.6, turn: Math.PI / 2 },
    { u: 0.5, v: 0.85, radius: 0.08, slope: 0.3 },
  ],
  smileLeft: [{ u: 0.7, v: 0.6, radius: 0.12, slope: 0.45, turn: 0.7 }],
  smileRight: [{ u: 0.3, v: 0.6, radius: 0.12, slope: 0.45, turn: -0.7 }],
}

/** Files of an export with one normal map per expression, and its own shading formula. */
export class ExpressionSourceFiles {
  readonly neutral: Field
  readonly maps: ReadonlyMap<string, Field>

  constructor(size: number, creases = CREASES) {
    this.neutral = creased(size, 1, [])
    this.maps = new Map(Object.entries(creases).map(([name, bumps]) => [name, creased(size, 1, bumps)]))
  }

  async files(): Promise<Record<string, Uint8Array>> {
    const entries = await Promise.all(
      [...this.maps].map(async ([name, map]) => [`${name}.png`, await normalPng(map)] as const),
    )
    return { 'neutral.png': await normalPng(this.neutral), ...Object.fromEntries(entries) }
  }

  /** Returns the normals of a pose: the neutral map, plus the difference of each expression times its weight. */
  shade(pose: Pose): Float64Array {
    const neutral = stored(this.neutral).data
    const normals = neutral.slice()
    for (const [name, map] of this.maps) {
      const { data } = stored(map)
      for (let i = 0; i < data.length; i++) normals[i]! += (pose[name] ?? 0) * (data[i]! - neutral[i]!)
    }
    return normalised(normals)
  }
}

export function normalised(normals: Float64Array): Float64Array {
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i]!, normals[i + 1]!, normals[i + 2]!)
    for (let k = 0; k < 3; k++) normals[i + k]! /= length
  }
  return normals
}
