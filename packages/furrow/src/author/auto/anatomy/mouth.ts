import { type Build, bezier, type Guide, grown, type Region, SIDES, type Side, spotOf } from './region.ts'

/** Round the mouth: the fold from the nose, lines beside the corners, and upright ones on the lips. */
export function mouth(build: Build): Region[] {
  return [
    ...SIDES.flatMap(([side, name]) => [nasolabial(build, side, name), mouthCorner(build, side, name)]),
    lip(build, 'upperLip', 1),
    lip(build, 'lowerLip', -1),
  ]
}

/** One deep line from the wing of the nose to beside the corner of the mouth; the cheek's side of it bulges. */
function nasolabial({ landmarks, age, random }: Build, side: Side, name: string): Region {
  const numbers = random(`nasolabial${name}`)
  const [wing, base] = spotOf(landmarks.wing)
  const [corner, mouth] = spotOf(landmarks.mouthCorner)
  const beside = corner + 7.5 + numbers.sway(0.6)
  const end = mouth - grown(age, 2, 9)
  const spots = bezier(
    side,
    [wing + 1, base + 14],
    [wing + 5.5, base + 3],
    [beside - 3, mouth + 11],
    [beside, end],
  )
  const guides: Guide[] = [
    {
      spots,
      width: grown(age, 5.2, 6.4),
      depth: 1,
      taper: [0.2, 0.5],
      shoulder: side > 0 ? [1, 0.25] : [0.25, 1],
      softness: grown(age, 0.5, 0.3),
    },
  ]
  if (age > 0.4) {
    guides.push({
      spots: spots
        .slice(5, 15)
        .map(([across, up]) => [across + side * (5.5 + numbers.sway(0.4)), up + 0.5] as const),
      width: 2.6,
      depth: grown(age, 0.05, 0.22),
      taper: [0.5, 0.5],
      shoulder: [0.8, 0.8],
      softness: 0.5,
    })
  }
  return {
    name: `nasolabial${name}`,
    cause: {
      [`mouthSmile${name}`]: 1,
      [`cheekSquint${name}`]: 0.2,
      [`noseSneer${name}`]: 0.3,
      [`mouthUpperUp${name}`]: 0.3,
    },
    guides,
    spacing: 14,
    hidden: grown(age, 0.4, 0.8),
    deepest: grown(age, 1.4, 2.4),
    reach: 6,
    feather: 6,
  }
}

/** Short arcs beside the corner, and below it the line that a downturned mouth digs with age. */
function mouthCorner({ landmarks, age, random }: Build, side: Side, name: string): Region {
  const numbers = random(`mouthCorner${name}`)
  const [corner, mouth] = spotOf(landmarks.mouthCorner)
  const arc = (out: number, high: number, low: number, width: number, depth: number): Guide => ({
    spots: bezier(
      side,
      [corner + out - 1.5, mouth + high],
      [corner + out + 0.8, mouth + high / 2],
      [corner + out + 0.8, mouth - low / 2],
      [corner + out - 1, mouth - low],
    ),
    width,
    depth,
    taper: [0.5, 0.5],
    shoulder: [0.8, 0.8],
    softness: 0.5,
  })
  const guides = [arc(3.2 + numbers.sway(0.4), 5, 6, 2.6, 1)]
  if (age > 0.35) {
    guides.push({
      spots: bezier(
        side,
        [corner + 1.5, mouth - 4],
        [corner + 3, mouth - 9],
        [corner + 4, mouth - 15],
        [corner + 5, mouth - grown(age, 16, 24)],
      ),
      width: 3.4,
      depth: grown(age, 0.5, 1),
      taper: [0.3, 0.6],
      shoulder: [0.8, 0.8],
      softness: 0.5,
    })
  }
  return {
    name: `mouthCorner${name}`,
    cause: { [`mouthDimple${name}`]: 1, [`mouthFrown${name}`]: 0.6, [`mouthSmile${name}`]: 0.4 },
    guides,
    spacing: 6,
    hidden: grown(age, 0.25, 0.7),
    deepest: grown(age, 0.5, 1),
    reach: 3,
    feather: 4,
  }
}

/** Fine lines that run away from the lip's edge (orbicularis oris). */
function lip({ landmarks, age, random }: Build, name: string, way: 1 | -1): Region {
  const numbers = random(name)
  const [corner, mouth] = spotOf(landmarks.mouthCorner)
  const lines = Math.round(grown(age, 7, 11))
  const edge = corner * (way > 0 ? 0.28 : 0.44)
  const space = way > 0 ? landmarks.noseBase - mouth - edge : corner * 0.5
  const guides = Array.from({ length: lines }, (_, i): Guide => {
    const across = corner * 0.86 * ((2 * (i + numbers.sway(0.36))) / (lines - 1) - 1)
    const sink = edge * (1 - 0.55 * (across / corner) ** 2)
    const length = Math.max(4, space * numbers.between(0.3, 0.9))
    const lean = 0.16 * across + numbers.sway(1.1)
    const from = mouth + way * sink
    return {
      spots: bezier(
        1,
        [across, from],
        [across + 0.2 * lean, from + (way * length) / 3],
        [across + 0.6 * lean, from + (way * 2 * length) / 3],
        [across + lean, from + way * length],
      ),
      width: grown(age, 1.6, 2),
      depth: numbers.between(0.55, 1),
      taper: [0.2, 0.7],
      shoulder: [0.8, 0.8],
      softness: 0.5,
    }
  })
  return {
    name,
    cause: { mouthPucker: 1, mouthFunnel: 0.3 },
    guides,
    spacing: (2 * corner * 0.86) / (lines - 1),
    hidden: grown(age, 0.15, 0.7),
    deepest: grown(age, 0.25, 0.6),
    reach: 1.5,
    feather: 4,
  }
}
