import { type Build, bezier, type Guide, grown, type Region, spotOf } from './region.ts'

/** The chin's dimples and the crease above it (mentalis), and the rings of the neck. */
export function chinAndNeck(build: Build): Region[] {
  return [chin(build), neck(build)]
}

function chin({ landmarks, age, random }: Build): Region {
  const numbers = random('chin')
  const [corner, mouth] = spotOf(landmarks.mouthCorner)
  const half = 0.55 * corner
  const above = mouth - 0.34 * (mouth - landmarks.chin)
  const guides: Guide[] = [
    {
      spots: bezier(
        1,
        [-half, above - 2.5],
        [-half / 2, above + 1.5],
        [half / 2, above + 1.5],
        [half, above - 2.5],
      ),
      width: grown(age, 5, 6),
      depth: 1,
      taper: [0.5, 0.5],
      shoulder: [0.6, 0.9],
      softness: 0.6,
    },
  ]
  const middle = 0.5 * (above + landmarks.chin) + 2
  // Dimples lie apart from one another as peas in a jar do: by the golden angle.
  for (let i = 0; i < 22; i++) {
    const angle = 2.4 * i + numbers.sway(0.3)
    const out = Math.sqrt((i + 0.5) / 22)
    const [x, y] = [out * 0.62 * corner * Math.cos(angle), middle + out * 9.5 * Math.sin(angle)]
    const turn = numbers.between(0, Math.PI)
    const long = numbers.between(0.8, 1.6)
    const [dx, dy] = [long * Math.cos(turn), long * Math.sin(turn)]
    guides.push({
      spots: bezier(
        1,
        [x - dx, y - dy],
        [x - dx / 3, y - dy / 3],
        [x + dx / 3, y + dy / 3],
        [x + dx, y + dy],
      ),
      width: numbers.between(2.6, 3.6),
      depth: numbers.between(0.3, 0.55) * (1.15 - out),
      taper: [0.3, 0.3],
      shoulder: [0.9, 0.9],
      softness: 0.9,
      isDimple: true,
    })
  }
  return {
    name: 'chin',
    cause: { mouthShrugLower: 1, mouthFrownLeft: 0.3, mouthFrownRight: 0.3 },
    guides,
    spacing: 7,
    hidden: grown(age, 0.3, 0.7),
    deepest: grown(age, 0.6, 1),
    assumed: 0.1,
    reach: 3,
    feather: 5,
  }
}

function neck({ landmarks, age, random }: Build): Region {
  const numbers = random('neck')
  const rings = Math.round(grown(age, 2, 3))
  const guides = Array.from({ length: rings }, (_, i): Guide => {
    const up = landmarks.chin - 34 - 17 * i + numbers.sway(2)
    const half = 46 + numbers.sway(6)
    return {
      spots: bezier(
        1,
        [-half, up + 7],
        [-half / 3, up - 2],
        [half / 3, up - 2 + numbers.sway(1)],
        [half, up + 7],
      ),
      width: grown(age, 3, 4),
      depth: numbers.between(0.7, 1),
      taper: [0.5, 0.5],
      shoulder: [0.8, 0.8],
      softness: 0.6,
    }
  })
  return {
    name: 'neck',
    cause: { jawOpen: 1 },
    guides,
    spacing: 17,
    hidden: grown(age, 0.15, 0.5),
    deepest: grown(age, 0.3, 0.9),
    reach: 6,
    feather: 8,
  }
}
