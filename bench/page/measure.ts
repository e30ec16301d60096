import type { WrinkleSet } from 'furrow'
import type { Mesh, MeshPhysicalMaterial } from 'three'
import { activationOf, type Case, type Plan } from '../case.ts'
import type { Measured } from '../report.ts'
import { roundOrder } from '../statistics.ts'
import type { Bench } from './bench.ts'
import { changedFraction, MIN_CHANGED } from './changed.ts'
import { giveDistinctProgram } from './distinct-program.ts'
import { createSet, createSkin } from './scene.ts'
import { type AppliedVariant, VARIANTS } from './variant.ts'

/** Allowed difference of a colour value (0..255) between the pictures of variants that must look equal. */
const MAX_DIFFERENCE = 2
/** Fraction of a picture's colour values that may differ by more than `MAX_DIFFERENCE`. */
const MAX_FRACTION = 1e-5
/** Minimum duration of a measurement in milliseconds, because some clocks only have a resolution of 0.1 ms. */
const MIN_MS = 20
/** Maximum number of frames per measurement. A frame has up to a dozen render passes, and `passClock` can time 2048 passes together. */
const MAX_FRAMES = 64
/** Measurements per variant and round. Only the fastest is used, because other processes can slow frames down but never speed them up. */
const TURNS = 3

interface Candidate {
  name: string
  mesh: Mesh
  applied: AppliedVariant
}

/**
 * Times every variant that supports a case. Each round compiles all variants again, because a software rasteriser sometimes compiles
 * the same shader to slower code.
 *
 * @throws Error if a variant shows no wrinkles, if pictures that must be equal differ, or if `plan.variants` lacks `plain`. Throws the signal's
 * reason if `plan.signal` is aborted.
 */
export async function measure(bench: Bench, benchCase: Case, plan: Plan): Promise<Measured[]> {
  const set = createSet(bench.face, benchCase)
  bench.ambient.visible = benchCase.maps !== 'normals'
  const measured: Measured[] = []
  for (let round = 0; round < plan.rounds; round++) {
    const candidates = createCandidates(bench, benchCase, set, plan)
    try {
      await Promise.all(candidates.map(({ applied }) => applied.ready))
      for (const candidate of candidates) {
        plan.signal?.throwIfAborted()
        await warmUp(bench, benchCase, candidate)
      }
      if (round === 0) {
        const changed = await changedFractions(bench, benchCase, candidates)
        measured.push(
          ...candidates.map(({ name }, i) => ({ variant: name, rounds: [], changed: changed[i] })),
        )
      }
      const times = await timeInTurns(bench, benchCase, candidates, round, plan.signal)
      for (const [i, ms] of times.entries()) measured[i].rounds.push(ms)
      plan.onRound?.()
    } finally {
      for (const { mesh, applied } of candidates) {
        applied.dispose()
        bench.scene.remove(mesh)
        ;(mesh.material as MeshPhysicalMaterial).dispose()
      }
    }
  }
  return measured
}

function createCandidates(
  { face, scene, renderer }: Bench,
  benchCase: Case,
  set: WrinkleSet,
  { variants = [...VARIANTS.keys()] }: Plan,
): Candidate[] {
  return [...VARIANTS]
    .filter(([name, variant]) => variants.includes(name) && variant.canShow(benchCase, renderer))
    .map(([name, variant]) => {
      const mesh = createSkin(face)
      mesh.visible = false
      scene.add(mesh)
      giveDistinctProgram(mesh.material as MeshPhysicalMaterial, renderer)
      return { name, mesh, applied: variant.apply(mesh, set, renderer, benchCase) }
    })
}

async function warmUp(bench: Bench, benchCase: Case, candidate: Candidate): Promise<void> {
  drawFrame(bench, benchCase, candidate, 0, bench.timedRenderer.drawPixel)
  // Some programs are compiled asynchronously. The pause lets this happen before frames are timed.
  await new Promise((resolve) => setTimeout(resolve, 5))
}

/** Returns the fraction of pixels that each variant changes, compared with the plain face. Throws if a variant changes too few. */
async function changedFractions(bench: Bench, benchCase: Case, candidates: Candidate[]): Promise<number[]> {
  const pictures = new Map<string, Uint8Array>()
  for (const candidate of candidates) {
    drawFrame(bench, benchCase, candidate, 0)
    pictures.set(candidate.name, await bench.timedRenderer.read())
  }
  const plain = pictures.get('plain')
  if (!plain)
    throw new Error('bench: the variant "plain" is missing; add it, because all others are compared with it')
  checkSame(pictures, benchCase)
  return candidates.map(({ name }) => {
    const changed = changedFraction(pictures.get(name)!, plain)
    const isPlain = name === 'plain' || VARIANTS.get(name)!.sameAs === 'plain'
    if (isPlain || changed >= MIN_CHANGED) return changed
    const text = `changes ${(changed * 100).toFixed(2)}% of the pixels, allowed: at least ${MIN_CHANGED * 100}%`
    throw new Error(`bench: variant "${name}" shows no wrinkles, ${text}; ${JSON.stringify(benchCase)}`)
  })
}

/** Throws if a variant's picture differs from the picture of its `sameAs` variant. */
function checkSame(pictures: ReadonlyMap<string, Uint8Array>, benchCase: Case): void {
  for (const [name, picture] of pictures) {
    const { sameAs } = VARIANTS.get(name)!
    const other = sameAs && pictures.get(sameAs)
    const fraction = other ? differingFraction(picture, other) : 0
    if (fraction <= MAX_FRACTION) continue
    const text = `differ by more than ${MAX_DIFFERENCE} of 255 in ${(fraction * 100).toFixed(4)}% of all channels, allowed: ${MAX_FRACTION * 100}%`
    throw new Error(`bench: variants "${name}" and "${sameAs}" ${text}; ${JSON.stringify(benchCase)}`)
  }
}

function differingFraction(a: Uint8Array, b: Uint8Array): number {
  const count = a.reduce((sum, value, i) => sum + Number(Math.abs(value - b[i]) > MAX_DIFFERENCE), 0)
  return count / a.length
}

/** Measures each variant in several turns. Returns the milliseconds per frame of each variant's fastest turn. */
async function timeInTurns(
  bench: Bench,
  benchCase: Case,
  candidates: readonly Candidate[],
  round: number,
  signal?: AbortSignal,
): Promise<number[]> {
  let index = round
  const time = (candidate: Candidate, count: number) =>
    bench.timedRenderer.time(() => {
      for (let i = 0; i < count; i++) drawFrame(bench, benchCase, candidate, index++)
    })
  const counts: number[] = []
  // This result is discarded, because the first frame also waits for the remaining setup of all variants.
  await time(candidates[0], 1)
  for (const candidate of candidates) {
    const first = await time(candidate, 1)
    counts.push(Math.min(Math.max(Math.ceil(MIN_MS / first), 1), MAX_FRAMES))
  }
  const fastest = candidates.map(() => Number.POSITIVE_INFINITY)
  for (let turn = 0; turn < TURNS; turn++) {
    for (const i of roundOrder(candidates.length, round + turn)) {
      signal?.throwIfAborted()
      fastest[i] = Math.min(fastest[i], (await time(candidates[i], counts[i])) / counts[i])
    }
  }
  return fastest
}

function drawFrame(
  { scene, camera, timedRenderer }: Bench,
  benchCase: Case,
  { mesh, applied }: Candidate,
  index: number,
  draw = timedRenderer.draw,
): void {
  mesh.visible = true
  for (let area = 0; area < benchCase.areas; area++) {
    applied.setActivation(`area${area}`, activationOf(area, index, benchCase))
  }
  draw(scene, camera)
  mesh.visible = false
}
