import type { Camera, Mesh, MeshPhysicalMaterial, Scene } from 'three'
import type { Face } from '../stage/face.ts'
import { activationOf, type Case, type Plan, type RendererKind } from './case.ts'
import type { Drawer } from './draw.ts'
import type { Measured } from './report.ts'
import { createSet, createSkin } from './scene.ts'
import { turns } from './statistics.ts'
import { VARIANTS, type Worn } from './variant.ts'

/** Least share of pixels that wrinkles must change: a variant that shows none would be fast. */
const LEAST_CHANGED = 0.005
/** What is timed at once: clocks are as coarse as a tenth of a millisecond. */
const LEAST_MS = 20
/** A frame has up to a dozen passes, of which a clock counts some thousand. */
const MOST_FRAMES = 64

export interface Bench {
  renderer: RendererKind
  drawer: Drawer
  face: Face
  scene: Scene
  camera: Camera
}

interface Candidate {
  name: string
  mesh: Mesh
  worn: Worn
  rounds: number[]
}

/**
 * Times every variant that can show a case, in rounds in which they take turns.
 *
 * @throws Error when a variant shows no wrinkles.
 */
export async function measure(bench: Bench, shown: Case, plan: Plan): Promise<Measured[]> {
  const candidates = dress(bench, shown)
  try {
    const changed = await compare(bench, shown, candidates)
    for (let round = 0; round < plan.rounds; round++) {
      for (const i of turns(candidates.length, round)) {
        candidates[i].rounds.push(await time(bench, shown, candidates[i]))
      }
    }
    return candidates.map(({ name, rounds }, i) => ({ variant: name, rounds, changed: changed[i] }))
  } finally {
    for (const { mesh, worn } of candidates) {
      worn.dispose()
      bench.scene.remove(mesh)
      ;(mesh.material as MeshPhysicalMaterial).dispose()
    }
  }
}

function dress({ face, scene, renderer }: Bench, shown: Case): Candidate[] {
  const set = createSet(face, shown.areas, shown.layers)
  return [...VARIANTS]
    .filter(([, variant]) => variant.canShow(shown, renderer))
    .map(([name, variant]) => {
      const mesh = createSkin(face)
      mesh.visible = false
      scene.add(mesh)
      return { name, mesh, worn: variant.wear(mesh, set, renderer), rounds: [] }
    })
}

/** Share of pixels in which each picture differs from the plain face; draws each once, so that it is compiled. */
async function compare(bench: Bench, shown: Case, candidates: Candidate[]): Promise<number[]> {
  const pictures = new Map<string, Uint8Array>()
  for (const candidate of candidates) {
    frame(bench, shown, candidate, 0)
    pictures.set(candidate.name, await bench.drawer.read())
  }
  const plain = pictures.get('plain')
  if (!plain) throw new Error('bench: the variant "plain" is missing; all others are compared to it')
  return candidates.map(({ name }) => {
    const changed = changedShare(pictures.get(name)!, plain)
    if (name === 'plain' || changed >= LEAST_CHANGED) return changed
    const text = `changes ${(changed * 100).toFixed(2)}% of the pixels, allowed: ${LEAST_CHANGED * 100}% or more`
    throw new Error(`bench: variant "${name}" shows no wrinkles, ${text}; ${JSON.stringify(shown)}`)
  })
}

function changedShare(a: Uint8Array, b: Uint8Array): number {
  let changed = 0
  for (let i = 0; i < a.length; i += 4) {
    if (a[i] !== b[i] || a[i + 1] !== b[i + 1] || a[i + 2] !== b[i + 2]) changed++
  }
  return changed / (a.length / 4)
}

/** Milliseconds of a frame, mean of as many as take long enough to be timed well, after one that is not counted. */
async function time(bench: Bench, shown: Case, candidate: Candidate): Promise<number> {
  let at = candidate.rounds.length
  const frames = (count: number) => () => {
    for (let i = 0; i < count; i++) frame(bench, shown, candidate, at++)
  }
  const first = await bench.drawer.time(frames(1))
  const count = Math.min(Math.max(Math.ceil(LEAST_MS / first), 1), MOST_FRAMES)
  return (await bench.drawer.time(frames(count))) / count
}

/** One frame of one variant alone. */
function frame(bench: Bench, shown: Case, { mesh, worn }: Candidate, at: number): void {
  mesh.visible = true
  for (let area = 0; area < shown.areas; area++) {
    worn.setActivation(`area${area}`, activationOf(area, at, shown))
  }
  bench.drawer.draw(bench.scene, bench.camera)
  mesh.visible = false
}
