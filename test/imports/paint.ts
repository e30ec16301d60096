import sharp from 'sharp'
import { seeded } from '../random.ts'

/** Square map in memory: three numbers per texel for normals (-1..1), one for masks (0..1). */
export interface Field {
  size: number
  data: Float64Array
}

/** A crease that runs around the centre of a group of wrinkles. */
export interface Bump {
  u: number
  v: number
  /** Radius in texture coordinates. */
  radius: number
  /** Largest slope. */
  slope: number
  /** Direction of the creases, radians. */
  turn?: number
}

/** Makes normals with pores and creases. Pores are the same for equal seeds. */
export function creased(size: number, seed: number, bumps: readonly Bump[]): Field {
  const random = seeded(seed)
  const pores = Float64Array.from({ length: 2 * size * size }, () => 0.06 * (random() - 0.5))
  const data = new Float64Array(3 * size * size)
  for (let i = 0; i < size * size; i++) {
    const [u, v] = centreOf(i, size)
    let [x, y] = [pores[2 * i]!, pores[2 * i + 1]!]
    for (const { u: cu, v: cv, radius, slope, turn = 0 } of bumps) {
      const fade = Math.max(0, 1 - Math.hypot(u - cu, v - cv) / radius)
      const wave =
        slope *
        fade *
        (2 - fade) *
        Math.sin((40 * ((u - cu) * Math.sin(turn) + (v - cv) * Math.cos(turn))) / (4 * radius))
      x += wave * Math.sin(turn)
      y += wave * Math.cos(turn)
    }
    const length = Math.hypot(x, y, 1)
    data.set([x / length, y / length, 1 / length], 3 * i)
  }
  return { size, data }
}

/** Returns the texture coordinates of the centre of a texel. */
export function centreOf(texel: number, size: number): [u: number, v: number] {
  return [((texel % size) + 0.5) / size, (Math.floor(texel / size) + 0.5) / size]
}

/** Encodes normals as PNG. */
export function normalPng({ size, data }: Field): Promise<Uint8Array> {
  return rgbPng(
    size,
    Uint8Array.from(data, (value) => Math.round((value + 1) * 127.5)),
  )
}

export function rgbPng(size: number, data: Uint8Array): Promise<Uint8Array> {
  const channels = (data.length / size ** 2) as 1 | 3 | 4
  return sharp(data, { raw: { width: size, height: size, channels } })
    .png()
    .toBuffer()
}

/** Decodes the normals as a shader reads them: 8 bits, not normalised. */
export function stored({ size, data }: Field): Field {
  return { size, data: data.map((value) => Math.round((value + 1) * 127.5) / 127.5 - 1) }
}
