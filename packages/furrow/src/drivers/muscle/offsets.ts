import { dot } from '../../math/vector.ts'
import type { MuscleDriver } from './definition.ts'

type Vector = readonly [number, number, number]

/**
 * Computes the displacement of each vertex at full contraction of a virtual muscle. Displacements are proportional to the contraction, so
 * a muscle can be a morph target.
 *
 * The method is from K. Waters, "A Muscle Model for Animating Three-Dimensional Facial Expression", SIGGRAPH 1987, with two changes.
 * Distances are fractions of the muscle's length. The pull of a linear muscle falls to 0 at the edge of its cone, where Waters' pull
 * jumps to 0.
 *
 * @param positions xyz of each vertex at rest, in metres, in the space of the muscle; not modified.
 * @returns xyz displacement of each vertex; exactly 0 outside the muscle's zone.
 */
export function muscleOffsets(muscle: MuscleDriver, positions: ArrayLike<number>): Float32Array {
  const offsets = new Float32Array(positions.length)
  const pull = PULLS[muscle.kind]
  const axis = minus(muscle.insertion, muscle.origin)
  const length = norm(axis)
  const along: Vector = [axis[0] / length, axis[1] / length, axis[2] / length]
  for (let i = 0; i + 2 < positions.length; i += 3) {
    const from = minus([positions[i], positions[i + 1], positions[i + 2]], muscle.origin)
    const offset = pull(muscle, from, along, length)
    if (offset) for (let k = 0; k < 3; k++) offsets[i + k] = muscle.strength * offset[k]
  }
  return offsets
}

/**
 * Computes the displacement of a vertex for strength 1.
 *
 * @param from vector from the muscle's origin to the vertex, in metres.
 * @param along unit vector from the origin to the insertion.
 * @param length distance from the origin to the insertion, in metres.
 * @returns undefined if the vertex is outside the muscle's zone.
 */
type Pull = (muscle: MuscleDriver, from: Vector, along: Vector, length: number) => Vector | undefined

const PULLS: Record<MuscleDriver['kind'], Pull> = {
  linear(muscle, from, along, length) {
    const distance = norm(from)
    if (distance === 0 || distance >= muscle.outer * length) return undefined
    const edge = Math.cos(muscle.angle)
    const inside = (dot(from, along) / distance - edge) / (1 - edge)
    return inside > 0 ? scaled(from, -inside * rise(muscle, distance / length)) : undefined
  },
  sheet(muscle, from, along, length) {
    const height = dot(from, along)
    const radius = norm(minus(from, scaled(along, height)))
    if (height <= 0 || height >= muscle.outer * length || radius >= muscle.width) return undefined
    const inside = Math.cos((Math.PI / 2) * (radius / muscle.width))
    return scaled(along, -length * inside * rise(muscle, height / length))
  },
  sphincter(muscle, from, along, length) {
    const height = dot(from, along)
    const radius = norm(minus(from, scaled(along, height)))
    const distance = Math.hypot(height / length, radius / muscle.width)
    return distance < muscle.outer ? scaled(from, -fallOff(muscle, distance)) : undefined
  },
}

/** Returns the strength of the pull: 0 at the origin, 1 at `inner`, 0 at `outer`. `distance` is a fraction of the muscle's length. */
function rise(muscle: MuscleDriver, distance: number): number {
  return distance > muscle.inner
    ? fallOff(muscle, distance)
    : Math.sin((Math.PI / 2) * (distance / muscle.inner))
}

function fallOff({ inner, outer }: MuscleDriver, distance: number): number {
  return distance <= inner ? 1 : Math.cos((Math.PI / 2) * ((distance - inner) / (outer - inner)))
}

function minus(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

function scaled(a: Vector, by: number): Vector {
  return [a[0] * by, a[1] * by, a[2] * by]
}

function norm(a: Vector): number {
  return Math.hypot(a[0], a[1], a[2])
}
