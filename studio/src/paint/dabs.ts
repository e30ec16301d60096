import type { GrayImage } from 'furrow'
import type { Rectangle } from '../document/sculpted.ts'
import { type Brush, checkBrush, falloff, type SculptBrush } from './brush.ts'
import { dabRadius } from './dab-size.ts'
import { visitFilled } from './fill.ts'
import { checkPaintable, type PaintMap } from './paint-map.ts'
import type { PaintSkin, SkinPoint } from './paint-skin.ts'
import { Bounds, covered, type PaintedImage } from './painted.ts'
import { Reach } from './reach.ts'
import { Smoother } from './smoother.ts'
import { PlacedStamp } from './stamp.ts'
import { type Sight, VisiblePlaces } from './visible-places.ts'

/**
 * Distance beyond the radius, in texels, up to which triangles are searched. A texel just beyond a UV island belongs to a triangle at the island's
 * border. This texel can be inside the radius even if the triangle is outside.
 */
const PAD = 1
/** Cell width of the smoothing grid, as a fraction of the radius. */
const CELL = 0.25
/** Minimum cell width of the smoothing grid, texels. */
const MIN_CELL = 1.5
/** Margin of the smoothing grid beyond the radius, cells. The local means include the weights in this margin. */
const CELLS_AROUND = 2

/**
 * Applies dabs (imprints of a brush) to an image: the weights of an area, or heights. A dab paints the skin inside a sphere that is connected with the
 * sphere's centre by skin inside the sphere. So a dab on one lip does not paint the other lip. Skin is also connected across UV seams.
 *
 * In the code, a place is a pair of a texel and a triangle that contains it; see `PaintMapArrays`.
 */
export class Dabs<Image extends PaintedImage = GrayImage> {
  /** Painted image. Its data changes with each dab. */
  readonly image: Image
  readonly #before: Image
  readonly #brush: Brush | SculptBrush
  /** Lowest and highest value of a texel. */
  readonly #range: readonly [least: number, most: number]
  /** Mean value under the first dab, in the mode `flatten`. */
  #level: number | undefined
  readonly #skin: PaintSkin
  readonly #map: PaintMap
  readonly #reach: Reach
  /** Coverage of each texel, 0..1. In the mode `smooth`, the value of each texel before rounding. */
  readonly #state: Float32Array
  /** Target coverage of each texel in the current dab, 0..1. */
  readonly #target: Float32Array
  /** Texels whose `#target` is above 0. */
  #touched: number[] = []
  /** Sum and number of the local means at each texel, in the mode `smooth`. A dab and its mirror image can add one mean each. */
  readonly #sums: Float32Array
  readonly #counts: Uint8Array
  /** Visible places for dabs and for their mirror images. Empty without a visibility test. */
  readonly #seen: readonly VisiblePlaces[]
  #bounds: Bounds
  readonly #allBounds: Bounds

  /**
   * @param image square image, not modified.
   * @param sight visibility test. Without it, hidden skin is painted too. Ignored in the mode `fill`.
   * @throws FurrowError if a brush setting is out of range, or the image cannot be painted.
   */
  constructor(image: Image, brush: Brush | SculptBrush, skin: PaintSkin, sight?: Sight) {
    checkBrush(brush)
    checkPaintable(image)
    this.#map = skin.mapOf(image.width)
    this.#before = image
    this.image = { ...image, data: image.data.slice() }
    this.#brush = { ...brush }
    this.#range = 'limit' in brush ? [-brush.limit, brush.limit] : [0, 255]
    this.#skin = skin
    this.#reach = new Reach(skin.surface)
    const smoothed = brush.mode === 'smooth' ? image.data.length : 0
    this.#sums = new Float32Array(smoothed)
    this.#counts = new Uint8Array(smoothed)
    this.#state = brush.mode === 'smooth' ? new Float32Array(image.data) : new Float32Array(image.data.length)
    this.#target = new Float32Array(image.data.length)
    this.#seen = sight
      ? [false, true].map((isMirrored) => new VisiblePlaces(skin, this.#map, sight, isMirrored))
      : []
    this.#bounds = new Bounds(image.width)
    this.#allBounds = new Bounds(image.width)
  }

  /** Rectangle of all changed texels, if any. */
  get changed(): Rectangle | undefined {
    return this.#allBounds.rectangle
  }

  /** Returns the rectangle of the texels that have changed since the last call. */
  takeChanged(): Rectangle | undefined {
    const { rectangle } = this.#bounds
    this.#bounds = new Bounds(this.image.width)
    return rectangle
  }

  /** Returns the radius of a dab at a point, millimetres. */
  radiusAt({ triangle }: SkinPoint): number {
    return dabRadius(this.#map, this.#brush, triangle)
  }

  /** Adds a dab and, if `mirror` is set, its mirror image. @param pressure pen pressure, 0..1. */
  add(point: SkinPoint, pressure: number): void {
    const strength = this.#brush.opacity * Math.min(Math.max(pressure, 0), 1)
    if (!(strength > 0)) return
    const centres = this.#sidesOf(point)
    const { stamp } = this.#brush
    const placed = stamp && new PlacedStamp(stamp, this.#skin.surface, point)
    for (const [side, centre] of centres.entries()) this.#setTargets(centre, strength, side, placed)
    if (this.#brush.mode === 'flatten') this.#level ??= this.#meanOfTouched()
    if (this.#brush.mode === 'smooth') this.#smooth(centres)
    else this.#cover()
    for (const texel of this.#touched) this.#target[texel] = 0
    this.#touched = []
  }

  /** Fills the skin around a point; see `visitFilled`. */
  fill(point: SkinPoint): void {
    for (const each of this.#sidesOf(point)) {
      visitFilled(this.#skin, this.#map, this.#before, each, (texel) => {
        this.#write(texel, this.#valueOf(this.#before.data[texel], this.#brush.opacity))
      })
    }
  }

  /** Returns the point and, if `mirror` is set, its mirror image. */
  #sidesOf(point: SkinPoint): SkinPoint[] {
    return this.#brush.mirror ? [point, this.#skin.mirrored(point.position)] : [point]
  }

  /** Sets `#target` for the texels inside a dab. */
  #setTargets(centre: SkinPoint, strength: number, side: number, stamp: PlacedStamp | undefined): void {
    const { softness } = this.#brush
    const radius = this.radiusAt(centre)
    const target = this.#target
    this.#visitPlaces(
      centre,
      radius + PAD * this.#map.texelSizes[centre.triangle],
      (place, triangle, distance) => {
        const shape = stamp ? stamp.at(...this.#offsetOf(place, centre, radius, side)) : 1
        const value = strength * shape * falloff(distance, radius, softness)
        const texel = this.#map.texels[place]
        if (value <= target[texel] || !(this.#seen[side]?.has(place, triangle) ?? true)) return
        if (target[texel] === 0) this.#touched.push(texel)
        target[texel] = value
      },
    )
  }

  /** Returns the position of a place from the centre of a dab, in radii. A dab on the other side is mirrored. */
  #offsetOf(place: number, centre: SkinPoint, radius: number, side: number): [number, number, number] {
    const [x, y, z] = centre.position.map((value, k) => (this.#map.positions[3 * place + k] - value) / radius)
    return [side === 0 ? x : -x, y, z]
  }

  #meanOfTouched(): number {
    let [sum, weight] = [0, 0]
    for (const texel of this.#touched) {
      sum += this.#target[texel] * this.#before.data[texel]
      weight += this.#target[texel]
    }
    return weight > 0 ? sum / weight : 0
  }

  /** Returns the value of a texel. @param before value before the stroke. @param coverage 0..1. */
  #valueOf(before: number, coverage: number): number {
    const brush = this.#brush
    if ('rise' in brush) {
      if (brush.mode === 'flatten') return before + coverage * ((this.#level ?? before) - before)
      return before + coverage * (brush.mode === 'lower' ? -brush.rise : brush.rise)
    }
    return covered(before, coverage, brush.mode === 'remove' ? 'remove' : 'add')
  }

  /** Raises the coverage towards `#target`, and updates the values. */
  #cover(): void {
    for (const texel of this.#touched) {
      const missing = this.#target[texel] - this.#state[texel]
      if (missing <= 0) continue
      this.#state[texel] += this.#brush.flow * missing
      this.#write(texel, this.#valueOf(this.#before.data[texel], this.#state[texel]))
    }
  }

  /** Changes the values towards local means: means over a few cells of the smoothing grid (`CELL`). */
  #smooth(centres: readonly SkinPoint[]): void {
    const { texels, positions, isBeyondIsland, texelSizes } = this.#map
    for (const centre of centres) {
      const texelSize = texelSizes[centre.triangle]
      const cell = Math.max(CELL * this.radiusAt(centre), MIN_CELL * texelSize)
      const radius = this.radiusAt(centre) + CELLS_AROUND * cell
      const smoother = new Smoother(centre.position, radius, cell)
      this.#visitPlaces(centre, radius, (place, triangle) => {
        if (isBeyondIsland[place] === 1) return
        const value = this.#state[texels[place]]
        const i = 3 * place
        smoother.add(positions[i], positions[i + 1], positions[i + 2], value, texelSizes[triangle] ** 2)
      })
      this.#visitPlaces(centre, this.radiusAt(centre) + PAD * texelSize, (place) => {
        const texel = texels[place]
        if (this.#target[texel] === 0) return
        const i = 3 * place
        const mean = smoother.at(positions[i], positions[i + 1], positions[i + 2])
        if (Number.isNaN(mean)) return
        this.#sums[texel] += mean
        this.#counts[texel]++
      })
    }
    // Change values only now, because the dab and its mirror image can share texels.
    for (const texel of this.#touched) {
      if (this.#counts[texel] === 0) continue
      const mean = this.#sums[texel] / this.#counts[texel]
      this.#state[texel] += this.#brush.flow * this.#target[texel] * (mean - this.#state[texel])
      this.#write(texel, this.#state[texel])
      this.#sums[texel] = 0
      this.#counts[texel] = 0
    }
  }

  #write(texel: number, value: number): void {
    const [least, most] = this.#range
    const rounded = Math.round(Math.min(Math.max(value, least), most))
    if (this.image.data[texel] === rounded) return
    this.image.data[texel] = rounded
    this.#bounds.add(texel)
    this.#allBounds.add(texel)
  }

  /** Visits the places whose distance from `centre` is less than `radius`, on the skin that `#reach` finds. */
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
