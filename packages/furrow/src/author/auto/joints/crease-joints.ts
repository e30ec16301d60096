import type { BoneDriver } from '../../../drivers/bone/definition.ts'
import { length } from '../../../math/vector.ts'
import type { ClothKind } from '../cloth/cloth-kinds.ts'
import { hingeRegions } from '../cloth/hinge-regions.ts'
import { trunkRegions } from '../cloth/trunk-regions.ts'
import { makeGauge, measureCompression, vectorsAcross } from '../fit/gauge.ts'
import { type HandFrame, handFrame } from '../limbs/hand-frame.ts'
import { handRegions } from '../limbs/hand-regions.ts'
import { activationAt, jointDriver } from '../limbs/joint-driver.ts'
import { type Knuckles, knucklesOf } from '../limbs/knuckles.ts'
import { type LimbSkin, limbSkin } from '../limbs/limb-skin.ts'
import { neckRegions } from '../limbs/neck-regions.ts'
import { widened } from '../limbs/observed.ts'
import type { RegionPlan, SkinPlan } from '../limbs/region-plan.ts'
import { skinHinges } from '../limbs/skin-hinges.ts'
import { type TurnedSkin, turnDisplacements, turnSkin, turnTensors, weightedTurn } from '../limbs/turn.ts'
import { wristRegions } from '../limbs/wrist-regions.ts'
import { type CreasedRegion, creaseLines, type LineSettings } from '../lines/crease.ts'
import { findBody } from '../skeleton/body.ts'
import type { HandJoints, HingedLimb, NeckJoints, TrunkJoints } from '../skeleton/humanoid.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { clothTubes, skinTubes } from './tube-regions.ts'

/** Region of skin that joints fold, with the drivers of its area. */
export interface JointRegion extends CreasedRegion {
  drivers: BoneDriver[]
  /** Root mean square error of the activation over the range of the joint, 0..1. */
  error: number
}

/** Settings of skin or cloth that joints fold. */
export interface JointSettings extends LineSettings {
  /** Kind of cloth; undefined for skin. */
  cloth?: ClothKind | undefined
  /** Whether the joints of chains fold the surface, if the skeleton is not a humanoid. */
  tubes: boolean
}

/** Wrinkles of skin that joints fold. */
export interface JointWrinkles {
  regions: JointRegion[]
  /** One per hand with creases. */
  knuckles: Knuckles[]
}

/** Smoothing of the compression, as a fraction of the looseness. */
const SMOOTHING = 0.35
/** Fractions of the full angle at which the activation is compared with the compression. */
const FRACTIONS = [0.125, 0.25, 0.5, 0.75, 1]

/**
 * Lays the wrinkle lines of skin that joints fold, on hands, necks, elbows and knees, or the folds of cloth, at elbows, knees and waists.
 *
 * @param maxAreas maximum number of regions. The least important ones are dropped.
 */
export function creaseJoints(
  prepared: PreparedSkin,
  settings: JointSettings,
  maxAreas: number,
  report: (fraction: number) => void = () => {},
): JointWrinkles {
  const limb = limbSkin(prepared)
  if (!limb) return { regions: [], knuckles: [] }
  const limbs = limbsIn(limb)
  const usable = plansOf(limb, limbs, settings).map((plan) => withMeasurableLinks(limb, plan))
  const plans = mostImportant(
    usable.filter(({ links }) => links.length > 0),
    maxAreas,
  ).map((plan) => withObserved(limb, plan))
  const strain = new StrainCache(limb, plans.length)
  const regions = plans.flatMap((plan, i) => {
    report(i / plans.length)
    const { turned, tensors } = strain.of(plan)
    const creased = plan.crease(tensors)
    if (!creased || creased.creases.length === 0) return []
    const region = { ...plan, cause: {}, isOffHead: true }
    const drivers = plan.links.map((link) => jointDriver(limb, plan.name, link))
    return [{ region, ...creased, drivers, error: errorOf(limb, turned, plan, creased) }]
  })
  if (prepared.drawsOneSide) shareSides(limb, plans, regions)
  const knuckles = limbs.hands.flatMap(({ hand, frame }) => knucklesOf(limb, hand, frame) ?? [])
  return { regions, knuckles: regions.length > 0 ? knuckles : [] }
}

/**
 * Lets the joints of both sides activate a region whose texels both sides share. Each side activates it by half, because the wrinkles show on
 * both.
 */
function shareSides(limb: LimbSkin, plans: readonly RegionPlan[], regions: readonly JointRegion[]): void {
  for (const { name, pair, links } of plans) {
    if (pair === undefined || regions.some(({ region }) => region.name === name)) continue
    const other = plans.find((plan) => plan.pair === pair && plan.name !== name)
    const shared = regions.find(({ region }) => region.name === other?.name)
    if (!shared) continue
    const more = links.map((link) => jointDriver(limb, shared.region.name, link))
    shared.drivers = [...shared.drivers, ...more].map((driver) => ({
      ...driver,
      curve: driver.curve.map(([angle, activation]) => [angle, activation / 2]),
    }))
  }
}

/** Limbs that the skeleton of a skin moves. */
interface Limbs {
  hands: { hand: HandJoints; frame: HandFrame }[]
  neck: NeckJoints | undefined
  limbs: readonly HingedLimb[]
  trunk: TrunkJoints | undefined
}

function limbsIn(limb: LimbSkin): Limbs {
  const { hands, neck, limbs, trunk } = findBody(limb.skeleton)
  const framed = hands.flatMap((hand) => {
    const frame = handFrame(limb, hand)
    return frame ? [{ hand, frame }] : []
  })
  return { hands: framed, neck, limbs, trunk }
}

/** Drops links to joints whose rotation cannot be measured, because their matrix has no volume. */
function withMeasurableLinks({ axes }: LimbSkin, plan: RegionPlan): RegionPlan {
  const isMeasurable = (joint: number) => axes[joint].every((axis) => length(axis) > 0)
  const links = plan.links.filter(({ turn: { from, joints } }) => [from, ...joints].every(isMeasurable))
  return { ...plan, links }
}

/** Widens the turns of a plan to the angles that the file shows. */
function withObserved(limb: LimbSkin, plan: RegionPlan): RegionPlan {
  const links = plan.links.map((link) =>
    link.full < link.rest ? link : { ...link, turn: widened(limb, link.turn) },
  )
  return { ...plan, turn: widened(limb, plan.turn), links }
}

/** Strain of the last turn, because consecutive regions often share a turn or its joints. */
class StrainCache {
  readonly #limb: LimbSkin
  readonly #runs: number
  #turned: TurnedSkin | undefined
  #looseness = 0
  #moved: RegionPlan['moved']
  #tensors: Float64Array | undefined

  constructor(limb: LimbSkin, runs: number) {
    this.#limb = limb
    this.#runs = runs
  }

  of({ turn, looseness, moved, strained = 1 }: RegionPlan): { turned: TurnedSkin; tensors: Float64Array } {
    const before = this.#turned
    const isKnown =
      before &&
      this.#looseness === looseness &&
      this.#moved === moved &&
      `${before.turn.joints}` === `${turn.joints}`
    const isSameTurn = isKnown && `${before.turn.axis} ${before.turn.full}` === `${turn.axis} ${turn.full}`
    const spread = () =>
      moved ? weightedTurn(this.#limb, turn, moved) : turnSkin(this.#limb, turn, looseness, this.#runs)
    const turned = isKnown ? { ...before, turn } : spread()
    if (!this.#tensors || !isSameTurn)
      this.#tensors = turnTensors(this.#limb, turned, strained, SMOOTHING * looseness, this.#runs)
    this.#turned = turned
    this.#looseness = looseness
    this.#moved = moved
    return { turned, tensors: this.#tensors }
  }
}

function plansOf(
  limb: LimbSkin,
  { hands, neck, limbs, trunk }: Limbs,
  settings: JointSettings,
): RegionPlan[] {
  const { cloth, strength } = settings
  const isHumanoid = hands.length > 0 || limbs.length > 0 || neck !== undefined || trunk !== undefined
  const hasTubes = settings.tubes && !isHumanoid
  if (cloth !== undefined) {
    const ofCloth = { seed: settings.seed, strength, cloth }
    const ofLimbs = [
      ...hingeRegions(limb, limbs, ofCloth),
      ...(trunk ? trunkRegions(limb, trunk, ofCloth) : []),
    ]
    return hasTubes ? clothTubes(limb, cloth, settings) : ofLimbs
  }
  const ofHands = hands.flatMap(({ hand, frame }) => {
    const own = [...handRegions(limb, hand, frame, settings), ...wristRegions(limb, hand, frame, settings)]
    return own.map((plan, i) => ({ ...plan, pair: `${own.length} ${i}` }))
  })
  const ofSkin: SkinPlan[] = [
    ...ofHands,
    ...(neck ? neckRegions(limb, neck, settings) : []),
    ...skinHinges(limb, limbs, settings),
    ...(hasTubes ? skinTubes(limb, settings) : []),
  ]
  return ofSkin.map((plan) => ({
    ...plan,
    crease: (tensors) => {
      const lines = plan.lay(tensors)
      return lines.length === 0 ? undefined : creaseLines(limb.prepared, plan, lines, settings)
    },
  }))
}

function mostImportant(plans: readonly RegionPlan[], count: number): RegionPlan[] {
  if (plans.length <= count) return [...plans]
  const kept = new Set([...plans].sort((a, b) => b.rank - a.rank).slice(0, count))
  return plans.filter((plan) => kept.has(plan))
}

/** Compares the activation with the square root of the compression across the lines, over the range of the turn. */
function errorOf(
  limb: LimbSkin,
  turned: TurnedSkin,
  { links, ...plan }: RegionPlan,
  { folds }: Pick<CreasedRegion, 'folds'>,
): number {
  const { surface } = limb.prepared
  const gauge = makeGauge(surface, { ...plan, cause: {} }, folds)
  const link = links[0]
  if (!gauge || link.full < link.rest) return 0
  const rest = vectorsAcross(gauge, surface.points)
  const measured = FRACTIONS.map((fraction) => {
    const vectors = vectorsAcross(gauge, turnDisplacements(limb, turned, fraction))
    return Math.max(0, measureCompression(gauge, rest, [{ vectors, weight: 1 }]))
  })
  const most = measured[measured.length - 1]
  if (!(most > 0)) return 0
  const share = link.full - link.rest
  const squares = FRACTIONS.map((fraction, i) => {
    const wanted = link.rest + share * Math.min(1, Math.sqrt(measured[i] / most))
    return (activationAt(link, fraction) - wanted) ** 2
  })
  return Math.sqrt(squares.reduce((a, b) => a + b, 0) / squares.length)
}
