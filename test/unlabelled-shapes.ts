import type { Skin } from 'furrow/author'
import { canonicalTargetName } from 'furrow/internal'

type Point = readonly [number, number, number]
type Target = Skin['targets'][number]

/** Weights of ARKit blendshapes that add up to an expression or viseme. A name without `Left` or `Right` means both. */
const COMPOSITES: Readonly<Record<string, Readonly<Record<string, number>>>> = {
  angry: { browDown: 1, mouthFrown: 0.7, eyeSquint: 0.8 },
  happy: { mouthSmile: 0.8, cheekSquint: 0.8 },
  sad: { browInnerUp: 0.8, mouthFrown: 0.8 },
  surprised: { browInnerUp: 0.7, browOuterUp: 0.8, eyeWide: 0.8, jawOpen: 0.5 },
  disgusted: { noseSneer: 0.9, mouthUpperUp: 0.7, browDown: 0.5 },
  smileAndBlink: { mouthSmile: 0.9, eyeBlink: 1 },
  wink: { mouthSmileLeft: 0.7, eyeBlinkLeft: 1 },
  laugh: { mouthSmile: 0.8, jawOpen: 0.6, eyeSquint: 0.7 },
  visemeAa: { jawOpen: 0.6, mouthLowerDown: 0.4 },
  visemeOh: { jawOpen: 0.4, mouthFunnel: 0.8 },
  visemeOu: { jawOpen: 0.2, mouthPucker: 0.8, mouthFunnel: 0.3 },
  visemeEe: { mouthStretch: 0.6, mouthSmile: 0.3, jawOpen: 0.15 },
  visemeFf: { mouthRollLower: 0.7, mouthUpperUp: 0.5 },
}

/** Makes blendshapes that ARKit lacks: proportions of the face, and expressions made of ARKit blendshapes, which the skin must have. */
export function unlabelledShapes(skin: Skin): Target[] {
  return [...proportionsOf(skin), ...compositesOf(skin)]
}

function compositesOf({ targets }: Skin): Target[] {
  return Object.entries(COMPOSITES).map(([name, parts]) => {
    const offsets = new Float32Array(targets[0]!.offsets.length)
    for (const [part, weight] of Object.entries(parts))
      for (const target of targets)
        if (isPart(target, part))
          for (let i = 0; i < offsets.length; i++) offsets[i]! += weight * target.offsets[i]!
    return { name, offsets }
  })
}

function proportionsOf(skin: Skin): Target[] {
  const eyes = [centreOf(skin, 'eyeBlinkLeft'), centreOf(skin, 'eyeBlinkRight')] as const
  const [mouth, brow] = [centreOf(skin, 'mouthPucker'), centreOf(skin, 'browInnerUp')]
  const cheeks = ['Left', 'Right'].map((side) => centreOf(skin, `cheekSquint${side}`))
  const middle = mean(eyes)
  // Half the distance between the eyes, the unit of all lengths below.
  const half = distance(...eyes) / 2
  const nose = mean([middle, mouth])
  const chin: Point = [mouth[0], mouth[1] - half, mouth[2]]
  const head: Point = [middle[0], middle[1], middle[2] - 1.5 * half]
  // Scales the skin about the nearest of some points. The effect decreases with the distance.
  const scaled = (name: string, centres: readonly Point[], reach: number, [x, y, z]: Point) =>
    offsetsOf(skin, name, centres, reach * half, ([dx, dy, dz]) => [x * dx, y * dy, z * dz])
  const moved = (name: string, centres: readonly Point[], reach: number, by: Point) =>
    offsetsOf(skin, name, centres, reach * half, ([dx]) => [
      by[0] * half * Math.sign(dx),
      by[1] * half,
      by[2] * half,
    ])
  return [
    scaled('headScale', [head], 100, [0.1, 0.1, 0.1]),
    scaled('headWidth', [head], 100, [0.15, 0, 0]),
    scaled('jawWidth', [chin], 1, [0.3, 0, 0]),
    moved('chinLength', [chin], 0.7, [0, -0.3, 0]),
    moved('chinForward', [chin], 0.7, [0, 0, 0.3]),
    moved('noseLength', [nose], 0.5, [0, -0.15, 0.3]),
    scaled('noseWidth', [nose], 0.5, [0.4, 0, 0]),
    scaled('eyeSize', eyes, 0.5, [0.2, 0.2, 0.1]),
    moved('eyeHeight', eyes, 0.6, [0, 0.15, 0]),
    scaled('eyeDistance', [middle], 1.2, [0.15, 0, 0]),
    moved('browForward', [brow], 0.8, [0, 0, 0.2]),
    moved('browHeight', [brow], 1, [0, 0.2, 0]),
    scaled('cheeksFull', cheeks, 0.7, [0.3, 0.3, 0.3]),
    moved('cheekBones', cheeks, 0.6, [0, 0.1, 0.2]),
    scaled('mouthWidth', [mouth], 0.7, [0.25, 0, 0]),
    scaled('lipsFull', [mouth], 0.5, [0.1, 0.4, 0.3]),
    moved('mouthHeight', [mouth], 0.7, [0, 0.2, 0]),
  ]
}

/** Makes a blendshape. A vertex moves by `map` of the vector from the nearest centre, multiplied by a Gaussian of the distance. */
function offsetsOf(
  { positions }: Skin,
  name: string,
  centres: readonly Point[],
  reach: number,
  map: (offset: Point) => Point,
): Target {
  const offsets = new Float32Array(positions.length)
  for (let i = 0; i < positions.length; i += 3) {
    const point: Point = [positions[i]!, positions[i + 1]!, positions[i + 2]!]
    const centre = centres.reduce((a, b) => (distance(a, point) < distance(b, point) ? a : b))
    const bump = Math.exp(-0.5 * (distance(centre, point) / reach) ** 2)
    const from = point.map((x, k) => x - centre[k]!) as unknown as Point
    offsets.set(
      map(from).map((x) => bump * x),
      i,
    )
  }
  return { name, offsets }
}

/** Returns the mean position of the skin that a blendshape, or its left and right half, moves. */
function centreOf({ positions, targets }: Skin, name: string): Point {
  const sum = [0, 0, 0]
  let total = 0
  for (const { offsets } of targets.filter((target) => isPart(target, name))) {
    for (let i = 0; i < offsets.length; i += 3) {
      const weight = Math.hypot(offsets[i]!, offsets[i + 1]!, offsets[i + 2]!)
      for (let k = 0; k < 3; k++) sum[k]! += weight * positions[i + k]!
      total += weight
    }
  }
  return sum.map((x) => x / total) as unknown as Point
}

/** Tells whether a blendshape is an ARKit blendshape, given by name, or its left or right half. */
function isPart(target: Target, shape: string): boolean {
  const name = canonicalTargetName(target.name)
  return name === shape || name === `${shape}Left` || name === `${shape}Right`
}

function mean(points: readonly Point[]): Point {
  return [0, 1, 2].map(
    (k) => points.reduce((sum, point) => sum + point[k]!, 0) / points.length,
  ) as unknown as Point
}

function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2])
}
