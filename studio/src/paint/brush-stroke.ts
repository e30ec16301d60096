import type { GrayImage } from 'furrow'
import { type Brush, checkBrush, falloff } from './brush.ts'
import { visitFilled } from './fill.ts'
import { checkPaintable, type PaintMap } from './paint-map.ts'
import type { PaintSkin, SkinPoint } from './paint-skin.ts'
import { Bounds, covered, type Painted, type Rectangle } from './painted.ts'
import { Reach } from './reach.ts'
import { SeenPlaces, type Sight } from './seen-places.ts'
import { skinPath } from './skin-path.ts'
import { Smoother } from './smoother.ts'
import { distanceBetween } from './vectors.ts'

/** Fraction of the radius between dabs: their envelope is within half a percent of that of a brush that moves without steps. */
const SPACING = 0.08
/** Texels by which skin is grown beyond the radius: filtering reads those beyond a seam. */
const PAD = 1
/** A brush has at least this radius in texels, so that it always covers one. */
const LEAST_RADIUS = 1.25
/** Of a brush that smooths: side of the cells that it averages over as a fraction of its radius, and at least, in texels. */
const CELL = 0.25
const LEAST_CELL = 1.5
/** Cells beyond the radius that count in the averages. */
const CELLS_AROUND = 2
/** Longest step in the texture, in texels, and the times its length on the skin from which on it leads to another island. */
const TEXTURE_STEP = 0.5
const JUMP = 10

/**
 * A stroke of a brush over an area: dabs at even distances on the skin, however many points the pointer gave. A dab covers the skin within its
 * radius in space that is connected with its centre there, so that seams of the texture do not matter and the other lip is left alone.
 */
export class BrushStroke {
  /** The area as it is painted now; its data changes with each dab. */
  readonly image: GrayImage
  readonly #before: GrayImage
  readonly #brush: Brush
  readonly #skin: PaintSkin
  readonly #map: PaintMap
  readonly #reach: Reach
  /** How far the stroke has covered each texel, 0..1; of a brush that smooths the unrounded weight, 0..255. */
  readonly #state: Float32Array
  /** The target of the present dab for each texel, and the texels that have one. */
  readonly #target: Float32Array
  #touched: number[] = []
  /** The means round each texel, of a brush that smooths, and how many there are. */
  readonly #sums: Float32Array
  readonly #counts: Uint8Array
  /** Of the dab and the mirrored one; empty where hidden skin is painted too. */
  readonly #seen: readonly SeenPlaces[]
  #last: SkinPoint | undefined
  #lastPressure = 1
  #lastUv: readonly [u: number, v: number] | undefined
  /** Millimetres to the next dab. */
  #left = 0
  #bounds: Bounds
  readonly #allBounds: Bounds
  readonly #weights = new Float64Array(3)

  /**
   * @param image a square area; not changed.
   * @param sight by default, and in the texture, hidden skin is painted as well. A fill asks for no sight: it follows the skin.
   * @throws FurrowError when a setting of the brush is out of range, or the image cannot be painted.
   */
  constructor(image: GrayImage, brush: Brush, skin: PaintSkin, sight?: Sight) {
    checkBrush(brush)
    checkPaintable(image)
    this.#map = skin.mapOf(image.width)
    this.#before = image
    this.image = { ...image, data: image.data.slice() }
    this.#brush = { ...brush }
    this.#skin = skin
    this.#reach = new Reach(skin.surface)
    const smoothed = brush.mode === 'smooth' ? image.data.length : 0
    this.#sums = new Float32Array(smoothed)
    this.#counts = new Uint8Array(smoothed)
    this.#state =
      brush.mode === 'smooth' ? Float32Array.from(image.data) : new Float32Array(image.data.length)
    this.#target = new Float32Array(image.data.length)
    this.#seen = sight
      ? [false, true].map((isMirrored) => new SeenPlaces(skin, this.#map, sight, isMirrored))
      : []
    this.#bounds = new Bounds(image.width)
    this.#allBounds = new Bounds(image.width)
  }

  /**
   * Goes on to a point over the skin.
   *
   * @param point undefined off the face, where nothing is painted: the next point begins anew.
   * @param pressure of the pen, 0..1; 1 of what has none.
   * @returns the texels that changed.
   */
  moveTo(point: SkinPoint | undefined, pressure = 1): Rectangle | undefined {
    this.#lastUv = undefined
    return this.#paint(() => this.#advance(point, pressure))
  }

  /** Goes on to a point of the texture: straight there, and not over the skin between two islands. */
  moveInTexture(u: number, v: number, pressure = 1): Rectangle | undefined {
    const [fromU, fromV] = this.#lastUv ?? [u, v]
    const first = this.#lastPressure
    const steps = Math.ceil((Math.hypot(u - fromU, v - fromV) * this.#map.size) / TEXTURE_STEP) || 1
    const changed = this.#paint(() => {
      for (let i = 1; i <= steps; i++) {
        const t = i / steps
        const point = this.#pointAt(fromU + t * (u - fromU), fromV + t * (v - fromV))
        if (point && this.#isJump(point)) this.#last = undefined
        this.#advance(point, this.#lastUv ? first + t * (pressure - first) : pressure)
      }
    })
    this.#lastUv = [u, v]
    return changed
  }

  /** The area as the stroke leaves it. */
  end(): Painted {
    return { image: this.image, dirty: this.#allBounds.rectangle }
  }

  #paint(move: () => void): Rectangle | undefined {
    this.#bounds = new Bounds(this.#map.size)
    move()
    return this.#bounds.rectangle
  }

  #pointAt(u: number, v: number): SkinPoint | undefined {
    const triangle = this.#map.locator.find(u, v, this.#weights)
    if (triangle < 0) return undefined
    const { points, corners } = this.#skin.surface
    const position = [0, 1, 2].map((k) =>
      this.#weights.reduce((sum, weight, i) => sum + weight * points[3 * corners[3 * triangle + i] + k], 0),
    )
    return { triangle, position: position as [number, number, number] }
  }

  #isJump({ triangle, position }: SkinPoint): boolean {
    if (!this.#last) return false
    const usual =
      TEXTURE_STEP * Math.max(...[triangle, this.#last.triangle].map((t) => this.#map.texelSizes[t]))
    return distanceBetween(position, this.#last.position) > JUMP * usual
  }

  #advance(point: SkinPoint | undefined, pressure: number): void {
    const [from, fromPressure] = [this.#last, this.#lastPressure]
    this.#last = point
    this.#lastPressure = pressure
    if (!point) return
    if (this.#brush.mode === 'fill') {
      if (!from && this.#allBounds.rectangle === undefined) this.#fill(point)
      return
    }
    const path = from && skinPath(this.#skin.surface, from, point)
    if (path) this.#dabAlong(path, fromPressure, pressure)
    else {
      this.#dab(point, pressure)
      this.#left = this.#spacingAt(point)
    }
  }

  #dabAlong(path: readonly SkinPoint[], startPressure: number, endPressure: number): void {
    let total = 0
    for (let i = 1; i < path.length; i++) total += distanceBetween(path[i - 1].position, path[i].position)
    let done = 0
    for (let i = 1; i < path.length; i++) {
      const [from, to] = [path[i - 1], path[i]]
      const length = distanceBetween(from.position, to.position)
      let along = 0
      while (length - along >= this.#left) {
        along += this.#left
        const t = length > 0 ? along / length : 1
        const [[x, y, z], [toX, toY, toZ]] = [from.position, to.position]
        const position = [x + t * (toX - x), y + t * (toY - y), z + t * (toZ - z)] as const
        const dab = { triangle: from.triangle, position }
        this.#dab(dab, startPressure + ((done + along) / total) * (endPressure - startPressure))
        this.#left = this.#spacingAt(dab)
      }
      this.#left -= length - along
      done += length
    }
  }

  #spacingAt(point: SkinPoint): number {
    return SPACING * this.#radiusAt(point)
  }

  #radiusAt({ triangle }: SkinPoint): number {
    return Math.max(this.#brush.radius, LEAST_RADIUS * this.#map.texelSizes[triangle])
  }

  #dab(point: SkinPoint, pressure: number): void {
    const strength = this.#brush.opacity * Math.min(Math.max(pressure, 0), 1)
    if (!(strength > 0)) return
    const centres = this.#brush.mirror ? [point, this.#skin.mirrored(point.position)] : [point]
    for (const [side, centre] of centres.entries()) this.#aim(centre, strength, side)
    if (this.#brush.mode === 'smooth') this.#smooth(centres)
    else this.#cover()
    for (const texel of this.#touched) this.#target[texel] = 0
    this.#touched = []
  }

  /** Sets the targets of the texels within a dab. */
  #aim(centre: SkinPoint, strength: number, side: number): void {
    const { softness } = this.#brush
    const radius = this.#radiusAt(centre)
    const target = this.#target
    this.#visitPlaces(
      centre,
      radius + PAD * this.#map.texelSizes[centre.triangle],
      (place, triangle, distance) => {
        const value = strength * falloff(distance, radius, softness)
        const texel = this.#map.texels[place]
        if (value <= target[texel] || !(this.#seen[side]?.has(place, triangle) ?? true)) return
        if (target[texel] === 0) this.#touched.push(texel)
        target[texel] = value
      },
    )
  }

  /** Raises the coverage of the texels that have a target. */
  #cover(): void {
    const mode = this.#brush.mode === 'remove' ? 'remove' : 'add'
    for (const texel of this.#touched) {
      const missing = this.#target[texel] - this.#state[texel]
      if (missing <= 0) continue
      this.#state[texel] += this.#brush.flow * missing
      this.#write(texel, covered(this.#before.data[texel], this.#state[texel], mode))
    }
  }

  /** Moves the weights of the texels that have a target towards the means round them. */
  #smooth(centres: readonly SkinPoint[]): void {
    const { texels, positions, isBeyond, texelSizes } = this.#map
    for (const centre of centres) {
      const texelSize = texelSizes[centre.triangle]
      const cell = Math.max(CELL * this.#radiusAt(centre), LEAST_CELL * texelSize)
      const radius = this.#radiusAt(centre) + CELLS_AROUND * cell
      const smoother = new Smoother(centre.position, radius, cell)
      this.#visitPlaces(centre, radius, (place, triangle) => {
        if (isBeyond[place] === 1) return
        const value = this.#state[texels[place]]
        const i = 3 * place
        smoother.add(positions[i], positions[i + 1], positions[i + 2], value, texelSizes[triangle] ** 2)
      })
      this.#visitPlaces(centre, this.#radiusAt(centre) + PAD * texelSize, (place) => {
        const texel = texels[place]
        if (this.#target[texel] === 0) return
        const i = 3 * place
        const mean = smoother.at(positions[i], positions[i + 1], positions[i + 2])
        if (Number.isNaN(mean)) return
        this.#sums[texel] += mean
        this.#counts[texel]++
      })
    }
    // All at once: a mirrored dab may touch the same texels.
    for (const texel of this.#touched) {
      if (this.#counts[texel] === 0) continue
      const mean = this.#sums[texel] / this.#counts[texel]
      this.#state[texel] += this.#brush.flow * this.#target[texel] * (mean - this.#state[texel])
      this.#write(texel, this.#state[texel])
      this.#sums[texel] = 0
      this.#counts[texel] = 0
    }
  }

  #fill(point: SkinPoint): void {
    const points = this.#brush.mirror ? [point, this.#skin.mirrored(point.position)] : [point]
    for (const each of points) {
      visitFilled(this.#skin, this.#map, this.#before, each, (texel) => {
        this.#write(texel, covered(this.#before.data[texel], this.#brush.opacity, 'add'))
      })
    }
  }

  #write(texel: number, weight: number): void {
    const rounded = Math.round(weight)
    if (this.image.data[texel] === rounded) return
    this.image.data[texel] = rounded
    this.#bounds.add(texel)
    this.#allBounds.add(texel)
  }

  /** Visits the places within a radius on the skin that is connected with a point. */
  #visitPlaces(
    centre: SkinPoint,
    radius: number,
    visit: (place: number, triangle: number, distance: number) => void,
  ): void {
    const { starts, positions } = this.#map
    const [x, y, z] = centre.position
    const square = radius * radius
    this.#reach.visit(centre, radius, (triangle) => {
      for (let place = starts[triangle]; place < starts[triangle + 1]; place++) {
        const [dx, dy, dz] = [
          positions[3 * place] - x,
          positions[3 * place + 1] - y,
          positions[3 * place + 2] - z,
        ]
        const distance = dx * dx + dy * dy + dz * dz
        if (distance < square) visit(place, triangle, Math.sqrt(distance))
      }
    })
  }
}
