/** Runs the quick variant of the benchmark in bench/ on the visitor's GPU. */

import { listCases, RENDERER_KINDS } from '../../bench/case.ts'
import { LINE_VARIANTS, toLine } from '../../bench/line.ts'
import { measure } from '../../bench/page/measure.ts'
import { createScene } from '../../bench/page/scene.ts'
import { createTimedRenderer } from '../../bench/page/timed-renderer.ts'
import { type Result, toResults } from '../../bench/report.ts'
import { loadFace } from '../../stage/face.ts'
import type { RendererKind } from '../../stage/stage.ts'
import { browserName } from './browser-name.ts'

/** Canvas size in pixels, typical of a web page. In smaller images, wrinkles have a larger share of the frame time. */
const SIZE = { width: 1280, height: 720 }
/**
 * Number of rounds. Each round compiles the shaders again. Few rounds suffice on a GPU, because its driver compiles a
 * shader to the same code every time. A software rasteriser needs more rounds, because the speed of its code varies.
 */
const ROUNDS = 3

export interface BenchmarkRun {
  results: Result[]
  /** Row that visitors can send in for the table in bench/machines.md. */
  line: string
  /** Reasons why renderers could not be measured. */
  notes: string[]
}

/**
 * Measures each renderer that the browser supports.
 *
 * @param face URL of `faces/human.glb`.
 * @param progress called with the completed fraction, 0..1.
 * @throws Error if no renderer could be measured. Throws the signal's reason if the signal aborts.
 */
export async function runBenchmark(
  face: string,
  progress: (fraction: number) => void,
  signal: AbortSignal,
): Promise<BenchmarkRun> {
  const kinds = RENDERER_KINDS.filter((kind) => kind === 'webgl' || 'gpu' in navigator)
  const results: Result[] = []
  const notes: string[] = []
  for (const [i, kind] of kinds.entries()) {
    const report = (fraction: number) => progress((i + fraction) / kinds.length)
    try {
      results.push(...(await runOn(kind, face, report, signal)))
    } catch (error) {
      signal.throwIfAborted()
      notes.push(`${kind}: ${(error as Error).message}`)
    }
  }
  if (results.length === 0) throw new Error(notes.join('; '))
  return { results, notes, line: toLine(results, { browser: await browserName(), date: new Date() }) }
}

async function runOn(
  renderer: RendererKind,
  url: string,
  report: (fraction: number) => void,
  signal: AbortSignal,
): Promise<Result[]> {
  const { width, height } = SIZE
  const face = await loadFace(url)
  const timedRenderer = await createTimedRenderer(renderer, width, height)
  try {
    const { adapter, timing } = timedRenderer
    const bench = { renderer, timedRenderer, face, ...createScene(face, width / height) }
    const cases = listCases(true)
    const results: Result[] = []
    let done = 0
    const onRound = () => report(++done / (cases.length * ROUNDS))
    const plan = { rounds: ROUNDS, variants: LINE_VARIANTS, onRound, signal }
    for (const benchCase of cases) {
      const measured = await measure(bench, benchCase, plan)
      results.push(...toResults(benchCase, { width, height, renderer, adapter, timing }, measured))
    }
    return results
  } finally {
    timedRenderer.dispose()
  }
}
